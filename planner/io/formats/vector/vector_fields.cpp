#include "planner/io/formats/vector/vector_fields.h"

#include "planner/core/file_error.h"
#include "planner/core/text.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/obstacle_shapes.h"
#include "planner/io/content/vector_attributes.h"
#include "planner/io/formats/csv/table_fields.h"
#include "planner/io/formats/vector/ring_closing.h"
#include "planner/io/formats/vector/vector_file.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <limits>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

// Of a written plan's features; a file of others may use the attribute for something else.
constexpr std::string_view kKinds[] = {
    "field",  "obstacle", "gate",     "headland",        "mainland", "cell", "headland_pass", "swath", "path",
    "missed", "finding",  "guidance", "left_on_purpose", "overhung", "hole", "refill_point"};

// Of a drawing's layers, in capitals or not.
constexpr std::pair<std::string_view, std::string_view> kDrawingLayers[] = {
    {"boundary", "field"},    {"field", "field"},    {"hole", "hole"}, {"obstacle", "obstacle"},
    {"headland", "mainland"}, {"swath", "guidance"}, {"path", "path"}};

/// A length attribute of an obstacle or gate, 0 where there is none.
Result<Length> lengthIn(const VectorFeature& feature, AttributeName name, const std::string& where) {
    const std::string& text = attribute(feature, name);
    if (text.empty()) {
        return metres(0.0);
    }
    const std::optional<double> number = numberIn(text, true);
    if (!number || !std::isfinite(*number) || *number < 0.0) {
        return std::unexpected(inputRefused(message("{}, {}", where, name.text()),
                                            message("'{}' is no length", text), "give metres, 0 or more"));
    }
    return metres(*number);
}

bool touches(const FieldSource& field, const GeoPolygon& outline) {
    return std::ranges::any_of(
        field.parts, [&outline](const GeoPolygon& part) { return meet(part.outer, outline.outer); });
}

/// In degrees of latitude: good enough to tell which of two fields a gate belongs to.
double distanceDeg(const FieldSource& field, GeoPoint point) {
    const double lonScale = std::cos(point.latDeg * std::numbers::pi / 180.0);
    double nearest = std::numeric_limits<double>::infinity();
    const auto visit = [&](const GeoRing& ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const auto relative = [&](GeoPoint p) {
                return std::pair{std::remainder(p.lonDeg - point.lonDeg, 360.0) * lonScale,
                                 p.latDeg - point.latDeg};
            };
            const auto [ax, ay] = relative(ring[j]);
            const auto [bx, by] = relative(ring[i]);
            const double squared = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
            const double along =
                squared > 0.0 ? std::clamp(-(ax * (bx - ax) + ay * (by - ay)) / squared, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, std::hypot(ax + along * (bx - ax), ay + along * (by - ay)));
        }
    };
    for (const GeoPolygon& part : field.parts) {
        visit(part.outer);
        std::ranges::for_each(part.holes, visit);
    }
    return nearest;
}

/// One is never left out: what cannot be read is refused.
Result<void> addObstacle(const VectorFeature& feature, std::vector<FieldContent>& fields,
                         const std::string& file, const JobContext& job) {
    const std::string name = nameOf(feature);
    const Message where = message("{}, obstacle {}", file, name);
    const Result<Length> buffer = lengthIn(feature, "buffer_m", where);
    if (!buffer) {
        return std::unexpected(buffer.error());
    }
    const Result<Length> overhang = lengthIn(feature, "overhang_m", where);
    if (!overhang) {
        return std::unexpected(overhang.error());
    }
    if (!feature.hasGeometry()) {
        return std::unexpected(inputRefused(where, "it has no shape", "draw it, or remove it from the file"));
    }
    const auto around = outlinesAround(feature.points, feature.openLines, *buffer, where, job);
    if (!around) {
        return std::unexpected(around.error());
    }
    const std::string& passable = attribute(feature, "passable");
    std::optional<Note> note =
        noteOfOpenRings(feature, name.empty() ? Message{"an obstacle"} : message("obstacle '{}'", name));
    const auto add = [&](const GeoPolygon& outline, Length outlineBuffer) -> Result<void> {
        auto owner = std::ranges::find_if(
            fields, [&](const FieldContent& content) { return touches(content.field, outline); });
        if (owner == fields.end() && fields.size() > 1) {
            return std::unexpected(inputRefused(where,
                                                message("it lies in none of the {} fields", fields.size()),
                                                "remove it from the file, or add its field"));
        }
        if (owner == fields.end()) {
            owner = fields.begin();  // where the check of the field says what is wrong with it
        }
        owner->field.obstacles.push_back(
            {.name = name,
             .outline = outline,
             .passable = passable == "1" || passable == "true" || passable == "yes",
             .buffer = outlineBuffer,
             .overhang = *overhang});
        if (note) {
            owner->field.repairs.push_back(*std::exchange(note, std::nullopt));
        }
        return {};
    };
    Result<void> added;
    for (std::size_t i = 0; added && i < feature.polygons.size(); ++i) {
        added = add(feature.polygons[i], *buffer);
    }
    for (std::size_t i = 0; added && i < around->size(); ++i) {
        added = add((*around)[i], metres(0.0));
    }
    return added;
}

