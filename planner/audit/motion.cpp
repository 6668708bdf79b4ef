#include "planner/audit/motion.h"

#include "planner/audit/length.h"
#include "planner/audit/tractrix.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

// Longest step of a hitch on a curve, as a share of the trailing distance. The tractrix is then within a
// millimetre of the exact one.
constexpr double kTrailingSteps = 0.04;
constexpr int kMostSteps = 4000;
// A path that spins endlessly on the spot must not fill the memory.
constexpr std::size_t kMostStates = 1'000'000;

/// Interpolates between two samples by the cubic with their tangents. It is exact to the fourth order of
/// their distance. Its direction is the heading, also if the curvature changes evenly.
class Interval {
public:
    Interval(const PathSample& from, const PathSample& to, double sign)
        : from_{from}, to_{to}, sign_{sign}, turn_{wrapped(to.headingRad - from.headingRad)} {
        const Point chord = to.position - from.position;
        const double length = lengthOf(chord);
        const double middle = from.headingRad + 0.5 * turn_ + (sign < 0.0 ? std::numbers::pi : 0.0);
        const double half = 0.5 * std::abs(turn_);
        smooth_ =
            length > 0.0 && half < 1.0 && std::abs(wrapped(std::atan2(chord.y, chord.x) - middle)) < 0.2;
        arc_ = smooth_ && half > 1e-9 ? length * half / std::sin(half) : length;
    }

    double turn() const { return turn_; }
    double length() const { return arc_; }
    bool isStraight() const { return std::abs(turn_) < 1e-9; }

    std::pair<Point, double> at(double t) const {
        if (!smooth_ || isStraight()) {
            return {from_.position + t * (to_.position - from_.position), from_.headingRad + t * turn_};
        }
        const double h = sign_ * arc_;
        const Point m0 = h * direction(from_.headingRad);
        const Point m1 = h * direction(to_.headingRad);
        const double u = 1.0 - t;
        const Point position = (1.0 + 2.0 * t) * u * u * from_.position + t * u * u * m0 +
                               t * t * (3.0 - 2.0 * t) * to_.position + -1.0 * (t * t * u) * m1;
        const Point speed = sign_ * (6.0 * t * u * (to_.position - from_.position) +
                                     (u * (1.0 - 3.0 * t)) * m0 + (t * (3.0 * t - 2.0)) * m1);
        return {position, from_.headingRad + wrapped(std::atan2(speed.y, speed.x) - from_.headingRad)};
    }

private:
    const PathSample& from_;
    const PathSample& to_;
    double sign_;
    double turn_;
    double arc_ = 0.0;
    bool smooth_ = false;
};

class Follower {
public:
    explicit Follower(const MachineShape& shape) : shape_{shape} {}

