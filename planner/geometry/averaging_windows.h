#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace furrow {

/// A stretch of the given line, in metres from its start.
struct LineRange {
    double fromM = 0.0;
    double toM = 0.0;
};

/// The largest way over which curvature is averaged, along lines. Between two places it is bounded by a value
/// for that stretch. It never changes by more than the way itself, and is 0 at both ends.
class AveragingWindows {
public:
    /// @param fromM  where each stretch begins, in metres from the start, ascending, the first 0
    /// @param mostM  of each stretch
    /// @param endM   of the last one
    AveragingWindows(std::span<const double> fromM, std::span<const double> mostM, double endM);

    /// O(log stretches).
    double at(double m) const { return inStretch(m, stretchAt(m)); }
    std::size_t stretchAt(double m) const;
    /// The same as `at`. O(1) in the stretch of the time before.
    double at(double m, std::size_t& stretch) const {
        const bool isSame = (stretch == 0 || placesM_[stretch] <= m) &&
                            (stretch + 2 == placesM_.size() || m < placesM_[stretch + 1]);
        stretch = isSame ? stretch : stretchAt(m);
        return inStretch(m, stretch);
    }
    /// Up to this value, in metres, a line of 1 m radius and more moves by less than 2 mm.
    static constexpr double kKeptM = 0.2;
    /// Stretches whose value is so small. At their ends the line is tied to the given line.
    std::vector<LineRange> kept() const;
    /// Places where it begins to change otherwise.
    std::vector<double> kinks() const;

private:
    double inStretch(double m, std::size_t i) const {
        return std::max(0.0, std::min({mostM_[i], limitsM_[i] + (m - placesM_[i]),
                                       limitsM_[i + 1] + (placesM_[i + 1] - m)}));
    }

    std::vector<double> placesM_;
    std::vector<double> limitsM_;  ///< at the places
    std::vector<double> mostM_;    ///< between a place and the next
};

}  // namespace furrow
