#include "planner/io/isoxml_reader.h"

#include "planner/core/text_file.h"
#include "planner/geodesy/local_frame.h"
#include "planner/io/file_error.h"
#include "planner/io/geo_ring.h"
#include "planner/io/isoxml_codes.h"
#include "planner/io/isoxml_links.h"
#include "planner/units/angle.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <format>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace furrow {

namespace {

using namespace isoxml;

constexpr int kMostParts = 64;

// A headland polygon whose outer ring has this share of the boundary's area is the strip, not what it encloses.
constexpr double kStripShare = 0.98;

// Two rings that begin within this are the same hole, told twice for different readers.
constexpr double kSamePlaceM = 0.01;

std::string_view attribute(pugi::xml_node node, const char* name) {
    return node.attribute(name).value();
}

/// A plain decimal; no exponent, no comma.
std::optional<double> decimal(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
    return whole ? std::optional{number} : std::nullopt;
}

class FieldReader {
public:
    FieldReader(pugi::xml_node node, const std::string& where) : node_{node} {
        field_.field.id = attribute(node, "A");
        const std::string_view name = attribute(node, "C");
        field_.field.name = name.empty() ? attribute(node, "B") : name;
        if (field_.field.name.empty()) {
            field_.field.name = field_.field.id;
        }
        field_.field.origin = std::format("{}, {}", where, field_.field.id);
        where_ = std::format("{}, field '{}'", where, field_.field.name);
    }

    FieldContent read(std::vector<Note>& notes) {
        readBoundary();
        for (const pugi::xml_node polygon : node_.children("PLN")) {
            readOtherPolygon(polygon);
        }
        for (const pugi::xml_node point : node_.children("PNT")) {
            readPoint(point);
        }
        for (const pugi::xml_node line : node_.children("LSG")) {
            attribute(line, "A") == kGuidanceLine ? readLine(line) : skip("lines that guide nothing");
        }
        // Groups are GGP; files exist that call them otherwise.
        for (const pugi::xml_node group : node_.children()) {
            for (const pugi::xml_node pattern : group.children("GPN")) {
                readPattern(pattern, group);
            }
        }
        dropTwins();
        for (const auto& [what, count] : skipped_) {
            notes.push_back({message("left out: {} {}", count, Message{what}), where_});
        }
        std::ranges::move(notes_, std::back_inserter(notes));
        return std::move(field_);
    }

private:
    void skip(const char* what) { ++skipped_[what]; }
    void tell(Message text) { notes_.push_back({std::move(text), where_}); }

    std::optional<GeoPoint> pointOf(pugi::xml_node node) {
        const auto lat = decimal(attribute(node, "C"));
        const auto lon = decimal(attribute(node, "D"));
        if (!lat || !lon || std::abs(*lat) > 90.0 || std::abs(*lon) > 180.0) {
            tell(message("'{}', '{}' is no latitude and longitude; what it belongs to was left out",
                             attribute(node, "C"), attribute(node, "D")));
            return std::nullopt;
        }
        return GeoPoint{*lon, *lat};
    }

    GeoRing pointsOf(pugi::xml_node line) {
        GeoRing points;
        for (const pugi::xml_node node : line.children("PNT")) {
            const auto point = pointOf(node);
            if (!point) {
                return {};
            }
            points.push_back(*point);
        }
        return points;
    }

    /// Without its first point again at the end, however often it is there.
    GeoRing ringOf(pugi::xml_node line) {
        GeoRing ring = pointsOf(line);
        const bool closed = ring.size() > 1 && ring.front() == ring.back();
        while (ring.size() > 1 && ring.front() == ring.back()) {
            ring.pop_back();
        }
        if (!closed && !ring.empty()) {
            ++openRings_;
        }
        return ring;
    }

