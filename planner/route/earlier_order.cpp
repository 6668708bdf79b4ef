#include "planner/route/earlier_order.h"

#include "planner/geometry/segment.h"
#include "planner/route/order_search.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numbers>
#include <tuple>
#include <vector>

namespace furrow {

namespace {

/// Sine of the angle between a swath and the earlier one at its place. Swaths that were turned by more have
/// another order.
constexpr double kMostTurned = 0.35;

/// A swath at the place of an earlier one.
struct Followed {
    std::size_t step = 0;   ///< of the earlier order
    int tracksAway = 0;     ///< from the swath that lies nearest to the earlier one
    double alongM = 0.0;    ///< in the earlier direction
    double asideM = 0.0;    ///< of the earlier swath
    bool reversed = false;  ///< against the earlier direction
    std::size_t swath = 0;
};

/// How far tracks with this spacing lie beside those whose number times the spacing is whole, between minus
/// and plus half a spacing: the mean on the circle.
template <class Offsets>
double phaseM(const Offsets& offsets, double spacingM) {
    double x = 0.0;
    double y = 0.0;
    for (const double offset : offsets) {
        const double turn = 2.0 * std::numbers::pi * offset / spacingM;
        x += std::cos(turn);
        y += std::sin(turn);
    }
    return std::atan2(y, x) * spacingM / (2.0 * std::numbers::pi);
}

/// The movement of all tracks together since the earlier plan, by no more than half a spacing.
Point movedAside(const SwathSet& swaths, std::span<const DrivenSwath> earlier) {
    const Swath& first = swaths.swaths.front();
    const Swath& last = swaths.swaths.back();
    if (swaths.isCurved() || first.track == last.track) {
        return {};
    }
    const Point along = direction(swaths.heading.si());
    const Point left{-along.y, along.x};
    const double spacingM = dot(left, last.start - first.start) / (last.track - first.track);
    std::vector<double> now;
    std::vector<double> before;
    for (const Swath& swath : swaths.swaths) {
        now.push_back(dot(left, swath.start));
    }
    for (const DrivenSwath& swath : earlier) {
        before.push_back(dot(left, swath.middle));
    }
    const double byM = phaseM(now, spacingM) - phaseM(before, spacingM);
    return (byM - spacingM * std::round(byM / spacingM)) * left;
}

double distanceTo(const DrivenSwath& swath, Point place) {
    return std::min(distanceToSegment(place, swath.from, swath.middle),
                    distanceToSegment(place, swath.middle, swath.to));
}

}  // namespace

EndOrder orderAsBefore(const SwathSet& swaths, std::span<const DrivenSwath> earlier) {
    if (earlier.empty() || swaths.swaths.empty() ||
        std::max(earlier.size(), swaths.swaths.size()) > kMostSearched) {
        return {};
    }
    const Point moved = movedAside(swaths, earlier);
    std::vector<Followed> places;
    for (std::size_t i = 0; i < swaths.swaths.size(); ++i) {
        const DrivenSwath now = drivenSwath({.swath = i, .reversed = false}, swaths);
        const Point middle = now.middle - moved;
        const auto nearest = std::ranges::min_element(
            earlier, {}, [&](const DrivenSwath& swath) { return distanceTo(swath, middle); });
        const Point along = nearest->to - nearest->from;
        if (std::abs(cross(along, now.to - now.from)) >
            kMostTurned * norm(along) * distance(now.from, now.to)) {
            return {};
        }
        places.push_back({.step = static_cast<std::size_t>(nearest - earlier.begin()),
                          .alongM = dot(along, middle - nearest->from) / std::max(norm(along), 1.0),
                          .asideM = distanceTo(*nearest, middle),
                          .reversed = dot(along, now.to - now.from) < 0.0,
                          .swath = i});
    }
    std::vector<int> ownTrack(earlier.size());
    std::vector<double> least(earlier.size(), std::numeric_limits<double>::infinity());
    for (const Followed& place : places) {
        if (place.asideM < least[place.step]) {
            least[place.step] = place.asideM;
            ownTrack[place.step] = swaths.swaths[place.swath].track;
        }
    }
    for (Followed& place : places) {
        place.tracksAway = std::abs(swaths.swaths[place.swath].track - ownTrack[place.step]);
        if (place.tracksAway % 2 == 1) {
            place.reversed = !place.reversed;
            place.alongM = -place.alongM;
        }
    }
    std::ranges::sort(places, {}, [](const Followed& place) {
        return std::tuple{place.step, place.tracksAway, place.alongM, place.swath};
    });
    EndOrder order;
    std::ranges::transform(places, std::back_inserter(order), [](const Followed& place) {
        return enteredEnd({.swath = place.swath, .reversed = place.reversed});
    });
    return order;
}

}  // namespace furrow
