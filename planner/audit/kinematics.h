#pragma once

#include "planner/audit/audit.h"

namespace furrow {

/// Slower is standing.
inline constexpr double kStandingMps = 1e-6;

/// One kind of trouble: its count, its worst value, and the place of that.
struct Trouble {
    int count = 0;
    double worst = 0.0;
    Point place;
    std::size_t segment = 0;

    void add(double value, Point at, std::size_t in) {
        if (count == 0 || value > worst) {
            worst = value;
            place = at;
            segment = in;
        }
        ++count;
    }
};

/// A place where the path is not continuous.
struct Break {
    enum class Kind {
        Jump,         ///< the sample before leads to another position
        Gap,          ///< the next segment begins so far away that a connection is missing
        Heading,      ///< the vehicle moves in another direction than its nose (or rear) points
        HeadingJump,  ///< the nose turns without any distance driven
    };
    Kind kind;
    std::size_t segment = 0;  ///< the segment that contains it, or that begins there
    Point place;
    double size = 0.0;  ///< m or rad
};

/// The driving, re-derived from positions and headings only.
struct Kinematics {
    double maxCurvature1pm = 0.0;
    double maxMismatch1pm = 0.0;
    double maxRate1pm2 = 0.0;
    double maxPositionJumpM = 0.0;
    double maxHeadingJumpRad = 0.0;
    double reversedM = 0.0;
    std::vector<Break> breaks;
    std::vector<std::pair<std::size_t, Trouble>> tooTight;  ///< by segment; value 1/m
    Trouble mismatch;                                       ///< stated curvature differs, 1/m
    /// The steering is too slow for the curvature at the stated speed. The value is how many times faster it
    /// would have to be.
    Trouble steering;
    double steerableMps = 0.0;  ///< the speed that would do at the worst place
    /// The machine does not stand long enough where a folded stretch begins or ends, s that are missing. A
    /// machine that is not said to stop there misses all of them.
    Trouble folding;
    Trouble speed;              ///< above the machine's, by m/s
    Trouble lateral;            ///< lateral acceleration, m/s²
    double missingTimeS = 0.0;  ///< to drive the way at the stated speeds
    Trouble time;               ///< runs backwards or contradicts the speed, s
    Point reversedPlace;
};

/// O(samples).
Kinematics measureKinematics(const AuditInput& input);

}  // namespace furrow
