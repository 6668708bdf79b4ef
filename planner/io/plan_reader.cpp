#include "planner/io/plan_reader.h"

#include "planner/field/field.h"
#include "planner/io/boundary_import.h"
#include "planner/machine/machine_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <format>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// What nine decimals of a degree leave open.
constexpr Length kGeoJsonRounding = metres(1e-4);

Error refused(const std::string& where, std::string what) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = where,
            .remedy = "write the plan again with furrow-cli plan"};
}

Result<std::string> textOf(const fs::path& path) {
    std::ifstream file{path, std::ios::binary};
    std::string text{std::istreambuf_iterator<char>{file}, {}};
    if (!file.is_open() || file.bad()) {
        return std::unexpected(Error{.code = ErrorCode::ReadFailed,
                                     .what = "the file could not be read",
                                     .where = path.string(),
                                     .remedy = "name the folder of a plan, or its plan.geojson"});
    }
    return text;
}

Result<Json> jsonOf(const fs::path& path) {
    const auto text = textOf(path);
    if (!text) {
        return std::unexpected(text.error());
    }
    try {
        return Json::parse(*text);
    } catch (const Json::parse_error& error) {
        return std::unexpected(refused(path.string(), std::format("it is not JSON (byte {})", error.byte)));
    }
}

std::optional<SegmentKind> segmentKindFrom(std::string_view id) {
    for (const SegmentKind kind : {SegmentKind::Swath, SegmentKind::Turn, SegmentKind::HeadlandPass,
                                   SegmentKind::Transfer, SegmentKind::Refill, SegmentKind::Wait}) {
        if (segmentKindId(kind) == id) {
            return kind;
        }
    }
    return std::nullopt;
}

/// "+proj=tmerc +lat_0=51.3 +lon_0=9.2 ..."
std::optional<LocalFrame> frameFrom(std::string_view proj) {
    const auto number = [proj](std::string_view key) -> std::optional<double> {
        const std::size_t at = proj.find(key);
        double value = 0.0;
        if (at == std::string_view::npos) {
            return std::nullopt;
        }
        const char* begin = proj.data() + at + key.size();
        return std::from_chars(begin, proj.data() + proj.size(), value).ec == std::errc{}
                   ? std::optional{value}
                   : std::nullopt;
    };
    const auto latitude = number("+lat_0=");
    const auto longitude = number("+lon_0=");
    if (!latitude || !longitude) {
        return std::nullopt;
    }
    const auto frame = LocalFrame::centredOn({.lonDeg = *longitude, .latDeg = *latitude});
    return frame ? std::optional{*frame} : std::nullopt;
}

MultiPolygon inFrame(const MultiPolygon& polygons, const LocalFrame& from, const LocalFrame& to) {
    if (from == to) {
        return polygons;
    }
    MultiPolygon moved;
    for (const Polygon& polygon : polygons) {
        moved.push_back(to.toLocal(from.toGeo(polygon)));
    }
    return moved;
}

GeoRing pointsOf(const Json& coordinates) {
    GeoRing points;
    for (const Json& position : coordinates) {
        points.push_back({position.at(0).get<double>(), position.at(1).get<double>()});
    }
    return points;
}

GeoPolygon polygonOf(const Json& rings) {
    GeoPolygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        GeoRing ring = pointsOf(rings[i]);
        if (ring.size() > 1 && ring.front() == ring.back()) {
            ring.pop_back();
        }
        if (i == 0) {
            polygon.outer = std::move(ring);
        } else {
            polygon.holes.push_back(std::move(ring));
        }
    }
    return polygon;
}

MultiPolygon polygonsOf(const Json& geometry, const LocalFrame& frame) {
    MultiPolygon polygons;
    const Json& coordinates = geometry.at("coordinates");
    if (geometry.at("type") == "Polygon") {
        polygons.push_back(frame.toLocal(polygonOf(coordinates)));
    } else {
        for (const Json& part : coordinates) {
            polygons.push_back(frame.toLocal(polygonOf(part)));
        }
    }
    return polygons;
}

