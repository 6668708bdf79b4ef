#include "planner/sheet/order_sheet.h"

#include "planner/io/content/plan_error.h"
#include "planner/io/formats/csv/path_csv.h"
#include "planner/io/formats/geojson/plan_geojson.h"
#include "planner/io/plan_files/plan_json.h"
#include "planner/io/plan_files/plan_summary.h"
#include "planner/machine/machine_file.h"
#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "planner/settings/operation.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kSummary = "summary.json";
constexpr const char* kPath = "path.csv";
constexpr const char* kShapes = "plan.geojson";

/// The three files of a plan, as text, with their names for messages.
struct PlanTexts {
    Json summary;
    std::string path;
    Json shapes;
    fs::path folder;

    fs::path nameOf(const char* file) const { return folder.empty() ? fs::path{file} : folder / file; }
};

template <class Quantity>
std::optional<Quantity> quantityIn(const Json& json, const char* key) {
    const auto member = json.find(key);
    return member == json.end() || !member->is_number() ? std::optional<Quantity>{}
                                                        : Quantity::fromSi(member->get<double>());
}

std::optional<double> numberIn(const Json& json, const char* key) {
    const auto member = json.find(key);
    return member == json.end() || !member->is_number() ? std::optional<double>{}
                                                        : std::optional{member->get<double>()};
}

/// Numbers that the planner finds by itself. Those that matter stand among the figures. A least length of
/// swaths that was not given stays "auto".
bool isComputed(const Parameter& parameter) {
    return parameter.canBeAuto && parameter.key != "swaths.min_length_m";
}

/// Throws what nlohmann throws.
std::optional<SettingValue> settingIn(const Json& value) {
    if (value.is_boolean()) {
        return SettingValue{value.get<bool>()};
    }
    if (value.is_number()) {
        return SettingValue{value.get<double>()};
    }
    if (value.is_string()) {
        const std::string text = value.get<std::string>();
        return text == "auto" ? SettingValue{Auto{}} : SettingValue{text};
    }
    return std::nullopt;
}

void addSettings(const Json& summary, OrderSheet& sheet) {
    const Json settings = summary.value("settings", Json::object());
    const Json byOperation = summary.value("operation_sets", Json::object());
    for (const Parameter* parameter : allParameters()) {
        const std::string key{parameter->key};
        if (!settings.contains(key) || byOperation.contains(key) || isComputed(*parameter) ||
            parameter == &kOperationKind) {
            continue;
        }
        const auto value = settingIn(settings[key]);
        if (value && settingText(*value) != settingText(parameter->defaultValue())) {
            sheet.settings.push_back({.parameter = parameter, .value = *value});
        }
    }
}

/// Throws what nlohmann throws where members are missing or of another kind.
void addSummary(const Json& summary, OrderSheet& sheet) {
    const Json& field = summary.at("field");
    sheet.fieldId = field.value("id", "");
    sheet.fieldName = field.value("name", "");
    sheet.version = summary.value("version", "");
    sheet.operation = summary.at("operation").get<std::string>();
    SheetFigures& figures = sheet.figures;
    figures.field = Area::fromSi(field.at("area_m2").get<double>());
    const Json& audit = summary.at("audit");
    figures.covered = quantityIn<Area>(audit, "covered_m2");
    figures.coveredShare = numberIn(audit, "covered");
    const auto overlap = numberIn(audit, "overlap_m2");
    const auto workable = numberIn(audit, "workable_m2");
    if (overlap && workable && *workable > 0.0) {
        figures.overlapShare = *overlap / *workable;
    }
    figures.missed = quantityIn<Area>(audit, "missed_m2");
    figures.outside = quantityIn<Area>(audit, "outside_m2");
    const Json& path = summary.at("path");
    figures.path = metres(path.at("length_m").get<double>());
    figures.working = metres(path.at("working_length_m").get<double>());
    figures.reverse = metres(path.value("reverse_length_m", 0.0));
    figures.time = seconds(path.at("time_s").get<double>());
    figures.gap = numberIn(summary.at("route"), "gap");
    const Json& headland = summary.at("headland");
    figures.headlandWidth = metres(headland.value("width_m", 0.0));
    figures.headlandPasses = headland.value("passes", 0);
    figures.margin =
        metres(numberIn(summary.value("settings", Json::object()), "field.margin_m").value_or(0.0));
    figures.swaths = summary.at("swaths").at("count").get<int>();
    addSettings(summary, sheet);
}

