#pragma once

#include "planner/plan/stages.h"

#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace furrow {

/// The time of the driven path, with the time to work separately what it leaves. Land that is left on purpose
/// costs nothing.
Duration timeForAll(const Machine& machine, const Path& path, const AuditReport& audit);

/// The time of the quickest drivable plan among some that are made at once, of which only the quickest is
/// wanted. It falls while they are made, so it may only rule out plans that surely take longer.
class QuickestMeanwhile {
public:
    Duration time() const { return seconds(seconds_.load()); }
    void lower(Duration time) {
        for (double known = seconds_;
             time.si() < known && !seconds_.compare_exchange_weak(known, time.si());) {
        }
    }

private:
    std::atomic<double> seconds_{std::numeric_limits<double>::infinity()};
};

/// What finishing passes added to the time for all of a plan. Land that they work does not cost its own time
/// any more.
struct FinishingCost {
    Duration added;
    Area left;  ///< land within reach that was left before
};

FinishingCost finishingCost(const Driven& driven);

/// The best plan so far. Another one beats it with fewer blocking findings, or with as many in less time.
struct PlanToBeat {
    std::ptrdiff_t blocking = 0;  ///< findings
    Duration time;                ///< for all
    FinishingCost finishing;      ///< of this plan, or of one that is more like the other one
    bool finishesAlike = false;   ///< it is of a plan with the headland and the corners of the one to be made
    const QuickestMeanwhile* meanwhile = nullptr;  ///< of plans that are made at the same time
    double near = 1.0;  ///< a plan that takes so many times as long as the quickest meanwhile is wanted, too

    /// Whether a plan with a path of this duration surely is no better.
    bool isLostAfter(Duration duration) const {
        return (blocking == 0 && duration > time) ||
               (meanwhile != nullptr && duration > near * meanwhile->time());
    }
};

PlanToBeat planToBeat(const Machine& machine, const Driven& driven);

/// The error of a plan that cannot be better. It has no text, since nobody sees it.
Error noBetter(const Field& field);

/// Whether this blocks the plan, and finishing passes cannot mend it.
bool isLasting(const Finding& finding);

/// The number of such findings.
std::ptrdiff_t lastingCount(std::span<const Finding> findings);

/// What blocks in more than 25 places, neither finishing passes nor another heading make drivable.
bool isBeyondMending(std::span<const Finding> findings);

/// The number of blocking findings, then of the lasting ones among them. The lower is better: land that stays
/// unworked is better than a machine outside of the field.
std::pair<std::ptrdiff_t, std::ptrdiff_t> problems(std::span<const Finding> findings);

/// Whether a plan with this path may beat another one. Land that it misses is counted as worked separately.
bool mayBeat(const PlanToBeat& other, const Machine& machine, const Driven& driven);

/// The same before finishing passes. For equal land they are taken to cost at least a quarter of what is
/// known of another plan, with the same headland and corners four fifths. With that, this plan may be slower
/// by 1 %.
bool mayBeatFinished(const PlanToBeat& other, const Machine& machine, const Driven& unfinished);

}  // namespace furrow
