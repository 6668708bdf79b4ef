#include "planner/headland/headland_passes.h"

#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/pass_tracks.h"
#include "planner/headland/smooth_ring.h"

#include <algorithm>
#include <format>

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
    {"rounded", "Rounded", "Round the corner with the machine's radius; what is left there is shown."},
    {"loop", "Loop", "Straight into the corner and on after a loop, where there is room for it."},
    {"reverse", "Reverse", "Straight into the corner and back into it on the next side."},
};

/// Rounded one inside the other, passes would leave a crescent between them at every corner, and inner ones have
/// the room of the outer ones to do better.
CornerMethod cornerMethod(const Settings& settings, std::size_t ring) {
    const std::string id = settings.choice(kHeadlandCorner);
    return id == "loop"      ? CornerMethod::Loop
           : id == "reverse" ? CornerMethod::Reverse
           : ring == 0       ? CornerMethod::Rounded
                             : CornerMethod::Quickest;
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
    int givenUp = 0;
    for (std::size_t ring = 0; ring < all.size(); ++ring) {
        const auto tracks = passTracks(task.field.workable(), all[ring], task.drivable, machine, job);
        if (!tracks) {
            return std::unexpected(tracks.error());
        }
        givenUp += tracks->givenUp;
        if (ring == 0) {
            headland.uncutStrip += tracks->movedIn;
        }
        for (const Turn& line : tracks->lines) {
            std::vector<RoundedCorner> rounded;
            headland.rings.push_back(
                {.ring = static_cast<int>(ring),
                 .width = machine.operatingWidth(),
                 .stretches = withCorners(clockwise ? reversedLine(line) : line, cornerMethod(settings, ring),
                                          task.drivable, machine, rounded)});
            for (const RoundedCorner& corner : rounded) {
                headland.uncutCorners += ring == 0 ? uncutCorner(corner, machine.operatingWidth()) : Area{};
            }
        }
    }
    if (givenUp > 0) {
        headland.notes.push_back({std::format("{} of the headland passes are too tight for this machine and are not driven",
                                              givenUp),
                                  "headland",
                                  {}});
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
