#include "planner/path/tank_levels.h"

#include <algorithm>

namespace furrow {

std::optional<TankWork> tankWork(const Machine& machine, const Operation& operation) {
    const auto& tank = machine.spec().tank;
    if (operation.tank == TankUse::None || !tank || tank->capacity <= 0.0 || tank->ratePerM2 <= 0.0) {
        return std::nullopt;
    }
    return TankWork{.capacity = tank->capacity,
                    .perMetre = tank->ratePerM2 * machine.operatingWidth().si(),
                    .gathers = operation.tank == TankUse::Fills};
}

double addLevels(Path& path, const TankWork& work) {
    double used = 0.0;
    double beyond = 0.0;
    for (PathSegment& segment : path.segments) {
        const double startM = segment.samples.front().sM;
        for (PathSample& sample : segment.samples) {
            const double now = used + (segment.implementDown ? work.perMetre * (sample.sM - startM) : 0.0);
            const double held = std::clamp(now, 0.0, work.capacity);
            sample.level = work.gathers ? held : work.capacity - held;
        }
        if (segment.implementDown) {
            used += work.perMetre * segment.length().si();
        }
        beyond = std::max(beyond, used - work.capacity);
        if (segment.refills) {
            used = 0.0;
        }
    }
    return beyond;
}

Message tripName(std::span<const PathSegment> segments, std::size_t segment, bool gathers) {
    while (segment < segments.size() && segments[segment].kind == SegmentKind::Refill) {
        if (segments[segment].refills) {
            return gathers ? "Way to unload" : "Way to refill";
        }
        ++segment;
    }
    return "Way back to work";
}

}  // namespace furrow
