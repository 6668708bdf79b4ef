#pragma once

#include "planner/turns/rig.h"
#include "planner/turns/travel_cost.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_map>

namespace furrow {

/// The distance to the goal on a grid of places where the tractor may stand, computed only as far as needed.
/// For searches of ways, which ask for every place once.
class GridDistance {
public:
    /// @param towards  later questions are near this place, so the search goes towards it first (Silver 2005,
    /// Cooperative Pathfinding: reverse resumable A*)
    /// @param clearance  of the tractor's middle from the edges; not required near both ends
    GridDistance(const Rig& rig, const TravelCost& travel, Point goal, Point towards, double cellM,
                 Length clearance, std::size_t mostCells)
        : rig_{rig},
          travel_{travel},
          origin_{goal},
          towards_{towards},
          cellM_{cellM},
          clearance_{clearance},
          mostCells_{mostCells} {
        open_.push({norm(towards - goal), 0, 0});
        reached_[packed(0, 0)] = {.distance = 0.0, .travel = 1.0};
    }

    /// Infinite if there is no way, or none within `most`.
    double from(Point point, double most) {
        const auto column = static_cast<std::int32_t>(std::lround((point.x - origin_.x) / cellM_));
        const auto row = static_cast<std::int32_t>(std::lround((point.y - origin_.y) / cellM_));
        Place& place = placeAt(column, row);
        // A place where nobody may stand would start a search of the whole field.
        while (!place.settled) {
            if (place.travel == 0.0 || open_.empty() || open_.top().atLeast > most ||
                settled_ == mostCells_) {
                return std::numeric_limits<double>::infinity();
            }
            settleNearest();
        }
        return place.distance;
    }

    /// More cells would have been needed for some answers.
    bool isSpent() const { return settled_ == mostCells_; }

private:
    using Cell = std::uint64_t;

    // Within 2 radii of both ends a machine may stand in places too narrow for a passing implement.
    static constexpr double kNearEndsRadii = 2.0;

    static Cell packed(std::int64_t a, std::int64_t b) {
        return static_cast<Cell>(static_cast<std::uint32_t>(a)) << 32U | static_cast<std::uint32_t>(b);
    }

    struct Place {
        double distance = std::numeric_limits<double>::infinity();
        double travel = 0.0;  ///< 0: nobody may stand there
        bool settled = false;
    };
    struct Entry {
        double atLeast;  ///< from the goal via this place to `towards_`
        std::int32_t column;
        std::int32_t row;
        bool operator<(const Entry& other) const { return atLeast > other.atLeast; }
    };

    bool mayStandAt(Point point) const {
        const double nearM = kNearEndsRadii * rig_.machine().minTurningRadius().si();
        const bool isFar = distance(point, origin_) > nearM && distance(point, towards_) > nearM;
        return rig_.mayStandAt(point, isFar ? clearance_ : Length{});
    }

    Point middleOf(std::int32_t column, std::int32_t row) const {
        return origin_ + Point{column * cellM_, row * cellM_};
    }

    Place& placeAt(std::int32_t column, std::int32_t row) {
        auto [found, isNew] = reached_.try_emplace(packed(column, row));
        if (isNew) {
            const Point middle = middleOf(column, row);
            found->second.travel = mayStandAt(middle) ? (travel_ ? travel_(middle) : 1.0) : 0.0;
        }
        return found->second;
    }

    void settleNearest() {
        const Entry nearest = open_.top();
        open_.pop();
        Place& place = reached_[packed(nearest.column, nearest.row)];
        if (place.settled) {
            return;
        }
        place.settled = true;
        ++settled_;
        const double here = place.distance;
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                const std::int32_t column = nearest.column + dx;
                const std::int32_t row = nearest.row + dy;
                Place& next = placeAt(column, row);
                const double distance = here + cellM_ * std::hypot(dx, dy) * next.travel;
                if (!next.settled && next.travel > 0.0 && distance < next.distance) {
                    next.distance = distance;
                    open_.push({distance + norm(towards_ - middleOf(column, row)), column, row});
                }
            }
        }
    }

    const Rig& rig_;
    const TravelCost& travel_;
    Point origin_;
    Point towards_;
    double cellM_;
    Length clearance_;
    std::size_t mostCells_;
    std::size_t settled_ = 0;
    std::unordered_map<Cell, Place> reached_;
    std::priority_queue<Entry> open_;
};

}  // namespace furrow
