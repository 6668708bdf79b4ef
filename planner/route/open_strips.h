#pragma once

#include "planner/route/link_costs.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace furrow {

/// A limit for the strips that are left open while swaths are driven. An open strip is a row of neighbouring
/// swaths of one cell that are not driven yet, between two that are. With none, the driven swaths of a cell
/// are always one piece.
class OpenStripLimit {
public:
    /// @param cells  swaths of each cell in the order of their tracks; empty: all swaths are one cell
    OpenStripLimit(std::size_t most, const std::vector<std::vector<std::size_t>>& cells,
                   std::size_t swathCount);

    /// The open strips over the limit, added up over all steps. Ends early above `enough`. Cost: O(swaths).
    std::size_t excess(const EndOrder& order,
                       std::size_t enough = std::numeric_limits<std::size_t>::max()) const;
    /// The most strips that are open at a time.
    std::size_t mostOpen(const EndOrder& order) const;

private:
    template <class Use>
    void forEachStep(const EndOrder& order, const Use& use) const;

    std::size_t most_;
    std::vector<std::size_t> place_;  ///< of each swath, over all cells; a gap of one between cells
    std::vector<std::size_t> cell_;
    std::size_t cells_ = 0;
    std::size_t places_ = 0;
};

}  // namespace furrow
