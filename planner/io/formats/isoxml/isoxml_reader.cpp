#include "planner/io/formats/isoxml/isoxml_reader.h"

#include "planner/core/file_error.h"
#include "planner/core/text_file.h"
#include "planner/geodesy/local_frame.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/obstacle_shapes.h"
#include "planner/io/formats/isoxml/isoxml_codes.h"
#include "planner/io/formats/isoxml/isoxml_values.h"
#include "planner/units/angle.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
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

// A headland polygon whose outer ring has this share of the boundary's area is the strip, not what it
// encloses.
constexpr double kStripShare = 0.98;

constexpr const char* kCorrectIt = "correct it, or remove the hole or obstacle from the file";

// Two rings that begin within this are the same hole, told twice for different readers.
constexpr double kSamePlaceM = 0.01;
// And the hole takes no less than this of what the obstacle does.
constexpr double kSameArea = 0.999;

class PartfieldReader {
public:
    PartfieldReader(pugi::xml_node node, const std::string& where) : node_{node} {
        field_.field.id = attribute(node, "A");
        const std::string_view name = attribute(node, "C");
        field_.field.name = name.empty() ? attribute(node, "B") : name;
        if (field_.field.name.empty()) {
            field_.field.name = field_.field.id;
        }
        field_.field.origin = std::format("{}, {}", where, field_.field.id);
        where_ = std::format("{}, field '{}'", where, field_.field.name);
    }