/// Headings from the points alone: at each one, of the circle through it and its neighbours.
void deriveMotion(PathSegment& segment) {
    // Arcs are sampled evenly: what is so much longer than its neighbour is a straight.
    constexpr double kStraightToChord = 3.0;
    std::vector<PathSample>& samples = segment.samples;
    std::vector<double> chord(samples.size() - 1);
    std::vector<double> way(samples.size() - 1);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const Point step = samples[i + 1].position - samples[i].position;
        way[i] = norm(step);
        // Twice the same point goes on as before.
        chord[i] = way[i] > 0.0 || i == 0 ? std::atan2(step.y, step.x) : chord[i - 1];
        samples[i + 1].sM = samples[i].sM + way[i];
    }
    const auto turn = [&](std::size_t i) {
        return std::remainder(chord[i] - chord[i - 1], 2.0 * std::numbers::pi);
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double heading = 0.0;
        if (i == 0) {
            heading = chord[0];
            if (chord.size() > 1 && way[0] + way[1] > 0.0) {
                heading -= turn(1) * way[0] / (way[0] + way[1]);
            }
        } else if (i + 1 == samples.size()) {
            heading = chord.back();
            if (chord.size() > 1 && way[i - 1] + way[i - 2] > 0.0) {
                heading += turn(i - 1) * way[i - 1] / (way[i - 1] + way[i - 2]);
            }
        } else {
            // Between two chords of one arc; where a straight meets an arc, the straight has the heading.
            const double both = way[i - 1] + way[i];
            const bool straightBefore = way[i - 1] > kStraightToChord * way[i];
            const bool straightAfter = way[i] > kStraightToChord * way[i - 1];
            const double share = straightBefore  ? 0.0
                                 : straightAfter ? 1.0
                                 : both > 0.0    ? way[i - 1] / both
                                                 : 0.0;
            heading = chord[i - 1] + turn(i) * share;
        }
        samples[i].headingRad = heading + (segment.gear == Gear::Reverse ? std::numbers::pi : 0.0);
    }
}

/// The features of plan.geojson that an audit reads.
class FeatureReader {
public:
    FeatureReader(const Json& collection, const LocalFrame& frame, std::string origin)
        : collection_{collection}, frame_{frame}, origin_{std::move(origin)} {}

    struct SwathFeature {
        std::size_t order = 0;
        PlannedPass pass;
    };

    Result<void> read() {
        std::size_t number = 0;
        try {
            for (const Json& feature : collection_.at("features")) {
                ++number;
                const Json& properties = feature.at("properties");
                const std::string kind = properties.value("kind", "");
                const Json& geometry = feature.at("geometry");
                if (kind == "path") {
                    addPath(properties, geometry);
                } else if (kind == "swath" || kind == "headland_pass") {
                    addPass(kind, properties, geometry);
                } else if (kind == "mainland") {
                    mainland = polygonsOf(geometry, frame_);
                } else if (kind == "headland") {
                    hasHeadland = true;
                }
            }
        } catch (const Json::exception&) {
            return std::unexpected(
                refused(std::format("{}, feature {}", origin_, number), "it is not what a plan's is"));
        }
        std::ranges::stable_sort(segments, {}, &OrderedSegment::order);
        std::ranges::stable_sort(swaths, {}, &SwathFeature::order);
        return {};
    }

    struct OrderedSegment {
        std::size_t order = 0;
        PathSegment segment;
    };
    std::vector<OrderedSegment> segments;  ///< in driving order
    std::vector<SwathFeature> swaths;      ///< in driving order, headland passes among them
    MultiPolygon mainland;
    bool hasHeadland = false;

private:
    void addPath(const Json& properties, const Json& geometry) {
        PathSegment segment{.turnType = properties.value("turn_type", "")};
        const auto kind = segmentKindFrom(properties.at("segment").get<std::string>());
        segment.kind = kind.value_or(SegmentKind::Transfer);
        segment.gear = properties.value("gear", 1) < 0 ? Gear::Reverse : Gear::Forward;
        segment.implementDown =
            properties.value("implement_down", segment.kind == SegmentKind::Swath ||
                                                   segment.kind == SegmentKind::HeadlandPass);
        segment.drivable = properties.value("drivable", true);
        segment.reason = properties.value("reason", "");
        for (const Point& point : frame_.toLocal(pointsOf(geometry.at("coordinates")))) {
            segment.samples.push_back({.position = point});
        }
        if (segment.samples.size() > 1) {
            deriveMotion(segment);
            segments.push_back({properties.value("order", segments.size()), std::move(segment)});
        }
    }

    void addPass(const std::string& kind, const Json& properties, const Json& geometry) {
        const bool swath = kind == "swath";
        SwathFeature feature{.order = properties.value("order", swaths.size()), .pass = {}};
        feature.pass = {.line = frame_.toLocal(pointsOf(geometry.at("coordinates"))),
                        .width = metres(properties.at("width_m").get<double>()),
                        .number = swath ? properties.at("number").get<int>()
                                        : properties.value("ring", 0) + 1,
                        .kind = swath ? SegmentKind::Swath : SegmentKind::HeadlandPass};
        if (feature.pass.line.size() > 1) {
            swaths.push_back(std::move(feature));
        }
    }