    /// A part for each outer ring; holes in the part that they begin in.
    std::vector<GeoPolygon> polygonsOf(pugi::xml_node node) {
        std::vector<GeoPolygon> polygons;
        std::vector<GeoRing> holes;
        for (const pugi::xml_node line : node.children("LSG")) {
            GeoRing ring = ringOf(line);
            if (ring.size() < 3) {
                skip("rings with fewer than three corners");
            } else if (attribute(line, "A") == kInnerRing) {
                holes.push_back(std::move(ring));
            } else {
                polygons.push_back({.outer = std::move(ring), .holes = {}});
            }
        }
        for (GeoRing& hole : holes) {
            const auto around = std::ranges::find_if(
                polygons, [&hole](const GeoPolygon& polygon) { return contains(polygon.outer, hole.front()); });
            if (around != polygons.end()) {
                around->holes.push_back(std::move(hole));
            } else if (!polygons.empty()) {
                polygons.front().holes.push_back(std::move(hole));  // where the check of the field says what is wrong
            }
        }
        return polygons;
    }

    void addBoundaries(pugi::xml_node parent, std::string_view kind) {
        for (const pugi::xml_node polygon : parent.children("PLN")) {
            if (attribute(polygon, "A") == kind) {
                std::ranges::move(polygonsOf(polygon), std::back_inserter(field_.field.parts));
            }
        }
    }

    void readBoundary() {
        addBoundaries(node_, kFieldBoundary);
        if (field_.field.parts.empty()) {
            addBoundaries(node_, kMainField);
        }
        for (const pugi::xml_node group : node_.children("GGP")) {
            if (field_.field.parts.empty()) {
                addBoundaries(group, kFieldBoundary);
                if (!field_.field.parts.empty()) {
                    tell("the boundary is that of the guidance group; the field itself has none");
                }
            }
        }
        if (openRings_ > 0) {
            field_.field.repairs.push_back({.text = counted("{} ring did not end where it began and was closed",
                                                            "{} rings did not end where they began and were closed",
                                                            openRings_),
                                            .where = "the boundary"});
        }
    }

    void readOtherPolygon(pugi::xml_node node) {
        const std::string_view kind = attribute(node, "A");
        constexpr std::array kInTheWay{kWater, kBuilding, kObstacleArea, kWindbreak};
        if (kind == kFieldBoundary || kind == kMainField) {
            return;
        }
        if (kind == kHeadlandArea) {
            addMainland(polygonsOf(node));
            return;
        }
        const bool blocks = std::ranges::any_of(kInTheWay, [kind](const char* other) { return kind == other; });
        if (!blocks && kind != kOtherArea) {
            skip("polygons of a kind that is not used");
            return;
        }
        for (GeoPolygon& outline : polygonsOf(node)) {
            field_.field.obstacles.push_back(
                {.name = std::string{attribute(node, "B")}, .outline = std::move(outline), .passable = !blocks, .buffer = {}});
        }
    }

    void addMainland(std::vector<GeoPolygon> polygons) {
        Area whole;
        for (const GeoPolygon& part : field_.field.parts) {
            whole += geodesicArea({.outer = part.outer, .holes = {}});
        }
        for (GeoPolygon& polygon : polygons) {
            const bool isStrip =
                !polygon.holes.empty() && geodesicArea({.outer = polygon.outer, .holes = {}}) > kStripShare * whole;
            if (!isStrip) {
                field_.mainland.push_back(std::move(polygon));
                continue;
            }
            for (GeoRing& hole : polygon.holes) {
                field_.mainland.push_back({.outer = std::move(hole), .holes = {}});
            }
        }
    }

    void readPoint(pugi::xml_node node) {
        if (attribute(node, "A") != kFieldAccess) {
            skip("points that are no gates");
        } else if (const auto place = pointOf(node)) {
            field_.field.gates.push_back({.name = std::string{attribute(node, "B")}, .position = *place, .width = {}});
        }
    }

    static std::optional<Length> millimetres(std::string_view text) {
        const auto number = decimal(text);
        return number && *number > 0.0 ? std::optional{metres(*number / 1000.0)} : std::nullopt;
    }

    /// Version 3: two points are straight.
    void readLine(pugi::xml_node node) {
        GeoRing points = pointsOf(node);
        if (points.size() < 2) {
            skip("guidance lines without two points");
            return;
        }
        field_.lines.push_back({.kind = points.size() == 2 ? GuidanceKind::AbLine : GuidanceKind::Curve,
                                .name = std::string{attribute(node, "B")},
                                .points = std::move(points),
                                .width = millimetres(attribute(node, "C"))});
    }