Result<void> addGate(const VectorFeature& feature, std::vector<FieldContent>& fields,
                     const std::string& file) {
    const std::string name = nameOf(feature);
    const Result<Length> width = lengthIn(feature, "width_m", message("{}, gate {}", file, name));
    if (!width) {
        return std::unexpected(width.error());
    }
    for (const GeoPoint& position : feature.points) {
        const auto owner = std::ranges::min_element(fields, {}, [position](const FieldContent& content) {
            return distanceDeg(content.field, position);
        });
        owner->field.gates.push_back({.name = name, .position = position, .width = *width});
    }
    return {};
}

Result<FieldSource> fieldFrom(VectorFeature& feature, const std::string& file) {
    FieldSource field;
    field.id = idOf(feature);
    field.name = nameOf(feature);
    const Result<Length> accuracy = lengthIn(feature, "boundary_accuracy_m", file);
    if (!accuracy) {
        return std::unexpected(accuracy.error());
    }
    field.boundaryAccuracy = *accuracy;
    if (auto note = noteOfOpenRings(feature, "the boundary")) {
        field.repairs.push_back(*std::move(note));
    }
    field.parts = std::move(feature.polygons);
    return field;
}

Error noPolygon(const VectorFile& file, const std::string& name) {
    std::size_t points = 0;
    std::size_t lines = 0;
    for (const VectorFeature& feature : file.features) {
        points += feature.points.size();
        lines += feature.openLines.size();
    }
    Message found;
    if (points > 0) {
        found = counted("{} point", "{} points", points);
    }
    if (lines > 0) {
        const Message open = counted("{} open line", "{} open lines", lines);
        found = found.empty() ? open : message("{} and {}", found, open);
    }
    if (found.empty() && !file.features.empty()) {
        found = counted("{} entry without a shape", "{} entries without a shape", file.features.size());
    }
    return inputRefused(name,
                        found.empty() ? Message{"there is no field boundary in it"}
                                      : message("there is no field boundary in it, only {}", found),
                        "export the boundary as a polygon");
}

// --- Lines and what else belongs to a field ---------------------------------------------------------------

/// The field in which most of this lies, or that is nearest.
FieldContent& ownerOf(std::vector<FieldContent>& fields, GeoPoint place) {
    return *std::ranges::min_element(fields, {}, [place](const FieldContent& content) {
        const bool inside = std::ranges::any_of(
            content.field.parts, [place](const GeoPolygon& part) { return contains(part.outer, place); });
        return inside ? -1.0 : distanceDeg(content.field, place);
    });
}

GuidanceLine guidanceOf(const VectorFeature& feature, GeoRing points) {
    const std::string& kind = attribute(feature, "guidance");
    GuidanceLine line{.kind = points.size() == 2 ? GuidanceKind::AbLine : GuidanceKind::Curve,
                      .name = nameOf(feature),
                      .points = std::move(points)};
    if (const auto width = numberIn(attribute(feature, "width_m"), true);
        width && *width > 0.0 && std::isfinite(*width)) {
        line.width = metres(*width);
    }
    const auto bearing = numberIn(attribute(feature, "bearing"), true);
    if (kind == guidanceKindId(GuidanceKind::APlus) && bearing && std::isfinite(*bearing)) {
        line.kind = GuidanceKind::APlus;
        line.bearing = degrees(*bearing);
        line.points.resize(1);
    }
    return line;
}

/// All lines of a feature, closed ones with their first point again.
std::vector<GeoRing> linesOf(VectorFeature& feature) {
    std::vector<GeoRing> lines = std::move(feature.openLines);
    for (GeoRing& closed : feature.closedLines) {
        closed.push_back(closed.front());
        lines.push_back(std::move(closed));
    }
    return lines;
}

