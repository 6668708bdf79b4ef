#pragma once

#include "planner/route/link_costs.h"
#include "planner/route/route.h"
#include "planner/turns/manoeuvre_search.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// What a route is to save.
enum class RouteObjective { Time, Length, Fuel };

/// By route.objective.
extern const Parameter kRouteObjective;
RouteObjective routeObjective(const Settings& settings);

/// What the swaths of a task and the links between them cost by the chosen objective: seconds, metres or
/// litres. Turns are driven at the speeds for turning and reversing, long ways of several moves at the speed
/// for transfers. A link for which no way fits costs some minutes more than in free space, and one that
/// breaks what route.locked, route.first or route.last says hours more. The task must outlive it.
class RouteCosts {
public:
    explicit RouteCosts(const RouteTask& task);
    RouteCosts(const RouteCosts&) = delete;
    RouteCosts& operator=(const RouteCosts&) = delete;

    LinkCosts& links() { return links_; }
    const LinkCosts& links() const { return links_; }
    /// For links that are checked from now on. None: those with a single curve that fits.
    void setEffort(SearchEffort effort) { effort_ = effort; }
    /// Of all swaths.
    double working() const { return working_; }
    double workingOn(std::size_t swath) const;
    /// Whether an order breaks what route.locked, route.first or route.last says.
    bool isBroken(const EndOrder& order) const;

private:
    double costOf(const Curve& way, const Pose& from, const Pose& to) const;
    double costOf(Length length, Duration time, double FuelUse::* litresPerHour = &FuelUse::turningLph) const;
    bool isLockedOut(SwathEnd leaving, SwathEnd entered) const;
    bool isWrongFirst(SwathEnd entered) const;
    bool isWrongLast(SwathEnd left) const;
    LinkCosts::Functions functions();

    const RouteTask& task_;
    RouteObjective objective_;
    SearchEffort effort_ = SearchEffort::Thorough;
    double costPerMetre_ = 0.0;  ///< at least
    std::vector<Curve> lines_;   ///< of the vehicle, by the end at which the swath is entered
    std::vector<Pose> left_;     ///< by the end at which it is left
    double working_ = 0.0;
    /// Of swaths that are locked together: the end entered next after leaving at an end, and the other way
    /// round. Ends that are nothing to each other lead to themselves.
    std::vector<SwathEnd> next_;
    std::vector<SwathEnd> before_;
    std::vector<char> isWrongWay_;      ///< by the end that is entered
    std::optional<SwathEnd> begin_;     ///< of route.corner
    std::optional<std::size_t> first_;  ///< swath
    std::optional<std::size_t> last_;
    LinkCosts links_;
};

}  // namespace furrow