    const Json& collection_;
    const LocalFrame& frame_;
    std::string origin_;
};

/// The table, by the names in its first line.
class CsvPath {
public:
    CsvPath(std::string_view text, std::string origin) : rest_{text}, origin_{std::move(origin)} {}

    Result<std::vector<PathSegment>> read() {
        const std::vector<std::string_view> names = cells(line());
        for (std::size_t i = 0; i < names.size(); ++i) {
            column_[std::string{names[i]}] = i;
        }
        for (const char* needed : {"s_m", "t_s", "x_m", "y_m", "heading_rad", "curvature_1pm", "speed_mps",
                                   "gear", "implement_down", "segment", "order"}) {
            if (!column_.contains(needed)) {
                return std::unexpected(refused(origin_, std::format("it has no column {}", needed)));
            }
        }
        std::vector<PathSegment> segments;
        double order = -1.0;
        while (!rest_.empty()) {
            cells_ = cells(line());
            if (cells_.size() == 1 && cells_.front().empty()) {
                continue;
            }
            if (cells_.size() < names.size()) {
                return std::unexpected(wrong("it has too few columns"));
            }
            const PathSample sample{.sM = number("s_m"),
                                    .tS = number("t_s"),
                                    .position = {number("x_m"), number("y_m")},
                                    .headingRad = number("heading_rad"),
                                    .curvature1pm = number("curvature_1pm"),
                                    .speedMps = number("speed_mps")};
            const double next = number("order");
            const double gear = number("gear");
            const auto kind = segmentKindFrom(cells_[column_["segment"]]);
            if (!kind) {
                return std::unexpected(wrong("its segment is not of a known kind"));
            }
            const bool down = number("implement_down") != 0.0;
            if (!valid_) {
                return std::unexpected(wrong("a value is not a finite number"));
            }
            if (segments.empty() || next != order) {
                segments.push_back({.kind = *kind,
                                    .turnType = {},
                                    .gear = gear < 0.0 ? Gear::Reverse : Gear::Forward,
                                    .implementDown = down});
                order = next;
            }
            segments.back().samples.push_back(sample);
        }
        for (const PathSegment& segment : segments) {
            if (segment.samples.size() < 2) {
                return std::unexpected(refused(origin_, "a segment has a single row"));
            }
        }
        return segments;
    }

private:
    std::string_view line() {
        ++line_;
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view found = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        if (found.ends_with('\r')) {
            found.remove_suffix(1);
        }
        return found;
    }
    static std::vector<std::string_view> cells(std::string_view line) {
        std::vector<std::string_view> found;
        for (;;) {
            const std::size_t comma = line.find(',');
            found.push_back(line.substr(0, comma));
            if (comma == std::string_view::npos) {
                return found;
            }
            line.remove_prefix(comma + 1);
        }
    }
    double number(const char* name) {
        const std::string_view cell = cells_[column_[name]];
        double value = 0.0;
        const auto [end, failed] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        valid_ = valid_ && failed == std::errc{} && end == cell.data() + cell.size() && std::isfinite(value);
        return value;
    }
    Error wrong(std::string what) const {
        return refused(std::format("{}, line {}", origin_, line_), std::move(what));
    }

    std::string_view rest_;
    std::string origin_;
    std::map<std::string, std::size_t> column_;
    std::vector<std::string_view> cells_;
    std::size_t line_ = 0;
    bool valid_ = true;
};

/// Swaths and headland passes have their numbers in plan.geojson, each kind in the order it is driven.
void numberSegments(std::vector<PathSegment>& segments, const FeatureReader& features) {
    for (const SegmentKind kind : {SegmentKind::Swath, SegmentKind::HeadlandPass}) {
        auto next = features.swaths.begin();
        for (PathSegment& segment : segments) {
            if (segment.kind == kind) {
                const auto isOfKind = [kind](const auto& feature) { return feature.pass.kind == kind; };
                next = std::find_if(next, features.swaths.end(), isOfKind);
                segment.number = next == features.swaths.end() ? 0 : (next++)->pass.number;
            }
        }
    }
}

Result<Machine> machineOf(const Json& summary, const fs::path& path) {
    if (!summary.contains("machine") || !summary["machine"].is_object()) {
        return std::unexpected(refused(path.string(), "it names no machine"));
    }
    return parseMachine(summary["machine"].dump(), path.string());
}

}  // namespace