/// All lines of a file, whatever they are for.
std::vector<GuidanceLine> guidanceIn(VectorFile& file) {
    std::vector<GuidanceLine> lines;
    for (VectorFeature& feature : file.features) {
        for (GeoRing& line : linesOf(feature)) {
            if (line.size() >= 2) {
                lines.push_back(guidanceOf(feature, std::move(line)));
            }
        }
    }
    return lines;
}

Result<void> addHole(VectorFeature& feature, std::vector<FieldContent>& fields, const std::string& file) {
    if (!feature.openLines.empty() || !feature.points.empty() || !feature.hasGeometry()) {
        return std::unexpected(inputRefused(message("{}, hole {}", file, nameOf(feature)),
                                            "it is no closed line",
                                            "draw it as an area, or remove it from the file"));
    }
    const auto add = [&fields](GeoRing& ring) {
        std::vector<GeoPolygon>& parts = ownerOf(fields, ring.front()).field.parts;
        const auto around =
            std::ranges::find_if(parts, [&ring](const GeoPolygon& part) { return meet(part.outer, ring); });
        // In none of them the check of the field says what is wrong with it.
        (around == parts.end() ? parts.front() : *around).holes.push_back(std::move(ring));
    };
    std::ranges::for_each(feature.closedLines, add);
    for (GeoPolygon& polygon : feature.polygons) {
        add(polygon.outer);
    }
    return {};
}

std::string kindOf(const VectorFeature& feature, bool isPlan) {
    const std::string& kind = attribute(feature, "kind");
    if (isPlan || std::ranges::contains(kKinds, kind)) {
        return kind;
    }
    const std::string layer = inSmallLetters(attribute(feature, "layer"));
    const auto known =
        std::ranges::find(kDrawingLayers, layer, &std::pair<std::string_view, std::string_view>::first);
    return known == std::end(kDrawingLayers) ? std::string{} : std::string{known->second};
}

void nameFields(std::vector<FieldContent>& fields, const std::string& name) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        FieldSource& field = fields[i].field;
        field.origin = fields.size() == 1 ? name : std::format("{}, feature {}", name, i + 1);
        if (field.id.empty()) {
            field.id = std::to_string(i + 1);
        }
        if (field.name.empty()) {
            field.name = field.id;
        }
    }
}

Result<void> addBelongings(VectorFeature& feature, const std::string& kind, ImportedFields& imported,
                           const std::string& name, const JobContext& job) {
    if (kind == "obstacle") {
        closeLines(feature);
        return addObstacle(feature, imported.fields, name, job);
    }
    if (kind == "gate") {
        return addGate(feature, imported.fields, name);
    }
    if (kind == "hole") {
        return addHole(feature, imported.fields, name);
    }
    if (kind == "mainland") {
        closeLines(feature);
        for (GeoPolygon& polygon : feature.polygons) {
            ownerOf(imported.fields, polygon.outer.front()).mainland.push_back(std::move(polygon));
        }
    } else if (kind.empty() || kind == "guidance" || kind == "swath") {
        for (GeoRing& line : linesOf(feature)) {
            const GeoPoint middle = line[line.size() / 2];
            if (line.size() >= 2) {
                ownerOf(imported.fields, middle).lines.push_back(guidanceOf(feature, std::move(line)));
            }
        }
    }
    return {};
}

/// An area that is neither field nor anything else that is known may be in the way: where a file says of each
/// thing what it is, that is refused. A project keeps what others put into it; a drawing holds much else.
Result<void> checkAreasAreKnown(std::span<const VectorFeature> features, std::span<const std::string> kinds,
                                bool isPlan, const std::filesystem::path& path, std::vector<Note>& notes) {
    const std::string name = path.filename().string();
    const bool isProject = path.extension() == ".furrow";
    std::size_t unknown = 0;
    std::optional<GeoPoint> first;
    for (std::size_t i = 0; i < features.size(); ++i) {
        const VectorFeature& feature = features[i];
        const bool isArea = !feature.polygons.empty() || (!isPlan && !feature.closedLines.empty());
        if (!isArea || std::ranges::contains(kKinds, kinds[i])) {
            continue;
        }
        const GeoRing& ring =
            feature.polygons.empty() ? feature.closedLines.front() : feature.polygons.front().outer;
        if (isPlan && !isProject) {
            Error error = inputRefused(message("{}, {}", name, message("feature {}", i + 1)),
                                       kinds[i].empty() ? Message{"it does not say what it is"}
                                                        : message("its kind '{}' is not known", kinds[i]),
                                       "give it a kind, or remove it from the file");
            error.place = ring.front();
            return std::unexpected(std::move(error));
        }
        first = unknown++ == 0 ? std::optional{ring.front()} : first;
    }
    if (unknown > 0) {
        notes.push_back(
            {counted("{} area is neither field, hole nor obstacle by its layer or kind and was not used",
                     "{} areas are neither field, hole nor obstacle by their layer or kind and were not used",
                     unknown),
             name, first});
    }
    return {};
}

