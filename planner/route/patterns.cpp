#include "planner/route/patterns.h"

#include "planner/route/methods.h"

#include <algorithm>
#include <numeric>

namespace furrow {

namespace {

/// If routes differ by less, the earlier one is kept.
constexpr double kSameCost = 1e-6;

constexpr Choice kCorners[] = {
    {"best", "The best corner", "Of the four corners and both ways the one with the quickest turns."},
    {"first", "The first swath", "At the start of the first swath."},
};

}  // namespace

TrackOrder toAndFroOrder(std::size_t count) {
    TrackOrder order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

TrackOrder snakeOrder(std::size_t count) {
    TrackOrder order;
    for (std::size_t i = 0; i < count; i += 2) {
        order.push_back(i);
    }
    for (std::size_t i = count / 2; i > 0; --i) {
        order.push_back(2 * i - 1);
    }
    return order;
}

TrackOrder spiralOrder(std::size_t count, std::size_t cluster) {
    TrackOrder order;
    for (std::size_t begin = 0; begin < count; begin += cluster) {
        for (const std::size_t i : snakeOrder(std::min(cluster, count - begin))) {
            order.push_back(begin + i);
        }
    }
    return order;
}

TrackOrder skipOrder(std::size_t count, std::size_t skip) {
    TrackOrder order;
    const std::size_t block = 2 * skip + 1;
    for (std::size_t begin = 0; begin < count; begin += block) {
        for (std::size_t i = 0; i < block; ++i) {
            // 0, skip + 1, 1, skip + 2, ... skip
            const std::size_t track = begin + i / 2 + (i % 2 == 0 ? 0 : skip + 1);
            if (track < count) {
                order.push_back(track);
            }
        }
    }
    return order;
}

TrackOrder racetrackOrder(std::size_t count) {
    TrackOrder order;
    const std::size_t half = (count + 1) / 2;
    for (std::size_t i = 0; i < half; ++i) {
        order.push_back(i);
        if (half + i < count) {
            order.push_back(half + i);
        }
    }
    return order;
}

std::size_t trackCount(const SwathSet& swaths) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < swaths.swaths.size(); ++i) {
        count += i == 0 || swaths.swaths[i].track != swaths.swaths[i - 1].track ? 1 : 0;
    }
    return count;
}

std::vector<RouteStep> alongTracks(const SwathSet& swaths, const TrackOrder& order, bool firstReversed) {
    std::vector<std::vector<std::size_t>> tracks;
    for (std::size_t i = 0; i < swaths.swaths.size(); ++i) {
        if (i == 0 || swaths.swaths[i].track != swaths.swaths[i - 1].track) {
            tracks.emplace_back();
        }
        tracks.back().push_back(i);
    }
    const auto isRing = [&](std::size_t track) { return swaths.swaths[tracks[track].front()].isClosed(); };
    std::vector<RouteStep> steps;
    bool reversed = firstReversed;
    for (const std::size_t track : order) {
        std::vector<std::size_t> pieces = tracks[track];
        // From ring to ring the direction stays the same.
        if (isRing(track)) {
            reversed = firstReversed;
        }
        if (reversed) {
            std::ranges::reverse(pieces);
        }
        for (const std::size_t swath : pieces) {
            steps.push_back({.swath = swath, .reversed = reversed});
        }
        reversed = !reversed;
    }
    return steps;
}

std::vector<std::vector<RouteStep>> variantsOf(const TrackOrder& order, const SwathSet& swaths,
                                               const Settings& settings) {
    std::vector<std::vector<RouteStep>> variants{alongTracks(swaths, order, false)};
    if (settings.choice(kCorner) != "best") {
        return variants;
    }
    const std::size_t last = order.empty() ? 0 : order.size() - 1;
    for (const bool mirrored : {false, true}) {
        for (const bool backwards : {false, true}) {
            TrackOrder variant = order;
            if (mirrored) {
                std::ranges::for_each(variant, [last](std::size_t& track) { track = last - track; });
            }
            if (backwards) {
                std::ranges::reverse(variant);
            }
            for (const bool firstReversed : {false, true}) {
                if (mirrored || backwards || firstReversed) {
                    variants.push_back(alongTracks(swaths, variant, firstReversed));
                }
            }
        }
    }
    return variants;
}

Result<Route> bestRoute(const TrackOrder& order, const RouteTask& task, const RouteCosts& costs,
                        const JobContext& job) {
    std::vector<std::vector<RouteStep>> variants = variantsOf(order, task.swaths, task.settings);
    Route route{.steps = variants.front(), .lengthInPlace = {}};
    if (variants.size() > 1) {
        double least = costs.links().of(endOrder(route.steps));
        for (std::vector<RouteStep>& steps : variants) {
            if (job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            if (const double cost = costs.links().of(endOrder(steps)); cost < least - kSameCost) {
                least = cost;
                route.steps = std::move(steps);
            }
        }
    }
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    route.lengthInPlace = lengthInPlace(route.steps, task.swaths);
    return route;
}

const Parameter kCorner{.key = "route.corner",
                        .name = "Start at",
                        .description = "The corner where the route starts.",
                        .kind = ParameterKind::Choice,
                        .standard = 0.0,
                        .choices = kCorners};

}  // namespace furrow
