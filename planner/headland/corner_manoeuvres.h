#pragma once

#include "planner/headland/headland.h"
#include "planner/turns/rig.h"

#include <functional>
#include <vector>

namespace furrow {

/// A place where a rounded pass leaves a corner uncut.
struct RoundedCorner {
    std::size_t firstPiece = 0;  ///< of the line: the arcs that round it
    std::size_t lastPiece = 0;
    Angle turn;                  ///< positive to the left
    Point place;                 ///< between where the rounding begins and ends
    Length radius;               ///< on average
};

/// Corners of at least 45 degrees that are rounded with less than twice the machine's radius.
std::vector<RoundedCorner> roundedCorners(const Turn& line, Length radius);

/// Area that a pass of this width leaves in a corner: (tan(a/2) - a/2) (R + w/2)², at a right angle
/// (1 - pi/4) (R + w/2)².
Area uncutCorner(const RoundedCorner& corner, Length width);

/// Ways from where a machine has driven into a corner to where it goes on. A ring is often made again with fewer of its
/// corners driven into: at the others the ways are the same.
class CornerWays {
public:
    Turn between(const Rig& rig, const Pose& from, const Pose& to, const JobContext& job);

private:
    struct Known {
        Pose from;
        Pose to;
        Turn way;
    };
    std::vector<Known> known_;
};

enum class CornerMethod { Rounded, Loop, Reverse, Searched };

/// A closed pass whose corners are driven into where there is room: straight on as far as the footprint stays
/// inside, then with the implement up round a loop (forwards), with a change of gear or by whatever way is found
/// to as far back as it fits on the next side. Corners without room stay rounded.
/// @param wanted  whether a corner is to be driven into at all
/// @param ways    those of the same machine and drivable area
/// @param left    which stayed rounded
std::vector<PassStretch> withCorners(const Turn& closed, CornerMethod method, const MultiPolygon& drivable,
                                     const Machine& machine, const std::function<bool(const RoundedCorner&)>& wanted,
                                     CornerWays& ways, std::vector<RoundedCorner>& left, const JobContext& job);

}  // namespace furrow
