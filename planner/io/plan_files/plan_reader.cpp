#include "planner/io/plan_files/plan_reader.h"

#include "planner/field/field.h"
#include "planner/io/content/field_choice.h"
#include "planner/io/content/imported_fields.h"
#include "planner/io/formats/csv/path_csv.h"
#include "planner/io/import/field_reader.h"
#include "planner/io/plan_files/plan_json.h"
#include "planner/machine/machine_file.h"
#include "planner/path/refill_stops.h"
#include "planner/plan/general_parameters.h"
#include "planner/settings/operation.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// What nine decimals of a degree leave open.
constexpr Length kGeoJsonRounding = metres(1e-4);

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
                } else if (kind == "left_on_purpose") {
                    std::ranges::move(polygonsOf(geometry, frame_), std::back_inserter(leftOnPurpose));
                } else if (kind == "overhung") {
                    MultiPolygon read = polygonsOf(geometry, frame_);
                    overhung = overhung.value_or(MultiPolygon{});
                    std::ranges::move(read, std::back_inserter(*overhung));
                } else if (kind == "refill_point") {
                    const Json& place = geometry.at("coordinates");
                    refillPoints.push_back(
                        frame_.toLocal({place.at(0).get<double>(), place.at(1).get<double>()}));
                } else if (kind == "headland") {
                    hasHeadland = true;
                }
            }
        } catch (const Json::exception&) {
            return std::unexpected(
                damagedPlan(message("{}, feature {}", origin_, number), "it is not what a plan's is"));
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
    MultiPolygon leftOnPurpose;
    std::optional<MultiPolygon> overhung;
    std::vector<Point> refillPoints;
    bool hasHeadland = false;

private:
    void addPath(const Json& properties, const Json& geometry) {
        PathSegment segment{.turnType = properties.value("turn_type", "")};
        const auto kind = segmentKindFrom(properties.at("segment").get<std::string>());
        segment.kind = kind.value_or(SegmentKind::Transfer);
        segment.number = properties.value("number", 0);
        segment.gear = properties.value("gear", 1) < 0 ? Gear::Reverse : Gear::Forward;
        segment.implementDown =
            properties.value("implement_down",
                             segment.kind == SegmentKind::Swath || segment.kind == SegmentKind::HeadlandPass);
        segment.folded = properties.value("folded", false);
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
        feature.pass = {
            .line = frame_.toLocal(pointsOf(geometry.at("coordinates"))),
            .width = metres(properties.at("width_m").get<double>()),
            .number = swath ? properties.at("number").get<int>() : properties.value("ring", 0) + 1,
            .kind = swath ? SegmentKind::Swath : SegmentKind::HeadlandPass};
        if (feature.pass.line.size() > 1) {
            swaths.push_back(std::move(feature));
        }
    }

    const Json& collection_;
    const LocalFrame& frame_;
    std::string origin_;
};

