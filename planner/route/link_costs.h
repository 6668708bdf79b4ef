#pragma once

#include "planner/route/route.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace furrow {

/// An end of a swath: 2 i where swath i starts, 2 i + 1 where it ends. A swath is entered at one of them and
/// left at the other one.
using SwathEnd = std::uint32_t;

constexpr SwathEnd otherEnd(SwathEnd end) {
    return end ^ 1U;
}
constexpr SwathEnd enteredEnd(const RouteStep& step) {
    return static_cast<SwathEnd>(2 * step.swath + (step.reversed ? 1 : 0));
}
constexpr RouteStep stepEntering(SwathEnd end) {
    return {.swath = end / 2, .reversed = end % 2 == 1};
}

/// An order of swaths with their directions: the ends at which they are entered.
using EndOrder = std::vector<SwathEnd>;

EndOrder endOrder(const std::vector<RouteStep>& steps);
std::vector<RouteStep> stepsOf(const EndOrder& order);

/// What it costs to get from one swath to another, in any unit. Costs are looked up when they are first asked
/// for, and kept in a table of bounded size. A link costs what it costs in free space until it is checked;
/// then it costs what the way that fits into the field costs, which is never less. Not for several threads.
class LinkCosts {
public:
    using LinkCost = std::function<double(SwathEnd leaving, SwathEnd entered)>;
    using EndCost = std::function<double(SwathEnd end)>;

    struct Functions {
        LinkCost link;     ///< from where one swath is left to where another is entered; finite, not negative
        LinkCost atLeast;  ///< a lower bound that is quicker to compute; empty: none but the cost itself
        EndCost begin;     ///< to the end at which the first swath is entered; empty: 0
        EndCost finish;    ///< from the end at which the last swath is left; empty: 0
        /// What a link costs in the field. Empty, or without a value, where that is not to be known.
        std::function<std::optional<double>(SwathEnd leaving, SwathEnd entered)> fitting;
    };

    LinkCosts(std::size_t swathCount, Functions functions);

    std::size_t swathCount() const { return swathCount_; }
    std::size_t endCount() const { return 2 * swathCount_; }

    double link(SwathEnd leaving, SwathEnd entered) const {
        const std::uint64_t key = keyOf(leaving, entered);
        Entry& entry = table_[slotOf(key)];
        if (entry.key != key) {
            entry = {key, lookedUp(key, leaving, entered)};
        }
        return entry.cost;
    }
    /// From now on the link costs what it costs in the field.
    /// @return whether it became dearer
    bool check(SwathEnd leaving, SwathEnd entered);
    /// The cost of the link if it was looked up before, or else no more than that, for less.
    double knownOrLess(SwathEnd leaving, SwathEnd entered) const {
        const std::uint64_t key = keyOf(leaving, entered);
        const Entry& entry = table_[slotOf(key)];
        return entry.key == key     ? entry.cost
               : functions_.atLeast ? functions_.atLeast(leaving, entered)
                                    : link(leaving, entered);
    }
    /// No more than the cost of the link, in either direction of driving.
    double atLeast(SwathEnd a, SwathEnd b) const;
    /// The cheaper of both directions in which this link may be driven.
    double eitherWay(SwathEnd a, SwathEnd b) const;
    double begin(SwathEnd entered) const { return functions_.begin ? functions_.begin(entered) : 0.0; }
    double finish(SwathEnd left) const { return functions_.finish ? functions_.finish(left) : 0.0; }

    /// Of all links of an order.
    double between(const EndOrder& order) const;
    /// With its way in and its way out.
    double of(const EndOrder& order) const;

private:
    struct Entry {
        std::uint64_t key = std::numeric_limits<std::uint64_t>::max();
        double cost = 0.0;
    };
    std::uint64_t keyOf(SwathEnd leaving, SwathEnd entered) const {
        return std::uint64_t{leaving} * endCount() + entered;
    }
    std::size_t slotOf(std::uint64_t key) const {
        return static_cast<std::size_t>(isWhole_ ? key : (key * 0x9E3779B97F4A7C15ULL) >> shift_);
    }
    double lookedUp(std::uint64_t key, SwathEnd leaving, SwathEnd entered) const {
        const auto known = checked_.find(key);
        return known != checked_.end() ? known->second : functions_.link(leaving, entered);
    }
    bool isKnown(SwathEnd leaving, SwathEnd entered) const {
        const std::uint64_t key = keyOf(leaving, entered);
        return table_[slotOf(key)].key == key;
    }

    std::size_t swathCount_;
    Functions functions_;
    bool isWhole_;  ///< every link has a place of its own
    int shift_;
    mutable std::vector<Entry> table_;
    std::unordered_map<std::uint64_t, double> checked_;
};

/// The cheapest links of an end, among which searches and bounds look first.
inline constexpr std::size_t kNearLinks = 10;

/// For every end the cheapest links, the cheapest first.
struct NearEnds {
    std::vector<std::vector<SwathEnd>> enteredFrom;  ///< [leaving]: ends to enter next
    std::vector<std::vector<SwathEnd>> leftBefore;   ///< [entered]: ends left before
};

/// @param count  of links for each end
/// Cost: O(ends²) lower bounds, and `count` links or some more for each end.
NearEnds nearEnds(const LinkCosts& costs, std::size_t count);

}  // namespace furrow
