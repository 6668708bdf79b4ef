#pragma once

#include "planner/audit/swept_area.h"

namespace furrow {

/// The places where the machine drives without work, and the number of passages everywhere.
struct Traffic {
    double onWorkedM = 0.0;
    double onUnworkedM = 0.0;
    double longestM = 0.0;  ///< of one segment, on either kind
    Point longestPlace;
    std::size_t longestSegment = 0;
    int mostWheelPasses = 0;
    std::vector<Bounds> oftenSquares;  ///< these squares, neighbours in a row as one
    double oftenDriven = 0.0;          ///< share of the workable area with more than kOftenPasses passages
    double squareM = 0.0;              ///< side of the squares in which passages are counted
};

inline constexpr int kOftenPasses = 3;

/// Crossed lanes: the distance of the reference point, implement up, over land that other segments work,
/// earlier or later. The lanes at both ends of the connection do not count. Wheel passes: the number of times
/// that one of two wheels, 25 cm inside the tractor's width, comes over a square. Both wheels of one passage
/// count once. `along`: see mainDirection. O(states + way / square + crossings).
Result<Traffic> measureTraffic(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                               const std::vector<SweptPiece>& pieces, Point along, const JobContext& job);

}  // namespace furrow
