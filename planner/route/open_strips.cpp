#include "planner/route/open_strips.h"

#include <algorithm>
#include <numeric>

namespace furrow {

OpenStripLimit::OpenStripLimit(std::size_t most, const std::vector<std::vector<std::size_t>>& cells,
                               std::size_t swathCount)
    : most_{most}, place_(swathCount, 0), cell_(swathCount, 0) {
    std::vector<std::size_t> all(swathCount);
    std::iota(all.begin(), all.end(), std::size_t{0});
    const std::vector<std::vector<std::size_t>> one{all};
    const auto& parts = cells.empty() ? one : cells;
    places_ = 1;
    for (std::size_t cell = 0; cell < parts.size(); ++cell) {
        for (const std::size_t swath : parts[cell]) {
            place_[swath] = places_++;
            cell_[swath] = cell;
        }
        ++places_;
    }
    cells_ = parts.size();
    // A swath of no cell has no neighbours.
    for (std::size_t swath = 0; swath < swathCount; ++swath) {
        if (place_[swath] == 0) {
            place_[swath] = places_;
            cell_[swath] = cells_++;
            places_ += 2;
        }
    }
}

/// Calls use(open strips) after each step, until it returns false.
template <class Use>
void OpenStripLimit::forEachStep(const EndOrder& order, const Use& use) const {
    std::vector<char> isDriven(places_ + 1, 0);
    std::vector<std::size_t> pieces(cells_, 0);
    std::size_t open = 0;
    for (const SwathEnd end : order) {
        const std::size_t swath = end / 2;
        const std::size_t place = place_[swath];
        const int neighbours = isDriven[place - 1] + isDriven[place + 1];
        isDriven[place] = 1;
        std::size_t& piecesOfCell = pieces[cell_[swath]];
        if (neighbours == 0) {
            open += piecesOfCell > 0 ? 1 : 0;
            ++piecesOfCell;
        } else if (neighbours == 2) {
            --piecesOfCell;
            --open;
        }
        if (!use(open)) {
            return;
        }
    }
}

std::size_t OpenStripLimit::excess(const EndOrder& order, std::size_t enough) const {
    std::size_t sum = 0;
    forEachStep(order, [&](std::size_t open) {
        sum += open > most_ ? open - most_ : 0;
        return sum <= enough;
    });
    return sum;
}

std::size_t OpenStripLimit::mostOpen(const EndOrder& order) const {
    std::size_t most = 0;
    forEachStep(order, [&](std::size_t open) {
        most = std::max(most, open);
        return true;
    });
    return most;
}

}  // namespace furrow