void addFindings(const Json& audit, const LocalFrame& frame, OrderSheet& sheet) {
    for (const Json& json : audit.value("findings", Json::array())) {
        const GeoPoint place{json.at("lon_deg").get<double>(), json.at("lat_deg").get<double>()};
        Finding finding;
        finding.severity = json.at("severity") == "blocking" ? Severity::Blocking : Severity::Note;
        finding.place = frame.toLocal(place);
        finding.text = json.value("text", "");
        finding.suggestion = json.value("suggestion", "");
        sheet.findings.push_back(std::move(finding));
        sheet.findingPlaces.push_back(place);
    }
}

/// What the table does not hold of a segment, from plan.geojson.
struct DrawnSegment {
    int number = 0;
    std::string turnType;
    bool drivable = true;
};

std::map<std::size_t, DrawnSegment> addShapes(const Json& shapes, const LocalFrame& frame,
                                              OrderSheet& sheet) {
    std::map<std::size_t, DrawnSegment> drawn;
    for (const Json& feature : shapes.at("features")) {
        const Json& properties = feature.at("properties");
        const Json& geometry = feature.at("geometry");
        const std::string kind = properties.value("kind", "");
        if (kind == "field") {
            std::ranges::move(polygonsOf(geometry, frame), std::back_inserter(sheet.field));
        } else if (kind == "mainland") {
            std::ranges::move(polygonsOf(geometry, frame), std::back_inserter(sheet.mainland));
        } else if (kind == "obstacle") {
            sheet.obstacles.push_back({.name = properties.value("name", ""),
                                       .outline = polygonsOf(geometry, frame),
                                       .passable = properties.value("passable", false)});
        } else if (kind == "gate") {
            const Json& position = geometry.at("coordinates");
            const GeoPoint geo{position.at(0).get<double>(), position.at(1).get<double>()};
            sheet.gates.push_back(
                {.name = properties.value("name", ""), .place = frame.toLocal(geo), .geo = geo});
        } else if (kind == "path") {
            drawn[properties.value("order", drawn.size())] = {.number = properties.value("number", 0),
                                                              .turnType = properties.value("turn_type", ""),
                                                              .drivable = properties.value("drivable", true)};
        }
    }
    return drawn;
}

Polyline lineOf(const PathSegment& segment) {
    Polyline line;
    for (const PathSample& sample : segment.samples) {
        line.push_back(sample.position);
    }
    return line;
}

SheetPass passOf(const PathSegment& segment) {
    SheetPass pass{.kind = segment.kind,
                   .number = segment.number,
                   .line = lineOf(segment),
                   .length = segment.length(),
                   .time = segment.duration(),
                   .bearingDeg = {}};
    const Point way = pass.line.back() - pass.line.front();
    if (pass.kind == SegmentKind::Swath && norm(way) > 0.0) {
        pass.bearingDeg = bearingDeg(radians(std::atan2(way.y, way.x)));
    }
    return pass;
}

void countTurn(const std::string& type, std::vector<SheetTurns>& turns) {
    const auto known = std::ranges::find(turns, type, &SheetTurns::type);
    if (known == turns.end()) {
        turns.push_back({.type = type, .count = 1});
    } else {
        ++known->count;
    }
}

