#pragma once

#include "planner/jobs/job.h"
#include "planner/route/link_costs.h"
#include "planner/route/open_strips.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace furrow {

/// Orders of more swaths are not searched, and no bound is worked out for them: both look at all pairs of
/// ends.
inline constexpr std::size_t kMostSearched = 2'000;

/// What a search for an order starts from, and when it ends.
struct OrderSearchTask {
    const LinkCosts& costs;
    const NearEnds& near;
    std::span<const EndOrder> starts;  ///< at least one; each names every swath once
    std::size_t rounds = 0;            ///< after the first improvement of the starts
    std::uint64_t seed = 1;
    const OpenStripLimit* strips = nullptr;  ///< null: as many as there may be
};

struct FoundOrder {
    EndOrder order;
    double cost = 0.0;

    friend bool operator==(const FoundOrder&, const FoundOrder&) = default;
};

/// A cheap order of all swaths with their directions, never dearer than any of the starts. Of equal ones the
/// earlier start. With a limit for open strips, orders with less over it come before cheaper ones, and no
/// move leaves more open than before. The two cheapest starts are improved by moves that change up to three
/// links: a stretch is moved, turned round, or both, where a link becomes cheaper (2-opt, Or-opt, Or-3opt
/// with neighbour lists: Or 1976; Bentley 1992, doi 10.1287/ijoc.4.4.387). Then an order is disturbed at
/// random places and improved again, round by round (Lourenço, Martin, Stützle 2003,
/// doi 10.1007/0-306-48056-5_11). A dearer one is kept less and less often. A stop request ends the search
/// with the best order so far. The same task gives the same order. Cost: a round costs some ten microseconds,
/// and O(swaths) simple operations; with a limit O(swaths) for each move that is considered.
FoundOrder searchedOrder(const OrderSearchTask& task, const JobContext& job);

}  // namespace furrow