/// Plans of before segments had numbers: swaths and headland passes have them in plan.geojson, each kind in
/// the order it is driven.
void numberSegments(std::vector<PathSegment>& segments, const FeatureReader& features) {
    if (std::ranges::any_of(segments, [](const PathSegment& segment) { return segment.number > 0; })) {
        return;
    }
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

Result<Field> fieldOf(const fs::path& geojson, const JobContext& job) {
    auto read = readFields(geojson, job);
    const auto sources =
        read ? boundariesOf(*std::move(read), geojson.filename().string()) : std::unexpected(read.error());
    const auto source = sources ? pickField(*sources, std::nullopt) : std::unexpected(sources.error());
    return source ? Field::create(*source, job) : std::unexpected(source.error());
}

Result<Machine> machineOf(const Json& summary, const fs::path& path) {
    if (!summary.contains("machine") || !summary["machine"].is_object()) {
        return std::unexpected(damagedPlan(path.string(), "it names no machine"));
    }
    return parseMachine(summary["machine"].dump(), path.string());
}

/// Frame, machine, and what the settings allow.
Result<void> readSummary(const fs::path& path, WrittenPlan& plan) {
    const auto summary = planJson(path);
    const auto frame = summary ? planFrame(*summary, path) : std::unexpected(summary.error());
    if (!frame) {
        return std::unexpected(frame.error());
    }
    plan.frame = *frame;
    auto machine = machineOf(*summary, path);
    if (!machine) {
        return std::unexpected(machine.error());
    }
    plan.machine = std::move(*machine);
    const auto driven = summary->find("path");
    if (driven != summary->end() && driven->contains("refills")) {
        const auto use = summary->find("tank");
        plan.tank = AuditTank{.gathers = use != summary->end() && *use == tankUseId(TankUse::Fills),
                              .points = {},
                              .reach = refillReach(*plan.machine)};
    }
    const auto settings = summary->find("settings");
    if (settings == summary->end() || !settings->is_object()) {
        return {};
    }
    const auto stayInside = settings->find("path.stay_inside");
    plan.mayLeaveField =
        stayInside != settings->end() && stayInside->is_boolean() && !stayInside->get<bool>();
    const auto margin = settings->find(kMargin.key);
    if (margin != settings->end() && margin->is_number()) {
        plan.margin = metres(margin->get<double>());
    }
    return {};
}

/// The path as path.csv has it, with what only plan.geojson says of it.
Result<void> readPath(const fs::path& folder, const FeatureReader& features, WrittenPlan& plan) {
    const fs::path csv = folder / "path.csv";
    const auto text = planFileBytes(csv);
    auto read = text ? readPathCsv(*text, csv.string()) : std::unexpected(text.error());
    if (!read) {
        return std::unexpected(read.error());
    }
    plan.segments = std::move(read->segments);
    if (plan.segments.size() != features.segments.size()) {
        return std::unexpected(
            damagedPlan(folder.string(), message("path.csv has {} segments and plan.geojson {}",
                                                 plan.segments.size(), features.segments.size())));
    }
    for (std::size_t i = 0; i < plan.segments.size(); ++i) {
        const PathSegment& drawn = features.segments[i].segment;
        plan.segments[i].turnType = drawn.turnType;
        plan.segments[i].number = drawn.number;
        plan.segments[i].folded = drawn.folded;
        plan.segments[i].drivable = drawn.drivable;
        plan.segments[i].reason = drawn.reason;
    }
    return {};
}

}  // namespace

Result<WrittenPlan> readPlan(const fs::path& path, const JobContext& job) {
    std::error_code ignored;
    const bool isFolder = fs::is_directory(path, ignored);
    const fs::path geojson = isFolder ? path / "plan.geojson" : path;
    const auto collection = planJson(geojson);
    if (!collection) {
        return std::unexpected(collection.error());
    }
    const auto field = fieldOf(geojson, job);
    if (!field) {
        return std::unexpected(field.error());
    }
    WrittenPlan plan{.name = field->name(), .frame = field->frame()};
    plan.statedMotion = isFolder;
    plan.positionRounding = isFolder ? metres(0.0) : kGeoJsonRounding;
    if (isFolder) {
        if (auto read = readSummary(path / "summary.json", plan); !read) {
            return std::unexpected(read.error());
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
        if (auto read = readPath(path, features, plan); !read) {
            return std::unexpected(read.error());
        }
    } else {
        for (auto& each : features.segments) {
            plan.segments.push_back(std::move(each.segment));
        }
    }
    if (plan.segments.empty()) {
        return std::unexpected(damagedPlan(geojson.string(), "there is no path in it"));
    }
    numberSegments(plan.segments, features);
    bool headlandDriven = false;
    for (const auto& swath : features.swaths) {
        plan.passes.push_back(swath.pass);
    }
    for (const PathSegment& segment : plan.segments) {
        headlandDriven = headlandDriven || segment.kind == SegmentKind::HeadlandPass;
    }
    plan.leftOnPurpose = std::move(features.leftOnPurpose);
    plan.overhung = std::move(features.overhung);
    if (plan.tank) {
        plan.tank->points = std::move(features.refillPoints);
    }
    if (features.hasHeadland && !features.mainland.empty() && !headlandDriven) {
        plan.mainland = std::move(features.mainland);
    }
    return plan;
}

AuditInput auditInput(const WrittenPlan& plan) {
    return {.workable = plan.workable,
            .drivable = plan.drivable,
            .overhung = plan.overhung,
            .gates = plan.gates,
            .machine = plan.machine,
            .segments = plan.segments,
            .passes = plan.passes,
            .mainland = plan.mainland,
            .margin = plan.margin,
            .leftOnPurpose = plan.leftOnPurpose,
            .tank = plan.tank,
            .mayLeaveField = plan.mayLeaveField,
            .statedMotion = plan.statedMotion,
            .positionRounding = plan.positionRounding};
}

}  // namespace furrow
