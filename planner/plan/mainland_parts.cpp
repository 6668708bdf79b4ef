#include "planner/plan/mainland_parts.h"

#include "planner/plan/method_registry.h"
#include "planner/swaths/heading_search.h"

#include <algorithm>

namespace furrow {

namespace {

/// Tracks are counted before they are laid, the pieces into which an outline cuts them only here. Orders take
/// time with the square of their number.
Result<SwathSet> checkedCount(SwathSet set) {
    if (set.swaths.size() <= kMostSwaths) {
        return set;
    }
    return std::unexpected(
        Error{.code = ErrorCode::InputRefused,
              .what = message("the outline cuts the tracks into {} swaths, and no plan may have more than {}",
                              set.swaths.size(), kMostSwaths),
              .where = "swaths",
              .remedy = "plan parts of the field by themselves, choose another heading, or take small "
                        "obstacles out of the boundary"});
}

}  // namespace

PartCollector::PartCollector(const SwathSet& common, const MultiPolygon& mainland)
    : laid_{.swaths = common, .parts = {}, .mainland = mainland} {
    laid_.swaths.swaths.clear();
    laid_.swaths.totalLength = {};
}

void PartCollector::add(MultiPolygon outline, SwathSet set, std::optional<Angle> heading) {
    MainlandPart part{.outline = std::move(outline),
                      .firstSwath = laid_.swaths.swaths.size(),
                      .swathCount = set.swaths.size(),
                      .heading = heading};
    for (Swath& swath : set.swaths) {
        swath.number = static_cast<int>(laid_.swaths.swaths.size()) + 1;
        if (heading && !swath.isCurved()) {
            swath.curve = lineOf(swath);
        }
        laid_.swaths.totalLength += swath.length();
        laid_.swaths.swaths.push_back(std::move(swath));
    }
    laid_.parts.push_back(std::move(part));
}

SwathSet setOf(const SwathSet& all, const MainlandPart& part) {
    SwathSet set = all;
    set.heading = part.heading.value_or(all.heading);
    const auto first = all.swaths.begin() + static_cast<std::ptrdiff_t>(part.firstSwath);
    set.swaths.assign(first, first + static_cast<std::ptrdiff_t>(part.swathCount));
    return set;
}

Result<SwathSet> swathsByMethod(const PlanRequest& request, const MultiPolygon& mainland,
                                const JobContext& job) {
    if (mainland.empty()) {
        return SwathSet{.coverage = 1.0};
    }
    return swathMethod(request.settings)
        .run({.field = *request.field,
              .mainland = mainland,
              .machine = request.machine,
              .settings = request.settings,
              .guides = request.guides.get()},
             job)
        .and_then(checkedCount);
}

}  // namespace furrow
