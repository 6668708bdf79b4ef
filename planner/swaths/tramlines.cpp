#include "planner/swaths/tramlines.h"

#include <algorithm>

namespace furrow {

namespace {

constexpr Choice kStarts[] = {
    {"left", "At the left edge", "The first swath on the left is one, or the line that was given."},
    {"right", "At the right edge", "The first swath on the right is one, or the line that was given."},
    {"half", "Half way in",
     "So that the wide machine begins flush with the left edge, or beside the line that was given."},
};

}  // namespace

void markTramlines(SwathSet& set, const Settings& settings) {
    const int every = *settings.count(kTramlineEvery);
    if (every == 0) {
        return;
    }
    const std::string start = settings.choice(kTramlineStart);
    const bool isHalf = start == "half";
    const bool hasLanes =
        std::ranges::any_of(set.swaths, [](const Swath& swath) { return swath.lane.has_value(); });
    std::vector<int> tracks;  // from right to left
    for (const Swath& swath : set.swaths) {
        if (tracks.empty() || tracks.back() != swath.track) {
            tracks.push_back(swath.track);
        }
    }
    for (Swath& swath : set.swaths) {
        if (hasLanes) {
            const int offset = isHalf ? every / 2 : 0;
            swath.tramline = swath.lane && ((*swath.lane - offset) % every + every) % every == 0;
            continue;
        }
        const int fromRight = static_cast<int>(std::ranges::find(tracks, swath.track) - tracks.begin());
        const int fromLeft = static_cast<int>(tracks.size()) - 1 - fromRight;
        const int counted = start == "right" ? fromRight : fromLeft;
        swath.tramline = counted % every == (isHalf ? (every - 1) / 2 : 0);
    }
}

const Parameter kTramlineEvery{
    .key = "swaths.tramline_every",
    .name = "Tramline every",
    .description = "Every how many swaths a wider machine will drive again; 0 for none.",
    .kind = ParameterKind::Count,
    .standard = 0.0,
    .min = 0.0,
    .max = 100.0,
    .choices = {}};

const Parameter kTramlineStart{.key = "swaths.tramline_start",
                               .name = "First tramline",
                               .description = "Where tramlines are counted from.",
                               .kind = ParameterKind::Choice,
                               .standard = 0.0,
                               .choices = kStarts};

}  // namespace furrow