/// What each feature of a file is.
struct FeatureKinds {
    std::vector<std::string> kinds;
    bool isPlan = false;     ///< the file says of each thing what it is, as a written plan does
    bool isDrawing = false;  ///< its layers say so

    bool isField(std::size_t i) const {
        return kinds[i] == "field" || (kinds[i].empty() && !isPlan && !isDrawing);
    }
};

FeatureKinds kindsOf(const VectorFile& file) {
    FeatureKinds all;
    all.isPlan = std::ranges::any_of(
        file.features, [](const VectorFeature& feature) { return attribute(feature, "kind") == "field"; });
    for (const VectorFeature& feature : file.features) {
        all.kinds.push_back(kindOf(feature, all.isPlan));
    }
    all.isDrawing = std::ranges::contains(all.kinds, "field") && !all.isPlan;
    return all;
}

/// Takes the fields from a file's features; the numbers of those that are none.
Result<std::vector<std::size_t>> takeFields(VectorFile& file, const FeatureKinds& kinds,
                                            const std::string& name, ImportedFields& imported,
                                            const JobContext& job) {
    // A guidance line may be closed, too: lines count only where nothing better is in the file.
    bool hasPolygon = false;
    bool hasClosedLine = false;
    for (std::size_t i = 0; i < file.features.size(); ++i) {
        hasPolygon = hasPolygon || (kinds.isField(i) && !file.features[i].polygons.empty());
        hasClosedLine = hasClosedLine || (kinds.isField(i) && !file.features[i].closedLines.empty());
    }
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < file.features.size(); ++i) {
        VectorFeature& feature = file.features[i];
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (kinds.isField(i) && (!hasPolygon || kinds.isDrawing)) {
            closeLines(feature);
            if (file.isTrack && !hasClosedLine) {
                closeTracks(feature, imported.notes, name);
            }
        }
        if (!kinds.isField(i) || feature.polygons.empty()) {
            others.push_back(i);
            continue;
        }
        Result<FieldSource> field = fieldFrom(feature, name);
        if (!field) {
            return std::unexpected(field.error());
        }
        imported.fields.push_back({.field = *std::move(field)});
    }
    return others;
}

}  // namespace

Result<ImportedFields> vectorFields(const std::filesystem::path& path, const JobContext& job) {
    Result<VectorFile> file = readVectorFile(path, attributeNames(), job);
    if (!file) {
        return std::unexpected(file.error());
    }
    const std::string name = path.filename().string();
    if (file->isTable) {
        if (auto read = readTable(*file, name); !read) {
            return std::unexpected(read.error());
        }
    }
    const FeatureKinds kinds = kindsOf(*file);
    ImportedFields imported;
    if (kinds.isPlan || kinds.isDrawing) {
        if (auto known = checkAreasAreKnown(file->features, kinds.kinds, kinds.isPlan, path, imported.notes);
            !known) {
            return std::unexpected(known.error());
        }
    }
    const auto others = takeFields(*file, kinds, name, imported, job);
    if (!others) {
        return std::unexpected(others.error());
    }
    if (imported.fields.empty() && !file->isTrack) {
        imported.looseLines = guidanceIn(*file);
    }
    if (imported.fields.empty() && imported.looseLines.empty()) {
        return std::unexpected(noPolygon(*file, name));
    }
    if (imported.fields.empty()) {
        return imported;
    }
    nameFields(imported.fields, name);
    for (const std::size_t i : *others) {
        if (auto added = addBelongings(file->features[i], kinds.kinds[i], imported, name, job); !added) {
            return std::unexpected(added.error());
        }
    }
    return imported;
}

Recognition recogniseVector(const ChosenFile& chosen) {
    return chosen.isFolder() ? Recognition::No : Recognition::Perhaps;
}

Result<ImportedFields> readVectorFields(const ChosenFile& chosen, const JobContext& job) {
    return vectorFields(chosen.path(), job);
}

Result<std::vector<GuidanceLine>> vectorLines(const std::filesystem::path& path, const JobContext& job) {
    Result<VectorFile> file = readVectorFile(path, attributeNames(), job);
    if (!file) {
        return std::unexpected(file.error());
    }
    return guidanceIn(*file);
}

}  // namespace furrow