    void readPattern(pugi::xml_node pattern, pugi::xml_node group) {
        const std::string_view kind = attribute(pattern, "C");
        const pugi::xml_node line = pattern.child("LSG");
        const GeoRing points = line ? pointsOf(line) : GeoRing{};
        if (points.empty()) {
            skip("guidance patterns without a line");
            return;
        }
        std::string_view name = attribute(pattern, "B");
        name = name.empty() ? attribute(group, "B") : name;
        GuidanceLine read{.name = std::string{name}, .points = points, .width = millimetres(attribute(line, "C")),
                          .repeats = attribute(pattern, "E") != kNone};
        if (const auto heading = decimal(attribute(pattern, "G"))) {
            read.bearing = degrees(*heading);
        }
        if (kind == kAb && points.size() == 2) {
            read.kind = GuidanceKind::AbLine;
        } else if (kind == kAPlus && read.bearing) {
            read.kind = GuidanceKind::APlus;
            read.points.resize(1);
        } else if ((kind == kCurve || kind == kSpiral || kind == kAb || kind == kAPlus) && points.size() >= 2) {
            read.kind = points.size() == 2 && kind != kCurve ? GuidanceKind::AbLine : GuidanceKind::Curve;
        } else if (kind == kPivot && readPivot(pattern, line, read)) {
            read.kind = GuidanceKind::Pivot;
        } else {
            skip("guidance patterns whose points do not fit their kind");
            return;
        }
        field_.lines.push_back(std::move(read));
    }

    /// The centre first, then start and end of an arc, whatever order the file has them in.
    static bool readPivot(pugi::xml_node pattern, pugi::xml_node line, GuidanceLine& read) {
        read.radius = millimetres(attribute(pattern, "H"));
        read.clockwise = attribute(pattern, "D") == kClockwise;
        const auto rank = [](std::string_view kind) { return kind == kCentre ? 0 : kind == kReferenceA ? 1 : 2; };
        std::vector<std::pair<int, GeoPoint>> ranked;
        std::size_t i = 0;
        for (const pugi::xml_node node : line.children("PNT")) {
            ranked.emplace_back(rank(attribute(node, "A")), read.points[i++]);
        }
        std::ranges::stable_sort(ranked, {}, &std::pair<int, GeoPoint>::first);
        read.points.clear();
        for (const auto& [ignored, point] : ranked) {
            read.points.push_back(point);
        }
        if (!read.radius && read.points.size() < 2) {
            return false;
        }
        if (!read.radius) {
            read.radius = metres(roughDistanceM(read.points[0], read.points[1]));
        }
        if (attribute(pattern, "D") == kFullCircle || read.points.size() < 3) {
            read.points.resize(1);
        }
        return true;
    }

    /// Obstacles that say again what a hole says, and those that lie elsewhere.
    void dropTwins() {
        const auto& parts = field_.field.parts;
        std::erase_if(field_.field.obstacles, [&](const Obstacle& obstacle) {
            const GeoPoint begin = obstacle.outline.outer.front();
            const bool twin = std::ranges::any_of(parts, [begin](const GeoPolygon& part) {
                return std::ranges::any_of(part.holes, [begin](const GeoRing& hole) {
                    return std::ranges::any_of(
                        hole, [begin](GeoPoint corner) { return roughDistanceM(corner, begin) < kSamePlaceM; });
                });
            });
            const bool outside = std::ranges::none_of(parts, [&obstacle](const GeoPolygon& part) {
                return std::ranges::any_of(obstacle.outline.outer,
                                           [&part](GeoPoint corner) { return contains(part.outer, corner); });
            });
            if (twin) {
                skip("obstacles that are holes already");
            } else if (outside && !parts.empty()) {
                skip("obstacles outside the boundary");
            }
            return twin || outside;
        });
    }

