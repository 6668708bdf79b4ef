#include "planner/headland/headland_passes.h"

#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/inner_passes.h"
#include "planner/headland/pass_tracks.h"
#include "planner/headland/smooth_ring.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// A strip narrower than this between the innermost pass and the mainland is rounding.
constexpr Length kLeastStrip = metres(0.01);

constexpr Choice kOrders[] = {
    {"outside-in", "From outside in", "The pass along the boundary first."},
    {"inside-out", "From inside out", "The pass along the mainland first."},
};
constexpr Choice kTimes[] = {
    {"before", "Before the mainland", "The headland is worked first."},
    {"after", "After the mainland", "The headland is worked last."},
};
constexpr Choice kDirections[] = {
    {"counter-clockwise", "Counter-clockwise", "Seen from above, turning left at corners."},
    {"clockwise", "Clockwise", "Seen from above, turning right at corners."},
};
constexpr Choice kCornerKinds[] = {
    {"rounded", "Rounded",
     "The outermost pass goes round with the machine's radius; inner ones reach into their corners."},
    {"loop", "Loop", "Straight into the corner and on after a loop, where there is room for it."},
    {"reverse", "Reverse", "Straight into the corner and back into it on the next side."},
};

CornerMethod cornerMethod(const Settings& settings) {
    const std::string id = settings.choice(kHeadlandCorner);
    return id == "loop" ? CornerMethod::Loop : id == "reverse" ? CornerMethod::Reverse : CornerMethod::Rounded;
}

/// From the edge to the line of every pass, outermost first.
std::vector<Length> insets(const Headland& headland, const Machine& machine, Length margin) {
    std::vector<Length> all;
    const Length first = margin + 0.5 * machine.workingFootprintWidth();
    for (int i = 0; i < headland.passes; ++i) {
        all.push_back(first + i * machine.operatingWidth());
    }
    // A width that holds no whole number of passes gets one more, flush with the mainland.
    const Length innermost = headland.width - 0.5 * machine.operatingWidth();
    if (headland.passes > 0 && innermost - all.back() > kLeastStrip) {
        all.push_back(innermost);
    }
    return all;
}

}  // namespace

Length uncutEdge(const Machine& machine) {
    return 0.5 * (machine.workingFootprintWidth() - machine.operatingWidth());
}

Result<void> addPasses(Headland& headland, const HeadlandTask& task, const JobContext& job) {
    const Machine& machine = task.machine;
    const Settings& settings = task.settings;
    if (!settings.flag(kHeadlandDriven) || headland.passes == 0) {
        return {};
    }
    const bool clockwise = settings.choice(kHeadlandDirection) == "clockwise";
    headland.uncutStrip = uncutEdge(machine);
    const std::vector<Length> all = insets(headland, machine, task.margin);
    const CornerMethod corners = cornerMethod(settings);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const int ring = static_cast<int>(i);
        std::vector<HeadlandPass> passes;
        if (ring > 0) {
            const auto strips = passesAlongStrips(task, all[i] - 0.5 * machine.operatingWidth(), ring, job);
            if (!strips) {
                return std::unexpected(strips.error());
            }
            passes = *strips;
        }
        bool inStretches = ring > 0 && corners == CornerMethod::Rounded;
        if (!inStretches) {
            const auto tracks = passTracks(task.field.workable(), all[i], task.drivable, machine, job);
            if (!tracks) {
                return std::unexpected(tracks.error());
            }
            inStretches = tracks->givenUp > 0;
            if (ring == 0 && !inStretches) {
                headland.uncutStrip += tracks->movedIn;
            }
            for (const Turn& line : inStretches ? std::vector<Turn>{} : tracks->lines) {
                std::vector<RoundedCorner> rounded;
                passes.push_back({.ring = ring,
                                  .width = machine.operatingWidth(),
                                  .closed = true,
                                  .stretches = withCorners(clockwise ? reversedLine(line) : line, corners,
                                                           task.drivable, machine, rounded)});
                for (const RoundedCorner& corner : rounded) {
                    headland.uncutCorners += ring == 0 ? uncutCorner(corner, machine.operatingWidth()) : Area{};
                }
            }
        }
        if (inStretches) {
            const auto inner = innerPasses(task, all[i], ring, clockwise, job);
            if (!inner) {
                return std::unexpected(inner.error());
            }
            passes.insert(passes.end(), inner->begin(), inner->end());
        }
        std::ranges::move(passes, std::back_inserter(headland.rings));
    }
    return {};
}

const Parameter kHeadlandDriven{.key = "headland.driven",
                                .name = "Work the headland",
                                .description = "Off: the strip is kept for turning only.",
                                .kind = ParameterKind::Flag,
                                .standard = 1.0,
                                .choices = {}};

const Parameter kHeadlandOrder{.key = "headland.order",
                               .name = "Passes",
                               .description = "In which order the headland passes are driven.",
                               .kind = ParameterKind::Choice,
                               .standard = 0.0,
                               .choices = kOrders};

const Parameter kHeadlandWhen{.key = "headland.when",
                              .name = "When",
                              .description = "Headland first or last.",
                              .kind = ParameterKind::Choice,
                              .standard = 0.0,
                              .choices = kTimes};

const Parameter kHeadlandDirection{.key = "headland.direction",
                                   .name = "Round the field",
                                   .description = "Which way round the headland passes are driven.",
                                   .kind = ParameterKind::Choice,
                                   .standard = 0.0,
                                   .choices = kDirections};

const Parameter kHeadlandCorner{.key = "headland.corner",
                                .name = "Corners",
                                .description = "How headland passes get round corners.",
                                .kind = ParameterKind::Choice,
                                .standard = 0.0,
                                .choices = kCornerKinds};

}  // namespace furrow