void addPath(const Path& path, OrderSheet& sheet) {
    bool turning = false;
    for (const PathSegment& segment : path.segments) {
        const bool worked = segment.kind == SegmentKind::Swath || segment.kind == SegmentKind::HeadlandPass;
        if (worked) {
            sheet.passes.push_back(passOf(segment));
        } else {
            sheet.ways.push_back({.line = lineOf(segment),
                                  .reverse = segment.gear == Gear::Reverse,
                                  .drivable = segment.drivable});
        }
        // A turn with a change of gear is several segments, and one turn for whoever drives it.
        const bool turn = segment.kind == SegmentKind::Turn;
        if (turn && !turning) {
            countTurn(segment.turnType, sheet.turns);
        }
        turning = turn;
    }
    std::ranges::stable_sort(sheet.turns, std::greater{}, &SheetTurns::count);
    sheet.start = path.segments.front().samples.front().position;
    sheet.end = path.segments.back().samples.back().position;
    sheet.figures.refills = path.refillCount();
    sheet.figures.refillWay = path.length(SegmentKind::Refill);
    sheet.figures.workingTime = path.workedDuration();
    sheet.figures.fuelLitres = fuelLitres(sheet.machine, sheet.figures.workingTime, sheet.figures.time);
}

Result<OrderSheet> sheetOf(PlanTexts texts) {
    const fs::path summaryName = texts.nameOf(kSummary);
    const auto frame = planFrame(texts.summary, summaryName);
    if (!frame) {
        return std::unexpected(frame.error());
    }
    auto path = readPathCsv(texts.path, texts.nameOf(kPath).string());
    if (!path) {
        return std::unexpected(path.error());
    }
    fs::path place = summaryName;
    try {
        auto machine = parseMachine(texts.summary.at("machine").dump(), summaryName.string());
        if (!machine) {
            return std::unexpected(machine.error());
        }
        OrderSheet sheet{.machine = *std::move(machine)};
        addSummary(texts.summary, sheet);
        addFindings(texts.summary.at("audit"), *frame, sheet);
        place = texts.nameOf(kShapes);
        const auto drawn = addShapes(texts.shapes, *frame, sheet);
        for (std::size_t i = 0; i < path->segments.size(); ++i) {
            if (const auto found = drawn.find(i); found != drawn.end()) {
                path->segments[i].number = found->second.number;
                path->segments[i].turnType = found->second.turnType;
                path->segments[i].drivable = found->second.drivable;
            }
        }
        addPath(*path, sheet);
        sheet.startGeo = frame->toGeo(sheet.start);
        sheet.frame = *frame;
        sheet.pathFile = std::move(texts.path);
        return sheet;
    } catch (const Json::exception&) {
        return std::unexpected(
            damagedPlan(place.string(), "a member that every plan has is missing or of another kind"));
    }
}

}  // namespace

std::ptrdiff_t OrderSheet::blockingCount() const {
    return furrow::blockingCount(findings);
}

GeoPoint meetingPlace(const OrderSheet& sheet) {
    const auto nearest = std::ranges::min_element(
        sheet.gates, {}, [&sheet](const SheetGate& gate) { return distance(gate.place, sheet.start); });
    return nearest == sheet.gates.end() ? sheet.startGeo : nearest->geo;
}

std::optional<double> fuelLitres(const Machine& machine, Duration working, Duration whole) {
    constexpr double kSecondsPerHour = 3600.0;
    return machine.spec().fuel.transform([&](const FuelUse& fuel) {
        return (working.si() * fuel.workingLph + (whole - working).si() * fuel.turningLph) / kSecondsPerHour;
    });
}

Result<OrderSheet> readOrderSheet(const fs::path& folder) {
    auto summary = planJson(folder / kSummary);
    if (!summary) {
        return std::unexpected(summary.error());
    }
    auto path = planFileBytes(folder / kPath);
    if (!path) {
        return std::unexpected(path.error());
    }
    auto shapes = planJson(folder / kShapes);
    if (!shapes) {
        return std::unexpected(shapes.error());
    }
    return sheetOf({.summary = *std::move(summary),
                    .path = *std::move(path),
                    .shapes = *std::move(shapes),
                    .folder = folder});
}

Result<OrderSheet> orderSheet(const Plan& plan) {
    auto sheet = sheetOf({.summary = Json::parse(planSummaryJson(plan)),
                          .path = pathCsv(plan),
                          .shapes = Json::parse(planGeoJson(plan)),
                          .folder = {}});
    if (sheet) {
        sheet->findings = plan.findings;
    }
    return sheet;
}

}  // namespace furrow
