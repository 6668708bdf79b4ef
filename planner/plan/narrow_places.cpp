#include "planner/plan/narrow_places.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <limits>

namespace furrow {

namespace {

// Of half a disc's width. The corner of a square is 1.41 from the middle of a disc that lies in it.
constexpr double kCornerReach = 1.6;

Point nearestOn(const MultiPolygon& polygons, Point place) {
    if (isInside(polygons, place)) {
        return place;
    }
    Point nearest = place;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point at = nearestOnSegment(place, ring[i], ring[(i + 1) % ring.size()]);
            if (const double away = distance(place, at); away < least) {
                least = away;
                nearest = at;
            }
        }
    };
    for (const Polygon& polygon : polygons) {
        look(polygon.outer);
        std::ranges::for_each(polygon.holes, look);
    }
    return nearest;
}

bool isNarrow(const MultiPolygon& fits, Length width, Point place) {
    return fits.empty() || distance(nearestOn(fits, place), place) > kCornerReach * 0.5 * width.si();
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
    const Point inside = nearestOn(area_, place);
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
