#include "planner/turns/travel_cost.h"

#include <algorithm>

namespace furrow {

double meanCost(const TravelCost& travel, const Pose& from, const CurvePiece& piece, Length step) {
    if (!travel) {
        return 1.0;
    }
    const auto steps = std::max(1, static_cast<int>(piece.length / step));
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += travel(advanced(from, piece, piece.length * ((i + 0.5) / steps)).position);
    }
    return sum / steps;
}

}  // namespace furrow
