#include "planner/decomposition/joining.h"

#include "planner/decomposition/ledges.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// Shorter borders join nothing.
constexpr double kLeastBorderM = 0.5;
// A smaller gain is rounding.
constexpr double kLeastGainS = 1e-3;
// Pieces looked at for the cost of joins, altogether: some seconds. With up to 200 pieces a few percent of it
// are needed; with thousands of them those that share the longest borders are joined.
constexpr std::size_t kMostWork = 20'000'000;

/// A level edge of a piece: of its top, which runs to the left, or of its bottom.
struct LevelEdge {
    double y = 0.0;
    double left = 0.0;
    double right = 0.0;
    std::size_t piece = 0;
};

struct LevelEdges {
    std::vector<LevelEdge> tops;
    std::vector<LevelEdge> bottoms;
};

LevelEdges levelEdgesOf(const MultiPolygon& pieces) {
    LevelEdges edges;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        forEachEdge({pieces[piece]}, [&](Point a, Point b) {
            if (std::abs(a.y - b.y) <= kLevelM && a.x != b.x) {
                (b.x < a.x ? edges.tops : edges.bottoms)
                    .push_back({a.y, std::min(a.x, b.x), std::max(a.x, b.x), piece});
            }
        });
    }
    return edges;
}

/// Joins one pair after the other and records the joins.
class Joiner {
public:
    Joiner(const std::vector<Border>& borders, const CellCost& cost, std::size_t pieces)
        : borders_{borders}, cost_{cost}, groups_(pieces), goesOn_(pieces, false), comesFrom_(pieces, false) {
        std::iota(groups_.begin(), groups_.end(), std::size_t{0});
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            driven_.push_back(cost.isEmpty(piece) ? 0 : 1);
        }
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
        driven_[joins_.back().kept] += driven_[joins_.back().gone];
        apply(joins_.back(), groups_);
    }
    bool isEmpty(std::size_t piece) const { return driven_[groups_[piece]] == 0; }
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
    double secondsWith(const Border& border) {
        work_ += groups_.size();
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
        while (!job.stopRequested() && work_ < kMostWork) {
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
    std::vector<std::size_t> driven_;  ///< pieces with swaths of each group
    std::vector<Join> joins_;
    std::size_t work_ = 0;
};

}  // namespace

std::vector<Border> bordersOf(const MultiPolygon& pieces) {
    LevelEdges edges = levelEdgesOf(pieces);
    std::ranges::stable_sort(edges.bottoms, {}, &LevelEdge::y);
    std::map<std::pair<std::size_t, std::size_t>, double> lengths;
    for (const LevelEdge& top : edges.tops) {
        for (auto bottom = std::ranges::lower_bound(edges.bottoms, top.y - kLevelM, {}, &LevelEdge::y);
             bottom != edges.bottoms.end() && bottom->y <= top.y + kLevelM; ++bottom) {
            const double lengthM = std::min(top.right, bottom->right) - std::max(top.left, bottom->left);
            if (lengthM > 0.0 && bottom->piece != top.piece) {
                lengths[{top.piece, bottom->piece}] += lengthM;
            }
        }
    }
    std::vector<Border> borders;
    for (const auto& [pair, lengthM] : lengths) {
        if (lengthM > kLeastBorderM) {
            borders.push_back({lengthM, pair.first, pair.second});
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
