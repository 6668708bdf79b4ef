#include "planner/decomposition/joining.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

namespace furrow {

namespace {

// Cuts with a smaller difference of height lie on one line.
constexpr double kLevelM = 1e-6;
// Shorter borders join nothing.
constexpr double kLeastBorderM = 0.5;
// A smaller gain is rounding.
constexpr double kLeastGainS = 1e-3;

/// The length of the border that the top of one piece shares with the bottom of another, along a cut.
double borderM(const Polygon& below, const Polygon& above) {
    double length = 0.0;
    forEachEdge({below}, [&](Point a, Point b) {
        // Tops run to the left, bottoms to the right.
        if (std::abs(a.y - b.y) > kLevelM || b.x >= a.x) {
            return;
        }
        forEachEdge({above}, [&](Point c, Point d) {
            if (std::abs(c.y - d.y) > kLevelM || d.x <= c.x || std::abs(c.y - a.y) > kLevelM) {
                return;
            }
            length += std::max(0.0, std::min(a.x, d.x) - std::max(b.x, c.x));
        });
    });
    return length;
}

/// Joins one pair after the other and records the joins.
class Joiner {
public:
    Joiner(const std::vector<Border>& borders, const CellCost& cost, std::size_t pieces)
        : borders_{borders}, cost_{cost}, groups_(pieces), goesOn_(pieces, false), comesFrom_(pieces, false) {
        std::iota(groups_.begin(), groups_.end(), std::size_t{0});
    }

    Result<std::vector<Join>> run(const JobContext& job) {
        giveAwayEmpty(false);
        joinQuicker(job);
        giveAwayEmpty(true);
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        return std::move(joins_);
    }

private:
    bool mayJoin(const Border& border) const {
        return !goesOn_[border.below] && !comesFrom_[border.above] &&
               groups_[border.below] != groups_[border.above];
    }
    Join joinAt(const Border& border) const {
        return {.kept = std::min(groups_[border.below], groups_[border.above]),
                .gone = std::max(groups_[border.below], groups_[border.above])};
    }
    void join(const Border& border) {
        goesOn_[border.below] = comesFrom_[border.above] = true;
        joins_.push_back(joinAt(border));
        apply(joins_.back(), groups_);
    }
    bool isEmpty(std::size_t piece) const {
        for (std::size_t other = 0; other < groups_.size(); ++other) {
            if (groups_[other] == groups_[piece] && !cost_.isEmpty(other)) {
                return false;
            }
        }
        return true;
    }
    /// Joins cells without swaths. They change no cost, but can connect two other cells.
    /// @param anywhere  also if the neighbour already continues in another one
    void giveAwayEmpty(bool anywhere) {
        for (const Border& border : borders_) {
            const bool mayBe = anywhere ? groups_[border.below] != groups_[border.above] : mayJoin(border);
            if (mayBe && (isEmpty(border.below) || isEmpty(border.above))) {
                join(border);
            }
        }
    }
    double secondsWith(const Border& border) const {
        Groups joined = groups_;
        apply(joinAt(border), joined);
        return cost_.of(joined).si();
    }

    /// One join hardly changes the saving of another. So only the most promising ones are computed again, and
    /// all of them once none of these saves anything.
    void joinQuicker(const JobContext& job) {
        double now = cost_.of(groups_).si();
        std::vector<double> gains(borders_.size(), std::numeric_limits<double>::infinity());
        std::vector<std::size_t> workedOut(borders_.size(), joins_.size() + borders_.size() + 1);
        while (!job.stopRequested()) {
            std::optional<std::size_t> best;
            for (std::size_t i = 0; i < borders_.size(); ++i) {
                if (mayJoin(borders_[i]) && (!best || gains[i] > gains[*best])) {
                    best = i;
                }
            }
            if (!best) {
                return;
            }
            if (workedOut[*best] != joins_.size()) {
                gains[*best] = now - secondsWith(borders_[*best]);
                workedOut[*best] = joins_.size();
                continue;
            }
            if (gains[*best] < kLeastGainS) {
                // This is the best of the known ones. Another one, not promising before, may be better now.
                bool isKnown = true;
                for (std::size_t i = 0; i < borders_.size(); ++i) {
                    if (mayJoin(borders_[i]) && workedOut[i] != joins_.size()) {
                        gains[i] = std::numeric_limits<double>::infinity();
                        isKnown = false;
                    }
                }
                if (isKnown) {
                    return;
                }
                continue;
            }
            now -= gains[*best];
            join(borders_[*best]);
        }
    }

    const std::vector<Border>& borders_;
    const CellCost& cost_;
    Groups groups_;
    std::vector<bool> goesOn_;
    std::vector<bool> comesFrom_;
    std::vector<Join> joins_;
};

}  // namespace

std::vector<Border> bordersOf(const MultiPolygon& pieces) {
    std::vector<Border> borders;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            if (i != k) {
                if (const double lengthM = borderM(pieces[i], pieces[k]); lengthM > kLeastBorderM) {
                    borders.push_back({lengthM, i, k});
                }
            }
        }
    }
    std::ranges::stable_sort(borders, std::greater{}, &Border::lengthM);
    return borders;
}

void apply(const Join& join, Groups& groups) {
    std::ranges::replace(groups, join.gone, join.kept);
}

Result<std::vector<Join>> joinsWhereQuicker(const std::vector<Border>& borders, const CellCost& cost,
                                            std::size_t pieces, const JobContext& job) {
    return Joiner{borders, cost, pieces}.run(job);
}

}  // namespace furrow
