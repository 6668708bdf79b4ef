#include "planner/plan/narrow_places.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/nearest_on_edges.h"

namespace furrow {

namespace {

// Of half a disc's width. The corner of a square is 1.41 from the middle of a disc that lies in it.
constexpr double kCornerReach = 1.6;

Point nearestIn(const MultiPolygon& polygons, Point place) {
    return isInside(polygons, place) ? place : nearestOnEdges(polygons, place).value_or(place);
}

bool isNarrow(const MultiPolygon& fits, Length width, Point place) {
    return fits.empty() || distance(nearestIn(fits, place), place) > kCornerReach * 0.5 * width.si();
}

}  // namespace

Result<NarrowPlaces> NarrowPlaces::of(const Plan& plan, const JobContext& job) {
    const Machine& machine = plan.request.machine;
    NarrowPlaces places;
    places.area_ = plan.overhung ? *plan.overhung : plan.field().drivable();
    places.machineWidth_ = machine.workingFootprintWidth();
    places.turnWidth_ = 2.0 * machine.minTurningRadius() + machine.transportWidth();
    auto fits = eroded(places.area_, 0.5 * places.machineWidth_, kArcTolerance, job);
    auto turns = eroded(places.area_, 0.5 * places.turnWidth_, kArcTolerance, job);
    if (!fits || !turns) {
        return std::unexpected(!fits ? fits.error() : turns.error());
    }
    places.machineFits_ = *std::move(fits);
    places.turnFits_ = *std::move(turns);
    return places;
}

Message NarrowPlaces::reasonAt(Point place) const {
    const Point inside = nearestIn(area_, place);
    if (isNarrow(machineFits_, machineWidth_, inside)) {
        return message(
            "The field is narrower here than this machine, which takes {:.1f} m: leave this strip "
            "out, or work it with a narrower machine.",
            machineWidth_.si());
    }
    if (isNarrow(turnFits_, turnWidth_, inside)) {
        return message(
            "The field is narrower here than the {:.1f} m in which this machine turns without "
            "reversing: leave this strip out, or work it with a machine that turns more tightly.",
            turnWidth_.si());
    }
    return {};
}

}  // namespace furrow
