#pragma once

#include "planner/audit/swept_area.h"

namespace furrow {

/// Where the machine drives although it works nothing there, and how often anywhere.
struct Traffic {
    double onWorkedM = 0.0;
    double onUnworkedM = 0.0;
    double longestM = 0.0;  ///< of one segment, on either
    Point longestPlace;
    std::size_t longestSegment = 0;
    int mostWheelPasses = 0;
    std::vector<Bounds> oftenSquares;  ///< those, neighbours in a row as one
    double oftenDriven = 0.0;  ///< share of the workable area driven over more than kOftenPasses times
    double squareM = 0.0;      ///< side of the squares that passes are counted in
};

inline constexpr int kOftenPasses = 3;

/// Crossed lanes: way of the reference point, implement up, over what other segments work, earlier or later;
/// the lanes that the connection leads from and to are not counted. Wheel passes: how often one of
/// two wheels, 25 cm inside the tractor's width, comes over a square; both wheels of one passage count once.
/// `along`: see mainDirection. O(states + way / square + crossings).
Result<Traffic> measureTraffic(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                               const std::vector<SweptPiece>& pieces, Point along, const JobContext& job);

}  // namespace furrow
