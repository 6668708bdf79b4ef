#pragma once

#include "planner/plan/stages.h"

#include <optional>

namespace furrow {

/// The parts of a mainland with their swaths one after the other in one set.
class PartCollector {
public:
    /// @param common    whose figures and notes the set begins with
    /// @param mainland  that the parts tile
    PartCollector(const SwathSet& common, const MultiPolygon& mainland);

    /// @param heading  of its own; its straight swaths then get lines of their own
    void add(MultiPolygon outline, SwathSet set, std::optional<Angle> heading);

    LaidSwaths take() { return std::move(laid_); }

private:
    LaidSwaths laid_;
};

/// The swaths of one part in a set of their own, as the methods read them.
SwathSet setOf(const SwathSet& all, const MainlandPart& part);

/// Of the chosen swath method. Errors: those of the method.
Result<SwathSet> swathsByMethod(const PlanRequest& request, const MultiPolygon& mainland,
                                const JobContext& job);

}  // namespace furrow
