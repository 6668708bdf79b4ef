#include "planner/audit/tractrix.h"

#include "planner/audit/length.h"

#include <cmath>

namespace furrow {

Angle trailedHeading(Angle heading, Point move, Length trailing) {
    const double way = lengthOf(move);
    if (way == 0.0) {
        return heading;
    }
    const double pull = std::atan2(move.y, move.x);
    const double angle = std::remainder(heading.si() - pull, 2.0 * std::numbers::pi);
    return radians(pull + 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(-way / trailing.si())));
}

}  // namespace furrow
