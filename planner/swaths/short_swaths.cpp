#include "planner/swaths/short_swaths.h"

#include "planner/geometry/box_tree.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/swaths/curved_swaths.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

/// The area that only these swaths work, and the area that swaths near them work as well.
struct Worked {
    double aloneM2 = 0.0;
    double sharedM2 = 0.0;
};

Result<Worked> workedBy(const SwathSet& gone, const SwathSet& kept, const MultiPolygon& mainland,
                        const JobContext& job) {
    MultiPolygon lanes;
    for (const Swath& swath : gone.swaths) {
        addStrips(lineOf(swath), swath.width, lanes);
    }
    const Bounds box = bounds(lanes);
    MultiPolygon others;
    for (const Swath& swath : kept.swaths) {
        MultiPolygon strips;
        addStrips(lineOf(swath), swath.width, strips);
        if (meet(bounds(strips), box)) {
            std::ranges::move(strips, std::back_inserter(others));
        }
    }
    const auto whole = unionOf(lanes, job, kSnapGrid).and_then([&](const MultiPolygon& all) {
        return intersection(all, mainland, job, kSnapGrid);
    });
    const auto alone = whole.and_then([&](const MultiPolygon& all) {
        return unionOf(others, job, kSnapGrid).and_then([&](const MultiPolygon& near) {
            return difference(all, near, job, kSnapGrid);
        });
    });
    if (!alone) {
        return std::unexpected(alone.error());
    }
    const double aloneM2 = area(*alone).si();
    return Worked{.aloneM2 = aloneM2, .sharedM2 = area(*whole).si() - aloneM2};
}

}  // namespace

Length minSwathLength(const Settings& settings, const Machine& machine) {
    return settings.length(kMinLength).value_or(machine.spec().implement.length);
}

std::vector<bool> shortOnes(const SwathSet& set, Length least) {
    std::vector<bool> areShort;
    std::ranges::transform(set.swaths, std::back_inserter(areShort),
                           [least](const Swath& swath) { return swath.length() < least; });
    if (std::ranges::find(areShort, false) == areShort.end()) {
        areShort.assign(areShort.size(), false);
    }
    return areShort;
}

Result<void> leaveOut(const std::vector<bool>& shortOnes, Length least, const MultiPolygon& mainland,
                      SwathSet& set, const JobContext& job) {
    SwathSet gone;
    SwathSet kept;
    for (std::size_t i = 0; i < set.swaths.size(); ++i) {
        (shortOnes[i] ? gone : kept).swaths.push_back(set.swaths[i]);
    }
    if (gone.swaths.empty()) {
        return {};
    }
    const auto worked = workedBy(gone, kept, mainland, job);
    if (!worked) {
        return std::unexpected(worked.error());
    }
    set.coverage = std::max(0.0, set.coverage - worked->aloneM2 / area(mainland).si());
    set.overlap = std::max(Area{}, set.overlap - squareMetres(worked->sharedM2));
    set.swaths = std::move(kept.swaths);
    set.totalLength = {};
    for (std::size_t i = 0; i < set.swaths.size(); ++i) {
        set.swaths[i].number = static_cast<int>(i) + 1;
        set.totalLength += set.swaths[i].length();
    }
    set.notes.push_back(
        {.text = counted("{} swath shorter than {:.2f} m is left out",
                         "{} swaths shorter than {:.2f} m are left out", gone.swaths.size(), least.si()),
         .where = std::string{kMinLength.key},
         .place = {}});
    return {};
}

const Parameter kMinLength{
    .key = "swaths.min_length_m",
    .name = "Shortest swath",
    .description = "Swaths that are shorter are left out; auto is the implement's length.",
    .kind = ParameterKind::Length,
    .standard = {},
    .canBeAuto = true,
    .min = 0.0,
    .max = 100.0,
    .step = 0.5,
    .choices = {}};

}  // namespace furrow