    pugi::xml_node node_;
    std::string where_;
    FieldContent field_;
    int openRings_ = 0;
    std::map<std::string, int> skipped_;
    std::vector<Note> notes_;
};

Result<std::unique_ptr<pugi::xml_document>> parsed(std::string_view xml, const std::string& where) {
    auto document = std::make_unique<pugi::xml_document>();
    if (const auto result = document->load_buffer(xml.data(), xml.size()); !result) {
        return std::unexpected(readFailed(
            message("{}, {}", where, lineAndColumn(xml, static_cast<std::size_t>(result.offset))),
            "this is not XML from here on", "the file may be cut off or damaged; copy or export it again"));
    }
    return document;
}

}  // namespace

bool looksLikeIsoxml(std::string_view start) {
    return start.contains("<ISO11783_TaskData") || start.contains("<XFC");
}

Result<ImportedFields> readIsoxml(std::string_view xml, const std::string& where, const IsoxmlPart& part,
                                  const JobContext& job) {
    auto main = parsed(xml, where);
    if (!main) {
        return std::unexpected(main.error());
    }
    // Or one of its parts alone.
    const pugi::xml_node whole = (*main)->child("ISO11783_TaskData");
    const pugi::xml_node root = whole ? whole : (*main)->child("XFC");
    if (!root) {
        return std::unexpected(inputRefused(where, "this XML is no task data", "give the file TASKDATA.XML"));
    }
    ImportedFields imported;
    std::vector<std::unique_ptr<pugi::xml_document>> documents;
    std::vector<pugi::xml_node> roots{root};
    int parts = 0;
    for (const pugi::xml_node reference : root.children("XFR")) {
        const std::string name{attribute(reference, "A")};
        if (!name.starts_with("PFD")) {
            continue;  // only these hold fields
        }
        if (++parts > kMostParts) {
            return std::unexpected(inputRefused(where, message("it has more than {} parts", kMostParts),
                                                "export fewer fields at once"));
        }
        const auto text = part(name);
        auto document = text ? parsed(*text, name) : std::unexpected(text.error());
        if (!document) {
            imported.notes.push_back({message("the part {} is left out: {}", name, document.error().what), where});
            continue;
        }
        roots.push_back((*document)->child("XFC"));
        documents.push_back(*std::move(document));
    }
    for (const pugi::xml_node from : roots) {
        for (const pugi::xml_node node : from.children("PFD")) {
            if (job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            FieldReader reader{node, where};
            FieldContent content = reader.read(imported.notes);
            if (!content.field.parts.empty()) {
                imported.fields.push_back(std::move(content));
                continue;
            }
            imported.notes.push_back({message("the field '{}' has no boundary", content.field.name), where});
            std::ranges::move(content.lines, std::back_inserter(imported.looseLines));
        }
    }
    if (imported.fields.empty() && imported.looseLines.empty()) {
        const bool named = std::ranges::any_of(
            roots, [](pugi::xml_node from) { return !from.child("PFD").empty(); });
        return std::unexpected(inputRefused(
            where,
            named ? "the fields in this task data have neither boundary nor guidance line"
                  : "there is no field in this task data",
            "export the field with its boundary; furrow-cli compare reads what a machine recorded"));
    }
    return imported;
}

Result<ImportedFields> readIsoxmlFolder(const FileFolder& folder, const FileFolder::Entry& main,
                                        const JobContext& job) {
    const auto text = folder.read(main);
    if (!text) {
        return std::unexpected(text.error());
    }
    const auto part = [&](const std::string& name) -> Result<std::string> {
        const FileFolder::Entry* entry = folder.find(main.folder, name + ".xml");
        if (entry == nullptr) {
            return std::unexpected(readFailed(name, "its file is missing", "copy the whole folder"));
        }
        return folder.read(*entry);
    };
    auto read = readIsoxml(*text, folder.placeOf(main), part, job);
    if (const FileFolder::Entry* list = read ? folder.find(main.folder, "linklist.xml") : nullptr) {
        // What a field is known by elsewhere, kept for the next export.
        const auto links = isoxmlLinks(folder.read(*list).value_or(""));
        for (FieldContent& content : read->fields) {
            const auto link = links.find(content.field.id);
            content.field.id = link == links.end() ? content.field.id : link->second;
        }
    }
    return read;
}

}  // namespace furrow