    /// InputRefused: something in the way that cannot be read; it is never left out.
    Result<FieldContent> read(std::vector<Note>& notes, const JobContext& job) {
        readBoundary();
        for (const pugi::xml_node polygon : node_.children("PLN")) {
            readOtherPolygon(polygon);
        }
        for (const pugi::xml_node point : node_.children("PNT")) {
            readPoint(point, job);
        }
        for (const pugi::xml_node line : node_.children("LSG")) {
            const std::string_view kind = attribute(line, "A");
            kind == kGuidanceLine   ? readLine(line)
            : kind == kObstacleLine ? readObstacleLine(line, job)
                                    : skip("lines that guide nothing");
        }
        if (refusal_) {
            return std::unexpected(*refusal_);
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

    void refuse(Message what, Message remedy) {
        refusal_ =
            refusal_ ? refusal_ : std::optional{inputRefused(where_, std::move(what), std::move(remedy))};
    }

    std::optional<GeoPoint> pointOf(pugi::xml_node node) {
        const auto lat = plainDecimalIn(attribute(node, "C"));
        const auto lon = plainDecimalIn(attribute(node, "D"));
        if (!lat || !lon || std::abs(*lat) > 90.0 || std::abs(*lon) > 180.0) {
            badPlace_ = message("'{}', '{}' is no latitude and longitude", attribute(node, "C"),
                                attribute(node, "D"));
            tell(message("{}; what it belongs to was left out", badPlace_));
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

    /// Outer rings as parts without holes, and inner ones.
    struct Rings {
        std::vector<GeoPolygon> polygons;
        std::vector<GeoRing> holes;
    };

    void addRings(pugi::xml_node node, bool isInTheWay, Rings& rings) {
        for (const pugi::xml_node line : node.children("LSG")) {
            const bool isHole = attribute(line, "A") == kInnerRing;
            badPlace_ = {};
            GeoRing ring = ringOf(line);
            if (!badPlace_.empty() && (isHole || isInTheWay)) {
                refuse(badPlace_, kCorrectIt);
            }
            if (ring.size() < 3) {
                skip("rings with fewer than three corners");
            } else if (isHole) {
                rings.holes.push_back(std::move(ring));
            } else {
                rings.polygons.push_back({.outer = std::move(ring), .holes = {}});
            }
        }
    }

    /// A part for each outer ring; holes in the part that they begin in.
    static std::vector<GeoPolygon> joined(Rings rings) {
        for (GeoRing& hole : rings.holes) {
            const auto around = std::ranges::find_if(rings.polygons, [&hole](const GeoPolygon& polygon) {
                return contains(polygon.outer, hole.front());
            });
            if (around != rings.polygons.end()) {
                around->holes.push_back(std::move(hole));
            } else if (!rings.polygons.empty()) {
                rings.polygons.front().holes.push_back(
                    std::move(hole));  // where the check of the field says what is wrong
            }
        }
        return std::move(rings.polygons);
    }

    std::vector<GeoPolygon> polygonsOf(pugi::xml_node node, bool isInTheWay) {
        Rings rings;
        addRings(node, isInTheWay, rings);
        return joined(std::move(rings));
    }

    /// Machines write holes into polygons of their own, beside the one with the outer ring.
    void addBoundaries(pugi::xml_node parent, std::string_view kind) {
        for (const pugi::xml_node polygon : parent.children("PLN")) {
            if (attribute(polygon, "A") == kind) {
                addRings(polygon, false, boundary_);
            }
        }
        if (!boundary_.polygons.empty()) {
            field_.field.parts = joined(std::exchange(boundary_, {}));
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
            field_.field.repairs.push_back(
                {.text = counted("{} ring did not end where it began and was closed",
                                 "{} rings did not end where they began and were closed", openRings_),
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
            addMainland(polygonsOf(node, false));
            return;
        }
        const bool blocks =
            std::ranges::any_of(kInTheWay, [kind](const char* other) { return kind == other; });
        if (!blocks && kind != kOtherArea && kind != kRoad) {
            skip("polygons of a kind that is not used");
            return;
        }
        for (GeoPolygon& outline : polygonsOf(node, true)) {
            field_.field.obstacles.push_back({.name = std::string{attribute(node, "B")},
                                              .outline = std::move(outline),
                                              .passable = !blocks,
                                              .buffer = {}});
        }
    }

    void addMainland(std::vector<GeoPolygon> polygons) {
        Area whole;
        for (const GeoPolygon& part : field_.field.parts) {
            whole += geodesicArea({.outer = part.outer, .holes = {}});
        }
        for (GeoPolygon& polygon : polygons) {
            const bool isStrip = !polygon.holes.empty() &&
                                 geodesicArea({.outer = polygon.outer, .holes = {}}) > kStripShare * whole;
            if (!isStrip) {
                field_.mainland.push_back(std::move(polygon));
                continue;
            }
            for (GeoRing& hole : polygon.holes) {
                field_.mainland.push_back({.outer = std::move(hole), .holes = {}});
            }
        }
    }

    void addAround(std::span<const GeoPoint> points, std::span<const GeoRing> lines, Length buffer,
                   pugi::xml_node node, const JobContext& job) {
        const std::string name{attribute(node, "B")};
        auto outlines = outlinesAround(points, lines, buffer, message("{}, obstacle {}", where_, name), job);
        if (!outlines) {
            refusal_ = refusal_ ? refusal_ : std::optional{outlines.error()};
            return;
        }
        for (GeoPolygon& outline : *outlines) {
            field_.field.obstacles.push_back({.name = name, .outline = std::move(outline)});
        }
    }

    /// As wide as the line string says.
    void readObstacleLine(pugi::xml_node node, const JobContext& job) {
        const GeoRing points = pointsOf(node);
        if (points.empty()) {
            refuse(badPlace_.empty() ? Message{"an obstacle has no shape"} : badPlace_, kCorrectIt);
        } else {
            addAround({}, {&points, 1}, 0.5 * millimetres(attribute(node, "C")).value_or(Length{}), node,
                      job);
        }
    }

    void readPoint(pugi::xml_node node, const JobContext& job) {
        if (attribute(node, "A") == kObstaclePoint) {
            if (const auto place = pointOf(node)) {
                addAround({&*place, 1}, {}, {}, node, job);
            } else {
                refuse(badPlace_, kCorrectIt);
            }
        } else if (attribute(node, "A") != kFieldAccess) {
            skip("points that are no gates");
        } else if (const auto place = pointOf(node)) {
            field_.field.gates.push_back(
                {.name = std::string{attribute(node, "B")}, .position = *place, .width = {}});
        }
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
        GuidanceLine read{.name = std::string{name},
                          .points = points,
                          .width = millimetres(attribute(line, "C")),
                          .repeats = attribute(pattern, "E") != kNone};
        if (const auto heading = plainDecimalIn(attribute(pattern, "G"))) {
            read.bearing = degrees(*heading);
        }
        if (kind == kAb && points.size() == 2) {
            read.kind = GuidanceKind::AbLine;
        } else if (kind == kAPlus && read.bearing) {
            read.kind = GuidanceKind::APlus;
            read.points.resize(1);
        } else if ((kind == kCurve || kind == kSpiral || kind == kAb || kind == kAPlus) &&
                   points.size() >= 2) {
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
        const auto rank = [](std::string_view kind) {
            return kind == kCentre ? 0 : kind == kReferenceA ? 1 : 2;
        };
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
            const Area size = geodesicArea({.outer = obstacle.outline.outer, .holes = {}});
            const bool twin = std::ranges::any_of(parts, [begin, size](const GeoPolygon& part) {
                return std::ranges::any_of(part.holes, [begin, size](const GeoRing& hole) {
                    const double ratio = geodesicArea({.outer = hole, .holes = {}}) / size;
                    return ratio > kSameArea && std::ranges::any_of(hole, [begin](GeoPoint corner) {
                               return roughDistanceM(corner, begin) < kSamePlaceM;
                           });
                });
            });
            const bool outside = std::ranges::none_of(parts, [&obstacle](const GeoPolygon& part) {
                return meet(part.outer, obstacle.outline.outer);
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
    Rings boundary_;  ///< not in the field yet
    std::optional<Error> refusal_;
    Message badPlace_;  ///< the last one that was none
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

using Documents = std::vector<std::unique_ptr<pugi::xml_document>>;

/// The files that task data refers to, those with fields.
Result<Documents> partsOf(pugi::xml_node root, const std::string& where, const IsoxmlPart& part,
                          std::vector<Note>& notes) {
    Documents documents;
    int parts = 0;
    for (const pugi::xml_node reference : root.children("XFR")) {
        const std::string name{attribute(reference, "A")};
        if (!name.starts_with("PFD")) {
            continue;
        }
        if (++parts > kMostParts) {
            return std::unexpected(inputRefused(where, message("it has more than {} parts", kMostParts),
                                                "export fewer fields at once"));
        }
        const auto text = part(name);
        auto document = text ? parsed(*text, name) : std::unexpected(text.error());
        if (document) {
            documents.push_back(*std::move(document));
        } else {
            notes.push_back({message("the part {} is left out: {}", name, document.error().what), where});
        }
    }
    return documents;
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
    const auto documents = partsOf(root, where, part, imported.notes);
    if (!documents) {
        return std::unexpected(documents.error());
    }
    std::vector<pugi::xml_node> roots{root};
    for (const auto& document : *documents) {
        roots.push_back(document->child("XFC"));
    }
    for (const pugi::xml_node from : roots) {
        for (const pugi::xml_node node : from.children("PFD")) {
            if (job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            PartfieldReader reader{node, where};
            auto content = reader.read(imported.notes, job);
            if (!content) {
                return std::unexpected(content.error());
            }
            if (!content->field.parts.empty()) {
                imported.fields.push_back(*std::move(content));
                continue;
            }
            imported.notes.push_back({message("the field '{}' has no boundary", content->field.name), where});
            std::ranges::move(content->lines, std::back_inserter(imported.looseLines));
        }
    }
    if (imported.fields.empty() && imported.looseLines.empty()) {
        const bool named =
            std::ranges::any_of(roots, [](pugi::xml_node from) { return !from.child("PFD").empty(); });
        return std::unexpected(inputRefused(
            where,
            named ? "the fields in this task data have neither boundary nor guidance line"
                  : "there is no field in this task data",
            "export the field with its boundary; furrow-cli compare reads what a machine recorded"));
    }
    return imported;
}

}  // namespace furrow
