#include "planner/plan/ways_room.h"

#include "planner/field/ground_around.h"
#include "planner/plan/general_parameters.h"

#include <utility>

namespace furrow {

namespace {

Result<RouteEnds> routeEnds(const Field& field, const Settings& settings) {
    auto start = routePlace(field, settings, kRouteStart);
    auto end = routePlace(field, settings, kRouteEnd);
    if (!start || !end) {
        return std::unexpected(start ? end.error() : start.error());
    }
    return RouteEnds{*std::move(start), *std::move(end)};
}

/// Where ways may lead: gates are open, and where the machine may leave the field so is everything but
/// obstacles.
Result<AllowedAreas> groundForWays(const PlanRequest& request, const AllowedAreas& open,
                                   const JobContext& job) {
    if (request.settings.flag(kStayInside)) {
        return open;
    }
    return groundAround(*request.field, job).transform([](MultiPolygon&& all) {
        return AllowedAreas{std::move(all)};
    });
}

}  // namespace

Result<WaysRoom> waysRoom(DrivingRooms& known, const PlanRequest& request,
                          const std::shared_ptr<const Ground>& ground, const MultiPolygon& mainland,
                          const JobContext& job) {
    auto places = routeEnds(*request.field, request.settings);
    if (!places) {
        return std::unexpected(places.error());
    }
    auto refills = routePlaces(*request.field, request.settings, kRouteRefill);
    if (!refills) {
        return std::unexpected(refills.error());
    }
    std::vector<std::optional<RoutePlace>> entered{places->begin(), places->end()};
    entered.insert(entered.end(), refills->begin(), refills->end());
    auto open = withOpenGates(ground->drivable, *request.field, entered, job);
    if (!open) {
        return std::unexpected(open.error());
    }
    auto forWays = groundForWays(request, *open, job);
    if (!forWays) {
        return std::unexpected(forWays.error());
    }
    auto room = drivingRoom(known, request, {ground, *forWays, mainland, traversalOf(request.settings)}, job);
    if (!room) {
        return std::unexpected(room.error());
    }
    return WaysRoom{*std::move(places), *std::move(refills), *std::move(open), *std::move(forWays),
                    *std::move(room)};
}

}  // namespace furrow
