#include "planner/path/turn_shape.h"

#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Less than this to the other side is steering, no swing.
constexpr double kSwingDeg = 12.0;
constexpr double kStraightDeg = 20.0;
constexpr double kCornerDeg = 135.0;
constexpr double kLoopDeg = 235.0;
constexpr double kStandsM = 0.01;

/// The degrees turned to the left and to the right.
struct Turned {
    double left = 0.0;
    double right = 0.0;

    double more() const { return std::max(left, right); }
    double less() const { return std::min(left, right); }
};

Turned turnedIn(std::span<const PathSegment> way) {
    Turned turned;
    for (const PathSegment& segment : way) {
        for (std::size_t i = 1; i < segment.samples.size(); ++i) {
            const double deg = inDegrees(headingDifference(radians(segment.samples[i - 1].headingRad),
                                                           radians(segment.samples[i].headingRad)));
            (deg > 0.0 ? turned.left : turned.right) += std::abs(deg);
        }
    }
    return turned;
}

/// The degrees turned on the spot between two samples at one place.
double turnedOnTheSpot(const PathSample& before, const PathSample& after) {
    return std::abs(inDegrees(headingDifference(radians(before.headingRad), radians(after.headingRad))));
}

/// "101": forwards, backwards, forwards; gears that follow on each other once.
std::vector<Gear> gearsOf(std::span<const PathSegment> way) {
    std::vector<Gear> gears;
    for (const PathSegment& segment : way) {
        if (gears.empty() || gears.back() != segment.gear) {
            gears.push_back(segment.gear);
        }
    }
    return gears;
}

}  // namespace

Message nameOf(TurnShape shape) {
    switch (shape) {
        case TurnShape::OnTheSpot: return message("turn on the spot");
        case TurnShape::Straight: return message("way straight on");
        case TurnShape::Corner: return message("corner");
        case TurnShape::U: return message("U turn");
        case TurnShape::Bulb: return message("bulb turn");
        case TurnShape::Loop: return message("loop");
        case TurnShape::Fishtail: return message("fishtail turn");
        case TurnShape::Reversing: break;
    }
    return message("turn with reversing");
}

TurnShape turnShape(std::span<const PathSegment> way) {
    const std::vector<Gear> gears = gearsOf(way);
    if (std::ranges::contains(gears, Gear::Reverse)) {
        const bool isFishtail = gears == std::vector{Gear::Forward, Gear::Reverse, Gear::Forward};
        return isFishtail ? TurnShape::Fishtail : TurnShape::Reversing;
    }
    const Turned turned = turnedIn(way);
    const double lengthM = way.back().samples.back().sM - way.front().samples.front().sM;
    if (lengthM < kStandsM && turned.more() > kStraightDeg) {
        return TurnShape::OnTheSpot;
    }
    if (turned.less() > kSwingDeg && turned.more() - turned.less() > kCornerDeg) {
        return TurnShape::Bulb;
    }
    return turned.more() < kStraightDeg ? TurnShape::Straight
           : turned.more() < kCornerDeg ? TurnShape::Corner
           : turned.more() < kLoopDeg   ? TurnShape::U
                                        : TurnShape::Loop;
}

std::vector<DrivenTurn> drivenTurns(const Path& path) {
    std::vector<DrivenTurn> turns;
    const std::span<const PathSegment> segments = path.segments;
    for (std::size_t first = 0; first < segments.size();) {
        std::size_t end = first;
        while (end < segments.size() && segments[end].kind == SegmentKind::Turn) {
            ++end;
        }
        if (end == first) {
            ++first;
            continue;
        }
        const auto way = segments.subspan(first, end - first);
        // With its neighbours' ends, from which and into which the machine may turn on the spot.
        const auto all = segments.subspan(first > 0 ? first - 1 : first,
                                          way.size() + (first > 0 ? 1 : 0) + (end < segments.size() ? 1 : 0));
        double mostDeg = 0.0;
        for (std::size_t i = 1; i < all.size(); ++i) {
            mostDeg = std::max(mostDeg, turnedOnTheSpot(all[i - 1].samples.back(), all[i].samples.front()));
        }
        const PathSample& begin = first > 0 ? all.front().samples.back() : way.front().samples.front();
        const PathSample& last =
            end < segments.size() ? all.back().samples.front() : way.back().samples.back();
        const TurnShape shape = turnShape(way);
        turns.push_back(
            {.firstSegment = first,
             .segmentCount = way.size(),
             .shape = shape == TurnShape::Straight && mostDeg > kStraightDeg ? TurnShape::OnTheSpot : shape,
             .duration = seconds(last.tS - begin.tS),
             .length = metres(way.back().samples.back().sM - way.front().samples.front().sM)});
        first = end;
    }
    return turns;
}

}  // namespace furrow
