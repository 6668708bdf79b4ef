#include "planner/route/methods.h"
#include "planner/turns/dubins.h"

#include <algorithm>

namespace furrow {

namespace {

/// Track by track to and fro; swaths cut from one track are driven one after the other the same way.
std::vector<RouteStep> toAndFro(const SwathSet& swaths, bool lastTrackFirst, bool firstReversed) {
    std::vector<std::vector<std::size_t>> tracks;
    for (std::size_t i = 0; i < swaths.swaths.size(); ++i) {
        if (i == 0 || swaths.swaths[i].track != swaths.swaths[i - 1].track) {
            tracks.emplace_back();
        }
        tracks.back().push_back(i);
    }
    if (lastTrackFirst) {
        std::ranges::reverse(tracks);
    }
    std::vector<RouteStep> steps;
    bool reversed = firstReversed;
    for (std::vector<std::size_t>& track : tracks) {
        if (reversed) {
            std::ranges::reverse(track);
        }
        for (const std::size_t swath : track) {
            steps.push_back({.swath = swath, .reversed = reversed});
        }
        reversed = !reversed;
    }
    return steps;
}

/// Metres between swaths with the machine's own turns in free space.
Length turningLength(const std::vector<RouteStep>& steps, const SwathSet& swaths, Length radius) {
    Length sum;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        sum += dubinsLength(endPose(steps[i - 1], swaths), startPose(steps[i], swaths), radius);
    }
    return sum;
}

Result<Route> boustrophedon(const SwathSet& swaths, const Machine& machine, const Settings& settings,
                            const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    Route route{.steps = toAndFro(swaths, false, false), .lengthInPlace = {}};
    if (settings.choice(kCorner) == "best") {
        // All four corners; the earliest of equally short ones.
        Length shortest = turningLength(route.steps, swaths, machine.minTurningRadius());
        for (const auto& [lastTrackFirst, firstReversed] :
             {std::pair{false, true}, {true, false}, {true, true}}) {
            if (job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            auto steps = toAndFro(swaths, lastTrackFirst, firstReversed);
            if (const Length length = turningLength(steps, swaths, machine.minTurningRadius());
                length < shortest - metres(1e-6)) {
                shortest = length;
                route.steps = std::move(steps);
            }
        }
    }
    route.lengthInPlace = lengthInPlace(route.steps, swaths);
    return route;
}

constexpr Choice kCorners[] = {
    {"best", "The best corner", "Of the four corners the one with the shortest turns."},
    {"first", "The first swath", "At the start of the first swath."},
};

constexpr const Parameter* kParameters[] = {&kCorner};

}  // namespace

const Parameter kCorner{.key = "route.corner",
                        .name = "Start at",
                        .description = "The corner where the route starts.",
                        .kind = ParameterKind::Choice,
                        .standard = 0.0,
                        .choices = kCorners};

const Method<RoutePlanner> kBoustrophedonMethod{
    .info = {.id = "boustrophedon",
             .name = "To and fro",
             .description = "Every swath after its neighbour, back and forth.",
             .parameters = kParameters},
    .run = boustrophedon};

}  // namespace furrow