Result<WrittenPlan> readPlan(const fs::path& path, const JobContext& job) {
    std::error_code ignored;
    const bool isFolder = fs::is_directory(path, ignored);
    const fs::path geojson = isFolder ? path / "plan.geojson" : path;
    const auto collection = jsonOf(geojson);
    if (!collection) {
        return std::unexpected(collection.error());
    }
    const auto sources = readBoundaries(geojson, job);
    const auto source = sources ? pickField(*sources, std::nullopt) : std::unexpected(sources.error());
    const auto field = source ? Field::create(*source, job) : std::unexpected(source.error());
    if (!field) {
        return std::unexpected(field.error());
    }
    WrittenPlan plan{.name = field->name(), .frame = field->frame()};
    plan.statedMotion = isFolder;
    plan.positionRounding = isFolder ? metres(0.0) : kGeoJsonRounding;
    if (isFolder) {
        const fs::path summaryPath = path / "summary.json";
        const auto summary = jsonOf(summaryPath);
        if (!summary) {
            return std::unexpected(summary.error());
        }
        const auto frame = summary->is_object() && summary->contains("crs") && (*summary)["crs"].is_string()
                               ? frameFrom((*summary)["crs"].get<std::string>())
                               : std::nullopt;
        if (!frame) {
            return std::unexpected(refused(summaryPath.string() + ", crs", "it names no local frame"));
        }
        plan.frame = *frame;
        auto machine = machineOf(*summary, summaryPath);
        if (!machine) {
            return std::unexpected(machine.error());
        }
        plan.machine = std::move(*machine);
        const auto settings = summary->find("settings");
        if (settings != summary->end() && settings->is_object()) {
            const auto stayInside = settings->find("path.stay_inside");
            plan.mayLeaveField =
                stayInside != settings->end() && stayInside->is_boolean() && !stayInside->get<bool>();
        }
    }
    plan.workable = inFrame(field->workable(), field->frame(), plan.frame);
    plan.drivable = inFrame(field->drivable(), field->frame(), plan.frame);
    for (const Gate& gate : field->source().gates) {
        plan.gates.push_back({plan.frame.toLocal(gate.position), gate.width});
    }
    FeatureReader features{*collection, plan.frame, geojson.string()};
    if (auto read = features.read(); !read) {
        return std::unexpected(read.error());
    }
    if (isFolder) {
        const fs::path csv = path / "path.csv";
        const auto text = textOf(csv);
        if (!text) {
            return std::unexpected(text.error());
        }
        auto segments = CsvPath{*text, csv.string()}.read();
        if (!segments) {
            return std::unexpected(segments.error());
        }
        plan.segments = std::move(*segments);
        if (plan.segments.size() == features.segments.size()) {
            for (std::size_t i = 0; i < plan.segments.size(); ++i) {
                const PathSegment& drawn = features.segments[i].segment;
                plan.segments[i].turnType = drawn.turnType;
                plan.segments[i].drivable = drawn.drivable;
                plan.segments[i].reason = drawn.reason;
            }
        } else {
            return std::unexpected(refused(
                path.string(), std::format("path.csv has {} segments and plan.geojson {}",
                                           plan.segments.size(), features.segments.size())));
        }
    } else {
        for (auto& each : features.segments) {
            plan.segments.push_back(std::move(each.segment));
        }
    }
    if (plan.segments.empty()) {
        return std::unexpected(refused(geojson.string(), "there is no path in it"));
    }
    numberSegments(plan.segments, features);
    bool headlandDriven = false;
    for (const auto& swath : features.swaths) {
        plan.passes.push_back(swath.pass);
    }
    for (const PathSegment& segment : plan.segments) {
        headlandDriven = headlandDriven || segment.kind == SegmentKind::HeadlandPass;
    }
    if (features.hasHeadland && !features.mainland.empty() && !headlandDriven) {
        plan.mainland = std::move(features.mainland);
    }
    return plan;
}

AuditInput auditInput(const WrittenPlan& plan) {
    return {.workable = plan.workable,
            .drivable = plan.drivable,
            .gates = plan.gates,
            .machine = plan.machine,
            .segments = plan.segments,
            .passes = plan.passes,
            .mainland = plan.mainland,
            .mayLeaveField = plan.mayLeaveField,
            .statedMotion = plan.statedMotion,
            .positionRounding = plan.positionRounding};
}

}  // namespace furrow
