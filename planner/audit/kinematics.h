#pragma once

#include "planner/audit/audit.h"

namespace furrow {

/// One kind of trouble: how often, how bad at worst, and where that is.
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

/// A place where the path does not go on where it was.
struct Break {
    enum class Kind {
        Jump,         ///< the position is not where the sample before leads
        Gap,          ///< the next segment begins so far away that a connection is missing
        Heading,      ///< the vehicle moves elsewhere than its nose (or rear) points
        HeadingJump,  ///< the nose turns without any way being driven
    };
    Kind kind;
    std::size_t segment = 0;  ///< in which it is, or which begins there
    Point place;
    double size = 0.0;  ///< m or rad
};

/// What the points say of the driving, re-derived from positions and headings alone.
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
    Trouble rate;                                           ///< above the machine's, 1/m²
    Trouble speed;                                          ///< above the machine's, by m/s
    Trouble lateral;                                        ///< lateral acceleration, m/s²
    Trouble time;                                           ///< runs backwards or against the speed, s
    Point reversedPlace;
};

/// O(samples).
Kinematics measureKinematics(const AuditInput& input);

}  // namespace furrow
