#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/headland/headland.h"
#include "planner/turns/rig.h"

#include <functional>
#include <vector>

namespace furrow {

/// Into a sharp corner the machine drives no farther than 2 widths past the point where the sides meet.
inline constexpr double kMostWidthsOnward = 2.0;

/// A corner that a rounded pass leaves uncut.
struct RoundedCorner {
    std::size_t firstPiece = 0;  ///< of the line: the first arc that rounds it
    std::size_t lastPiece = 0;
    Angle turn;     ///< positive to the left
    Point place;    ///< the middle between the ends of the rounding
    Length radius;  ///< on average
};

/// Corners of at least 45 degrees that are rounded with less than twice the machine's radius.
std::vector<RoundedCorner> roundedCorners(const Curve& line, Length radius);

/// The area that a pass of this width leaves in a corner: (tan(a/2) - a/2) (R + w/2)². At a right angle this
/// is (1 - pi/4) (R + w/2)².
Area uncutCorner(const RoundedCorner& corner, Length width);

/// Ways from the end of the drive into a corner to the start on the next side. A ring is often made again
/// with fewer driven corners. The ways at the others are then the same.
class CornerWays {
public:
    Curve between(const Rig& rig, const Pose& from, const Pose& to, const JobContext& job);

private:
    struct Known {
        Pose from;
        Pose to;
        Curve way;
    };
    std::vector<Known> known_;
};

enum class CornerMethod { Rounded, Loop, Reverse, Searched };

/// A closed pass that is driven into its corners if there is room. It goes straight on as far as the
/// footprint stays inside. Then, with the implement up, it drives a loop (forwards), reverses, or takes the
/// way that a search finds. It continues on the next side from as far back as it fits. Corners without room
/// stay rounded.
/// @param wanted  whether to drive into a corner at all
/// @param ways    of the same machine and drivable area
/// @param left    corners that stayed rounded
std::vector<PassStretch> withCorners(const Curve& closed, CornerMethod method, const AllowedAreas& drivable,
                                     const Machine& machine,
                                     const std::function<bool(const RoundedCorner&)>& wanted,
                                     CornerWays& ways, std::vector<RoundedCorner>& left,
                                     const JobContext& job);

}  // namespace furrow
