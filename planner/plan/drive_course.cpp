#include "planner/plan/drive_course.h"

#include "planner/audit/motion.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

/// The time for the first `share` of the way between two samples, with a constant acceleration.
double timeShare(const PathSample& from, const PathSample& to, double share) {
    const double v0 = from.speedMps;
    const double v1 = to.speedMps;
    const double v = std::sqrt(std::max(0.0, v0 * v0 + share * (v1 * v1 - v0 * v0)));
    // Of a mean speed (v0 + v) / 2 over share * way, against (v0 + v1) / 2 over all of it.
    return v0 + v > 0.0 ? share * (v0 + v1) / (v0 + v) : share;
}

DriveState stateOf(const MotionState& motion, std::size_t segment) {
    return {.segment = segment,
            .position = motion.position,
            .heading = radians(motion.headingRad),
            .implement = motion.implement,
            .implementHeading = radians(motion.implementHeadingRad)};
}

bool isAt(const MotionState& state, const PathSample& sample) {
    return state.position == sample.position && state.headingRad == sample.headingRad;
}

Angle between(Angle from, Angle to, double share) {
    return from + share * headingDifference(from, to);
}

}  // namespace

void DriveCourse::add(const DriveState& state, bool works) {
    DriveState next = state;
    if (!stations_.empty()) {
        const DriveState& last = stations_.back();
        const Length way = next.driven - last.driven;
        next.worked = last.worked + (works_.back() && way > Length{} ? way : Length{});
        // Rounding must not lead back in time.
        next.time = std::max(next.time, last.time);
    }
    stations_.push_back(next);
    works_.push_back(works);
}

Result<DriveCourse> DriveCourse::of(const Plan& plan, const JobContext& job) {
    const AuditInput input = auditInput(plan);
    const auto motions = followPath(input, shapeOf(input), job);
    if (!motions) {
        return std::unexpected(motions.error());
    }
    DriveCourse course;
    for (std::size_t i = 0; i < motions->size(); ++i) {
        const SegmentMotion& motion = (*motions)[i];
        const PathSegment& segment = plan.path.segments[i];
        const PathSample& first = segment.samples.front();
        course.starts_.push_back(seconds(first.tS));
        // The turn on the spot takes the time until the segment begins.
        const double fromS = course.stations_.empty() ? first.tS : course.stations_.back().time.si();
        const std::size_t turns = motion.turnOnTheSpot.size();
        const auto fromLevel = course.stations_.empty() ? first.level : course.stations_.back().level;
        for (std::size_t k = 0; k < turns; ++k) {
            DriveState state = stateOf(motion.turnOnTheSpot[k], turnsOnTheSpotAs(plan.path.segments, i));
            state.time =
                seconds(fromS + (first.tS - fromS) * static_cast<double>(k) / static_cast<double>(turns));
            state.driven = metres(first.sM);
            if (fromLevel && first.level) {
                const double share = static_cast<double>(k) / static_cast<double>(turns);
                state.level = *fromLevel + share * (*first.level - *fromLevel);
            }
            course.add(state, false);
        }
        std::size_t begin = 0;
        for (std::size_t sample = 0; sample < segment.samples.size(); ++sample) {
            const PathSample& to = segment.samples[sample];
            std::size_t end = begin;
            while (end + 1 < motion.states.size() && !isAt(motion.states[end], to)) {
                ++end;
            }
            const PathSample& from = sample == 0 ? to : segment.samples[sample - 1];
            double wholeM = 0.0;
            for (std::size_t k = std::max<std::size_t>(begin, 1); k <= end; ++k) {
                wholeM += distance(motion.states[k - 1].position, motion.states[k].position);
            }
            double wayM = 0.0;
            for (std::size_t k = begin; k <= end; ++k) {
                wayM += k > 0 ? distance(motion.states[k - 1].position, motion.states[k].position) : 0.0;
                const double share = k == end ? 1.0 : wholeM > 0.0 ? wayM / wholeM : 0.0;
                const double t = timeShare(from, to, share);
                DriveState state = stateOf(motion.states[k], i);
                state.time = seconds(from.tS + t * (to.tS - from.tS));
                state.driven = metres(from.sM + share * (to.sM - from.sM));
                state.speed = metresPerSecond(from.speedMps + t * (to.speedMps - from.speedMps));
                if (from.level && to.level) {
                    state.level = *from.level + share * (*to.level - *from.level);
                }
                state.curvature =
                    Curvature::fromSi(from.curvature1pm + share * (to.curvature1pm - from.curvature1pm));
                course.add(state, segment.implementDown);
            }
            begin = end + 1;
        }
        if (!course.works_.empty()) {
            // What follows is the next segment's.
            course.works_.back() = false;
        }
    }
    if (course.stations_.size() < 2) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "there is no way to drive",
                                     .where = plan.field().name()});
    }
    return course;
}

std::size_t DriveCourse::stationBefore(Duration time) const {
    const auto after = std::ranges::upper_bound(stations_, time, {}, &DriveState::time);
    return after == stations_.begin() ? 0 : static_cast<std::size_t>(after - stations_.begin()) - 1;
}

DriveState DriveCourse::at(Duration time) const {
    const std::size_t before = stationBefore(time);
    const DriveState& a = stations_[before];
    if (before + 1 >= stations_.size() || time <= a.time) {
        return a;
    }
    const DriveState& b = stations_[before + 1];
    const double t = std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0);
    // The way grows with the speed.
    const double mean = a.speed.si() + b.speed.si();
    const double share = mean > 0.0 ? t * (2.0 * a.speed.si() + t * (b.speed - a.speed).si()) / mean : t;
    DriveState state = a;
    state.time = time;
    state.driven = a.driven + share * (b.driven - a.driven);
    state.worked = a.worked + share * (b.worked - a.worked);
    state.position = a.position + share * (b.position - a.position);
    state.heading = normalisedPoseHeading(between(a.heading, b.heading, share));
    state.implement = a.implement + share * (b.implement - a.implement);
    state.implementHeading = normalisedPoseHeading(between(a.implementHeading, b.implementHeading, share));
    state.speed = a.speed + t * (b.speed - a.speed);
    if (a.level && b.level) {
        // While the machine stands at a refill point, it changes with the time.
        state.level = *a.level + (b.driven > a.driven ? share : t) * (*b.level - *a.level);
    }
    state.curvature = a.curvature + share * (b.curvature - a.curvature);
    return state;
}

Angle steeringAngle(const Machine& machine, Curvature curvature) {
    return radians(std::atan(machine.spec().tractor.wheelbase.si() * curvature.si()));
}

}  // namespace furrow
