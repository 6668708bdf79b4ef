#pragma once

#include "planner/turns/rig.h"
#include "planner/turns/travel_cost.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
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
        storedAt(0, 0) = {.distance = 0.0, .travel = 1.0, .isKnown = true};
    }

    GridDistance(const GridDistance&) = delete;
    GridDistance& operator=(const GridDistance&) = delete;

    /// Infinite if there is no way, or none within `most`.
    double from(Point point, double most) {
        Place& place = placeAt(columnOf(point), rowOf(point));
        while (!isAnswered(place, most)) {
            settleNearest();
        }
        return place.settled ? place.distance : std::numeric_limits<double>::infinity();
    }

    /// Whether so many more cells are enough to see a way.
    bool soonReaches(Point point, double most, std::size_t cells) {
        Place& place = placeAt(columnOf(point), rowOf(point));
        for (; cells > 0 && !isAnswered(place, most); --cells) {
            settleNearest();
        }
        return place.settled;
    }

    /// More cells would have been needed for some answers.
    bool isSpent() const { return settled_ == mostCells_; }

private:
    // Within 2 radii of both ends a machine may stand in places too narrow for a passing implement.
    static constexpr double kNearEndsRadii = 2.0;
    // Places are kept in squares of 16 by 16: neighbours mostly share theirs.
    static constexpr std::int32_t kSquareBits = 4;
    static constexpr std::int32_t kSquareSide = 1 << kSquareBits;

    struct Place {
        double distance = std::numeric_limits<double>::infinity();
        double travel = 0.0;  ///< 0: nobody may stand there
        bool settled = false;
        bool isKnown = false;  ///< whether anybody may stand there was looked at
    };
    using Square = std::array<Place, std::size_t{kSquareSide} * kSquareSide>;
    struct Entry {
        double atLeast;  ///< from the goal via this place to `towards_`
        std::int32_t column;
        std::int32_t row;
        bool operator<(const Entry& other) const { return atLeast > other.atLeast; }
    };

    /// A place where nobody may stand would start a search of the whole field.
    bool isAnswered(const Place& place, double most) const {
        return place.settled || place.travel == 0.0 || open_.empty() || open_.top().atLeast > most ||
               settled_ == mostCells_;
    }

    bool mayStandAt(Point point) const {
        const double nearM = kNearEndsRadii * rig_.machine().minTurningRadius().si();
        const bool isFar = distance(point, origin_) > nearM && distance(point, towards_) > nearM;
        return rig_.mayStandAt(point, isFar ? clearance_ : Length{});
    }

    std::int32_t columnOf(Point point) const {
        return static_cast<std::int32_t>(std::lround((point.x - origin_.x) / cellM_));
    }
    std::int32_t rowOf(Point point) const {
        return static_cast<std::int32_t>(std::lround((point.y - origin_.y) / cellM_));
    }
    Point middleOf(std::int32_t column, std::int32_t row) const {
        return origin_ + Point{column * cellM_, row * cellM_};
    }

    /// Stays where it is.
    Place& storedAt(std::int32_t column, std::int32_t row) {
        const std::int32_t squareColumn = column >> kSquareBits;
        const std::int32_t squareRow = row >> kSquareBits;
        if (last_ == nullptr || squareColumn != lastColumn_ || squareRow != lastRow_) {
            const auto key = std::uint64_t{static_cast<std::uint32_t>(squareColumn)} << 32U |
                             static_cast<std::uint32_t>(squareRow);
            last_ = &squares_[key];
            lastColumn_ = squareColumn;
            lastRow_ = squareRow;
        }
        const std::int32_t inSquare =
            (row - squareRow * kSquareSide) * kSquareSide + (column - squareColumn * kSquareSide);
        return (*last_)[static_cast<std::size_t>(inSquare)];
    }

    Place& placeAt(std::int32_t column, std::int32_t row) {
        Place& place = storedAt(column, row);
        if (!place.isKnown) {
            place.isKnown = true;
            const Point middle = middleOf(column, row);
            place.travel = mayStandAt(middle) ? (travel_ ? travel_(middle) : 1.0) : 0.0;
        }
        return place;
    }

    void settleNearest() {
        const Entry nearest = open_.top();
        open_.pop();
        Place& place = storedAt(nearest.column, nearest.row);
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
                const double distance =
                    here + cellM_ * (dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0) * next.travel;
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
    std::unordered_map<std::uint64_t, Square> squares_;
    Square* last_ = nullptr;  ///< that was asked for
    std::int32_t lastColumn_ = 0;
    std::int32_t lastRow_ = 0;
    std::priority_queue<Entry> open_;
};

}  // namespace furrow
