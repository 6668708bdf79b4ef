#pragma once

#include "planner/core/message.h"
#include "planner/plan/plan.h"

#include <optional>
#include <vector>

namespace furrow {

/// A turn of another kind between the same two passes.
struct TurnOption {
    Message name;       ///< "U turn"
    Duration duration;  ///< at the speeds for turning, with changes of gear; lifting is not in it
    bool fits = false;  ///< inside the field, with the implement, a trailed one on its own track

    friend bool operator==(const TurnOption&, const TurnOption&) = default;
};

/// A turn of a plan beside what else could be driven there.
struct TurnOptions {
    /// The least distance of tractor and implement from the edge of where they may be; negative outside.
    Length clearance;
    std::vector<TurnOption> others;  ///< those that fit first, the quickest first
};

/// Of the turn that a segment of the path belongs to; nothing for other segments. Cost: that of one turn of
/// each kind, and of the rooms in which ways are searched (milliseconds, up to some tenths of a second on
/// large fields). Cancelled.
Result<std::optional<TurnOptions>> turnOptions(const Plan& plan, std::size_t segment, const JobContext& job);

}  // namespace furrow