    SegmentMotion follow(const PathSegment& segment) {
        SegmentMotion motion;
        const PathSample& first = segment.samples.front();
        if (started_ && shape_.turnsOnTheSpot) {
            turnOnTheSpot(first, motion);
        }
        motion.states.push_back(moveTo(first.position, first.headingRad, motion));
        const double sign = segment.gear == Gear::Reverse ? -1.0 : 1.0;
        for (std::size_t i = 1; i < segment.samples.size(); ++i) {
            const Interval interval{segment.samples[i - 1], segment.samples[i], sign};
            if (shape_.trailingM && interval.isStraight()) {
                pullStraight(interval, motion);
            } else {
                const int steps = stepsFor(interval);
                for (int k = 1; k < steps; ++k) {
                    const auto [position, heading] = interval.at(static_cast<double>(k) / steps);
                    motion.states.push_back(moveTo(position, heading, motion));
                }
            }
            motion.states.push_back(
                moveTo(segment.samples[i].position, segment.samples[i].headingRad, motion));
        }
        return motion;
    }

private:
    void turnOnTheSpot(const PathSample& to, SegmentMotion& motion) {
        const double turn = wrapped(to.headingRad - headingRad_);
        if (std::abs(turn) < 1e-6) {
            return;
        }
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / largestTurn())));
        const double start = headingRad_;
        motion.turnOnTheSpot.push_back(moveTo(to.position, start, motion));
        for (int k = 1; k <= steps; ++k) {
            motion.turnOnTheSpot.push_back(moveTo(to.position, start + turn * k / steps, motion));
        }
    }

    /// A point at distance r from the centre of a turn leaves its chord by r a² / 8.
    double largestTurn(double radiusM = 0.0) const {
        return std::sqrt(8.0 * kChordErrorM / (radiusM + shape_.reachM + 1.0));
    }

    /// Adds states between the ends of a straight pull, dense while the implement still swings in behind.
    /// Every single step is exact, but the boom's ends draw curves.
    void pullStraight(const Interval& interval, SegmentMotion& motion) {
        const double trailing = *shape_.trailingM;
        double way = 0.0;
        while (motion.states.size() < kMostStates) {
            const double angle = std::abs(wrapped(trailedRad_ - headingRad_));
            const double aside = std::min(angle, 1.0) * trailing;
            // Between two states every movement counts as an arc. Over a long way, even a small turn makes a
            // wide arc.
            const double bulge = 0.125 * (interval.length() - way) * angle;
            if (std::max(aside, bulge) < 0.5 * kChordErrorM) {
                return;
            }
            // The middle comes in with exp(-way / trailing).
            double step = trailing * std::sqrt(4.0 * kChordErrorM / aside);
            if (angle > largestTurn()) {
                step = std::min(step, -trailing * std::log(1.0 - largestTurn() / angle));
            }
            way += step;
            if (way >= interval.length()) {
                return;
            }
            const auto [position, heading] = interval.at(way / interval.length());
            motion.states.push_back(moveTo(position, heading, motion));
        }
    }

    int stepsFor(const Interval& interval) const {
        double steps = 1.0;
        const double turn = std::abs(interval.turn());
        if (!interval.isStraight()) {
            steps = turn / largestTurn(interval.length() / turn);
        }
        if (shape_.trailingM) {
            steps = std::max(steps, interval.length() / (kTrailingSteps * *shape_.trailingM));
        }
        return std::clamp(static_cast<int>(std::ceil(steps - 1e-9)), 1, kMostSteps);
    }

    MotionState moveTo(Point position, double headingRad, SegmentMotion& motion) {
        const Point nose = direction(headingRad);
        const Point left{-nose.y, nose.x};
        MotionState state{.position = position, .headingRad = headingRad, .nose = nose};
        if (!shape_.trailingM) {
            state.implement = position + shape_.implementOffsetM * nose + shape_.lateralOffsetM * left;
            state.implementHeadingRad = headingRad;
            state.implementNose = nose;
        } else {
            const Point hitch = position + shape_.hitchOffsetM * nose;
            trailedRad_ =
                started_
                    ? trailedHeading(radians(trailedRad_), hitch - hitch_, metres(*shape_.trailingM)).si()
                    : headingRad;
            hitch_ = hitch;
            const Point back = direction(trailedRad_);
            state.implement =
                hitch - *shape_.trailingM * back + shape_.lateralOffsetM * Point{-back.y, back.x};
            state.implementHeadingRad = trailedRad_;
            state.implementNose = back;
            const double angle = std::abs(wrapped(trailedRad_ - headingRad));
            if (angle > motion.largestHitchAngleRad) {
                motion.largestHitchAngleRad = angle;
                motion.largestHitchAnglePlace = hitch;
            }
        }
        headingRad_ = headingRad;
        started_ = true;
        return state;
    }

    const MachineShape& shape_;
    bool started_ = false;
    double headingRad_ = 0.0;
    double trailedRad_ = 0.0;
    Point hitch_;
};

}  // namespace

MachineShape shapeOf(const AuditInput& input) {
    MachineShape shape;
    if (!input.machine) {
        for (const PlannedPass& pass : input.passes) {
            shape.operatingWidthM = std::max(shape.operatingWidthM, pass.width.si());
        }
        shape.reachM = 0.5 * shape.operatingWidthM;
        return shape;
    }
    const Tractor& tractor = input.machine->spec().tractor;
    const Implement& implement = input.machine->spec().implement;
    shape.operatingWidthM = implement.operatingWidth.si();
    shape.implementOffsetM = implement.offset.si();
    shape.lateralOffsetM = implement.lateralOffset.si();
    shape.hitchOffsetM = implement.hitchOffset.si();
    shape.turnsOnTheSpot = tractor.canTurnInPlace;
    const double trailing = (implement.hitchOffset - implement.offset).si();
    // An implement this close behind its hitch swings with it.
    if (implement.mounting == Mounting::Trailed && trailing > 0.05) {
        shape.trailingM = trailing;
    }
    const double side = std::abs(shape.lateralOffsetM) +
                        0.5 * std::max({shape.operatingWidthM, implement.raisedWidth.value_or(Length{}).si(),
                                        tractor.width.si()});
    const double along = std::max({(tractor.length - tractor.rearOverhang).si(), tractor.rearOverhang.si(),
                                   std::abs(shape.implementOffsetM) + 0.5 * implement.length.si()});
    shape.reachM = std::hypot(side, along);
    return shape;
}

Result<std::vector<SegmentMotion>> followPath(const AuditInput& input, const MachineShape& shape,
                                              const JobContext& job) {
    std::vector<SegmentMotion> motions;
    motions.reserve(input.segments.size());
    Follower follower{shape};
    for (const PathSegment& segment : input.segments) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        motions.push_back(follower.follow(segment));
    }
    return motions;
}

}  // namespace furrow
