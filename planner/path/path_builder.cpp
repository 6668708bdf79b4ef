#include "planner/path/path_builder.h"

#include "planner/turns/turn_sampling.h"
#include "planner/units/angle.h"

namespace furrow {

namespace {

/// Adds segments one after the other and keeps way and time running.
class PathWriter {
public:
    void addSwath(const Swath& swath, const Pose& from, const Pose& to, Speed speed) {
        PathSegment segment{
            .kind = SegmentKind::Swath, .turnType = {}, .swath = swath.number, .implementDown = true};
        const Length length = swath.length();
        segment.samples = {sample(from, metres(0.0), {}, speed), sample(to, length, {}, speed)};
        append(std::move(segment), length, speed);
    }

    /// One segment for each stretch in one gear.
    void addTurn(const Turn& turn, int fromSwath, Speed forward, Speed backward) {
        const std::vector<TurnSample> samples = sampled(turn, kChordTolerance);
        std::size_t begin = 0;
        while (begin + 1 < samples.size()) {
            const Gear gear = samples[begin].gear;
            const Speed speed = gear == Gear::Forward ? forward : backward;
            const Length before = samples[begin].way;
            PathSegment segment{.kind = SegmentKind::Turn,
                                .turnType = std::string{turn.type},
                                .swath = fromSwath,
                                .gear = gear};
            std::size_t end = begin + 1;
            while (end + 1 < samples.size() && samples[end].gear == gear) {
                ++end;
            }
            for (std::size_t i = begin; i <= end; ++i) {
                const TurnSample& at = samples[i];
                const Curvature curvature = i == end ? at.arriving : at.curvature;
                segment.samples.push_back(sample(at.pose, at.way - before, curvature, speed));
            }
            append(std::move(segment), samples[end].way - before, speed);
            begin = end;
        }
    }

    Path take() { return std::move(path_); }

private:
    PathSample sample(const Pose& pose, Length way, Curvature curvature, Speed speed) const {
        return {.sM = (way_ + way).si(),
                .tS = (time_ + seconds(way.si() / speed.si())).si(),
                .position = pose.position,
                .headingRad = normalisedPoseHeading(pose.heading).si(),
                .curvature1pm = curvature.si(),
                .speedMps = speed.si()};
    }

    void append(PathSegment segment, Length length, Speed speed) {
        path_.segments.push_back(std::move(segment));
        way_ += length;
        time_ += seconds(length.si() / speed.si());
    }

    Path path_;
    Length way_;
    Duration time_;
};

}  // namespace

Result<Path> buildPath(const SwathSet& swaths, const Route& route, const Machine& machine, TurnPlanner* turn,
                       const JobContext& job) {
    PathWriter writer;
    const Speed working = machine.spec().tractor.workingSpeed;
    const Speed turning = machine.turningSpeed();
    for (std::size_t i = 0; i < route.steps.size(); ++i) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const RouteStep& step = route.steps[i];
        writer.addSwath(swaths.swaths[step.swath], startPose(step, swaths), endPose(step, swaths), working);
        if (i + 1 < route.steps.size()) {
            writer.addTurn(turn(endPose(step, swaths), startPose(route.steps[i + 1], swaths), machine),
                           swaths.swaths[step.swath].number, turning, machine.spec().tractor.reverseSpeed);
        }
    }
    return writer.take();
}

}  // namespace furrow
