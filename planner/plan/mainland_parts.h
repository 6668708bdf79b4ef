#pragma once

#include "planner/plan/stages.h"

#include <optional>

namespace furrow {

/// The parts of a mainland with their swaths one after the other in one set.
class PartCollector {
public:
    /// @param common    the set begins with its figures and notes
    /// @param mainland  tiled by the parts
    PartCollector(const SwathSet& common, const MultiPolygon& mainland);

    /// @param heading  of this part, if it differs from the common one; straight swaths then get their own
    /// lines
    void add(MultiPolygon outline, SwathSet set, std::optional<Angle> heading);

    LaidSwaths take() { return std::move(laid_); }

private:
    LaidSwaths laid_;
};

/// The swaths of one part in a set of their own, as the methods read them.
SwathSet setOf(const SwathSet& all, const MainlandPart& part);

/// The swaths that the chosen method lays in a mainland. Errors: those of the method. InputRefused: more than
/// 10,000 of them.
Result<SwathSet> swathsByMethod(const PlanRequest& request, const MultiPolygon& mainland,
                                const JobContext& job);

}  // namespace furrow
