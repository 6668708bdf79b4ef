#include "planner/io/formats/mavlink/mavlink.h"

#include "planner/geometry/simplify.h"
#include "planner/plan/plan.h"

#include <nlohmann/json.hpp>

#include <format>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

using Json = nlohmann::ordered_json;

// MAV_CMD
constexpr int kWaypoint = 16;
constexpr int kChangeSpeed = 178;
constexpr int kSetRelay = 181;
constexpr int kSetReverse = 194;

// MAV_FRAME
constexpr int kAbsoluteAltitude = 0;
constexpr int kRelativeAltitude = 3;

// Autopilots round corners their own way; closer points than this error needs would only fill their memory.
constexpr Length kChordError = metres(0.05);
// Boards without a memory card hold several hundred.
constexpr std::size_t kManyItems = 700;

struct MissionItem {
    int command = kWaypoint;
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
    std::optional<GeoPoint> place;
};

/// Waypoints with what changes between them: gear, speed of the kind of stretch, implement.
std::vector<MissionItem> missionOf(const Plan& plan) {
    const Tractor& tractor = plan.request.machine.spec().tractor;
    std::vector<MissionItem> items;
    Gear gear = Gear::Forward;
    bool down = false;
    double speed = 0.0;
    for (const PathSegment& segment : plan.path.segments) {
        if (segment.gear != gear) {
            gear = segment.gear;
            items.push_back({.command = kSetReverse, .first = gear == Gear::Reverse ? 1.0 : 0.0});
        }
        const Speed wanted = gear == Gear::Reverse   ? tractor.reverseSpeed
                             : segment.implementDown ? tractor.workingSpeed
                                                     : plan.request.machine.turningSpeed();
        if (wanted.si() != speed) {
            speed = wanted.si();
            constexpr double kGroundSpeed = 1.0;
            constexpr double kThrottleAsItIs = -1.0;
            items.push_back(
                {.command = kChangeSpeed, .first = kGroundSpeed, .second = speed, .third = kThrottleAsItIs});
        }
        if (segment.implementDown != down) {
            down = segment.implementDown;
            items.push_back({.command = kSetRelay, .first = 0.0, .second = down ? 1.0 : 0.0});
        }
        Polyline line;
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
        line = simplified(line, kChordError);
        // A segment begins where the one before ends.
        const std::size_t begin = items.empty() || !items.back().place ? 0 : 1;
        for (std::size_t i = begin; i < line.size(); ++i) {
            items.push_back({.place = plan.field().frame().toGeo(line[i])});
        }
    }
    return items;
}

std::vector<Message> notesOn(const std::vector<MissionItem>& items) {
    std::vector<Message> notes{"Relay 1 is on where the implement works."};
    if (items.size() > kManyItems) {
        notes.push_back(message("The mission has {} items; controllers without a memory card hold about {}.",
                                items.size(), kManyItems));
    }
    return notes;
}

Json latLon(GeoPoint point) {
    return Json::array({point.latDeg, point.lonDeg});
}

void addFence(Json& fences, const GeoRing& ring, bool inside) {
    Json polygon = Json::array();
    for (const GeoPoint& point : ring) {
        polygon.push_back(latLon(point));
    }
    fences.push_back({{"inclusion", inside}, {"polygon", std::move(polygon)}, {"version", 1}});
}

Json fencesOf(const FieldSource& field) {
    Json fences = Json::array();
    for (const GeoPolygon& part : field.parts) {
        addFence(fences, part.outer, true);
        for (const GeoRing& hole : part.holes) {
            addFence(fences, hole, false);
        }
    }
    for (const Obstacle& obstacle : field.obstacles) {
        if (!obstacle.passable) {
            addFence(fences, obstacle.outline.outer, false);
        }
    }
    return fences;
}

}  // namespace

Result<FormatFiles> writeWaypoints(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("waypoints"));
    }
    const std::vector<MissionItem> items = missionOf(*job.plan);
    std::string text = "QGC WPL 110\n";
    int row = 0;
    const auto add = [&](int frame, const MissionItem& item) {
        const GeoPoint place = item.place.value_or(GeoPoint{});
        std::format_to(std::back_inserter(text),
                       "{}\t{}\t{}\t{}\t{:.8f}\t{:.8f}\t{:.8f}\t{:.8f}\t{:.8f}\t{:.8f}\t{:.6f}\t1\n", row,
                       row == 0 ? 1 : 0, frame, item.command, item.first, item.second, item.third, 0.0,
                       place.latDeg, place.lonDeg, 0.0);
        ++row;
    };
    // The first row is home: where the path begins.
    add(kAbsoluteAltitude,
        {.place = job.plan->field().frame().toGeo(job.plan->path.segments.front().samples.front().position)});
    for (const MissionItem& item : items) {
        add(kRelativeAltitude, item);
    }
    FormatFiles made{{}, notesOn(items)};
    made.files.push_back({"plan.waypoints", [text = std::move(text)] { return text; }});
    return made;
}

Result<FormatFiles> writeGroundStationPlan(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("qgc-plan"));
    }
    const Plan& plan = *job.plan;
    const std::vector<MissionItem> mission = missionOf(plan);
    Json items = Json::array();
    for (std::size_t i = 0; i < mission.size(); ++i) {
        const MissionItem& item = mission[i];
        Json parameters = Json::array({item.first, item.second, item.third, 0.0, 0.0, 0.0, 0.0});
        if (item.place) {
            parameters = Json::array({0.0, 0.0, 0.0, nullptr, item.place->latDeg, item.place->lonDeg, 0.0});
        }
        items.push_back({{"AMSLAltAboveTerrain", nullptr},
                         {"Altitude", 0},
                         {"AltitudeMode", 1},
                         {"autoContinue", true},
                         {"command", item.command},
                         {"doJumpId", i + 1},
                         {"frame", kRelativeAltitude},
                         {"params", std::move(parameters)},
                         {"type", "SimpleItem"}});
    }
    const GeoPoint home = plan.field().frame().toGeo(plan.path.segments.front().samples.front().position);
    const double cruise = plan.request.machine.spec().tractor.workingSpeed.si();
    const Json document{
        {"fileType", "Plan"},
        {"version", 1},
        {"groundStation", "Furrow"},
        {"mission",
         {{"version", 2},
          {"firmwareType", 3},
          {"vehicleType", 10},
          {"cruiseSpeed", cruise},
          {"hoverSpeed", cruise},
          {"globalPlanAltitudeMode", 1},
          {"plannedHomePosition", Json::array({home.latDeg, home.lonDeg, 0.0})},
          {"items", std::move(items)}}},
        {"geoFence",
         {{"version", 2}, {"circles", Json::array()}, {"polygons", fencesOf(plan.field().source())}}},
        {"rallyPoints", {{"version", 2}, {"points", Json::array()}}}};
    FormatFiles made{{}, notesOn(mission)};
    made.files.push_back({"plan.plan", [text = document.dump(1) + "\n"] { return text; }});
    return made;
}

}  // namespace furrow
