#include "planner/path/speed_profile.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace furrow {

namespace {

// Samples closer than this are the same.
constexpr double kShortestStepM = 1e-6;
// A larger difference of heading is a jump: the vehicle turns on the spot.
constexpr double kHeadingJumpRad = 1e-6;

/// A stretch between two samples: a line, an arc or a piece of a clothoid.
struct Step {
    Pose from;
    Pose to;
    CurvePiece piece;
    double limitMps = 0.0;
};

/// Steps of one leg in one gear. They become a segment of the path.
struct Run {
    const Leg* leg = nullptr;
    Gear gear = Gear::Forward;
    std::vector<Step> steps;
    double pauseS = 0.0;  ///< time before it, on the spot
};

double kindLimit(SegmentKind kind, Gear gear, const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    if (gear == Gear::Reverse) {
        return tractor.reverseSpeed.si();
    }
    switch (kind) {
        case SegmentKind::Swath:
        case SegmentKind::HeadlandPass: return tractor.workingSpeed.si();
        case SegmentKind::Transfer:
        case SegmentKind::Refill: return tractor.transferSpeed.si();
        case SegmentKind::Turn:
        case SegmentKind::Wait: break;
    }
    return tractor.turningSpeed.si();
}

double sidewaysLimit(const CurvePiece& piece, const Machine& machine) {
    const double curvature = std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si()));
    return std::sqrt(machine.spec().tractor.maxLateralAcceleration.si() / curvature);
}

/// Adds the leg's samples as steps, split where the gear changes.
void addRuns(const Leg& leg, double longestMps, const Machine& machine, std::vector<Run>& runs) {
    const std::vector<CurveSample> samples = sampled(leg.line, kChordTolerance);
    const Run* open = nullptr;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const CurveSample& a = samples[i];
        const CurveSample& b = samples[i + 1];
        if (open == nullptr || a.gear != runs.back().gear) {
            runs.push_back({.leg = &leg, .gear = a.gear});
            open = &runs.back();
        }
        const CurvePiece piece{
            .length = b.way - a.way, .curvature = a.curvature, .endCurvature = b.arriving, .gear = a.gear};
        const double limit =
            std::min({kindLimit(leg.kind, a.gear, machine), sidewaysLimit(piece, machine), longestMps});
        runs.back().steps.push_back({.from = a.pose, .to = b.pose, .piece = piece, .limitMps = limit});
    }
}

/// The implement is lifted and lowered between two stretches of work. The turn is slow enough for that, or
/// has a pause if it has no length.
std::vector<Run> runsOf(std::span<const Leg> legs, const Machine& machine) {
    const double handlingS = (machine.spec().implement.liftTime + machine.spec().implement.lowerTime).si();
    std::vector<Run> runs;
    for (const Leg& leg : legs) {
        double longestMps = std::numeric_limits<double>::infinity();
        const double lengthM = leg.line.length().si();
        const bool isHandled = leg.kind == SegmentKind::Turn && handlingS > 0.0;
        if (isHandled && lengthM > kShortestStepM) {
            longestMps = lengthM / handlingS;
        }
        addRuns(leg, longestMps, machine, runs);
        if (isHandled && lengthM <= kShortestStepM) {
            runs.back().pauseS = handlingS;
        }
    }
    return runs;
}

bool jumps(const Pose& a, const Pose& b) {
    return std::abs(std::remainder((a.heading - b.heading).si(), 2.0 * std::numbers::pi)) > kHeadingJumpRad;
}

/// Speeds at the ends of every step, in order: one more than there are steps.
std::vector<double> speedsAtEnds(std::span<const Run> runs, double acceleration) {
    std::vector<double> speeds{0.0};
    std::vector<double> lengths;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const bool stops = r > 0 && (runs[r].gear != runs[r - 1].gear || runs[r].pauseS > 0.0 ||
                                     jumps(runs[r - 1].steps.back().to, runs[r].steps.front().from));
        if (stops) {
            speeds.back() = 0.0;
        }
        for (const Step& step : runs[r].steps) {
            speeds.back() = std::min(speeds.back(), step.limitMps);
            speeds.push_back(step.limitMps);
            lengths.push_back(step.piece.length.si());
        }
    }
    speeds.back() = 0.0;
    const auto reachable = [acceleration](double fromMps, double lengthM) {
        return std::sqrt(fromMps * fromMps + 2.0 * acceleration * lengthM);
    };
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        speeds[i + 1] = std::min(speeds[i + 1], reachable(speeds[i], lengths[i]));
    }
    for (std::size_t i = lengths.size(); i > 0; --i) {
        speeds[i - 1] = std::min(speeds[i - 1], reachable(speeds[i], lengths[i - 1]));
    }
    return speeds;
}

/// Writes the samples in order and adds up distance and time.
class PathWriter {
public:
    explicit PathWriter(double acceleration) : acceleration_{acceleration} {}

    void begin(const Run& run, double speedMps) {
        timeS_ += run.pauseS;
        path_.segments.push_back(
            {.kind = run.leg->kind,
             .turnType = std::string{run.leg->kind == SegmentKind::Turn ? run.leg->line.type : ""},
             .number = run.leg->number,
             .gear = run.gear,
             .implementDown = run.leg->implementDown});
        add(run.steps.front().from, run.steps.front().piece.curvature, speedMps);
    }

    /// Accelerates as long as it saves time, drives on, and brakes. `after` is the curvature at the start of
    /// the next step.
    void drive(const Step& step, double fromMps, double toMps, Curvature after) {
        const double lengthM = step.piece.length.si();
        const double peakMps = std::min(
            step.limitMps, std::sqrt(0.5 * (fromMps * fromMps + toMps * toMps) + acceleration_ * lengthM));
        const double speedingM = std::max(0.0, 0.5 * (peakMps * peakMps - fromMps * fromMps) / acceleration_);
        const double brakingM = std::max(0.0, 0.5 * (peakMps * peakMps - toMps * toMps) / acceleration_);
        const double startM = wayM_;
        double doneM = 0.0;
        double speedMps = fromMps;
        const auto goOn = [&](double untilM, double reachedMps) {
            // Constant acceleration: the mean speed is that of the ends. From stop to stop within one
            // sample's length there is a peak in between.
            const double sum = speedMps + reachedMps;
            timeS_ +=
                sum > 0.0 ? 2.0 * (untilM - doneM) / sum : 2.0 * std::sqrt((untilM - doneM) / acceleration_);
            wayM_ = startM + untilM;
            doneM = untilM;
            speedMps = reachedMps;
        };
        const auto stopOver = [&](double atM, double reachedMps) {
            if (atM > doneM + kShortestStepM && atM < lengthM - kShortestStepM) {
                goOn(atM, reachedMps);
                const Length way = metres(atM);
                add(advanced(step.from, step.piece, way), step.piece.curvatureAt(way), reachedMps);
            }
        };
        if (peakMps > std::max(fromMps, toMps) * (1.0 + 1e-9)) {
            stopOver(speedingM, peakMps);
            stopOver(lengthM - brakingM, peakMps);
        } else if (peakMps > std::min(fromMps, toMps) * (1.0 + 1e-9)) {
            // Only one of the two. The other end already has the peak speed.
            stopOver(fromMps < toMps ? speedingM : lengthM - brakingM, peakMps);
        }
        if (lengthM > doneM) {
            goOn(lengthM, toMps);
        }
        add(step.to, after, toMps);
    }

    Path take() { return std::move(path_); }

private:
    void add(const Pose& pose, Curvature curvature, double speedMps) {
        path_.segments.back().samples.push_back({.sM = wayM_,
                                                 .tS = timeS_,
                                                 .position = pose.position,
                                                 .headingRad = normalisedPoseHeading(pose.heading).si(),
                                                 .curvature1pm = curvature.si(),
                                                 .speedMps = speedMps});
    }

    Path path_;
    double acceleration_;
    double wayM_ = 0.0;
    double timeS_ = 0.0;
};

}  // namespace

Path withSpeeds(std::span<const Leg> legs, const Machine& machine) {
    const double acceleration = machine.spec().tractor.maxAcceleration.si();
    const std::vector<Run> runs = runsOf(legs, machine);
    const std::vector<double> speeds = speedsAtEnds(runs, acceleration);
    PathWriter writer{acceleration};
    std::size_t at = 0;
    for (const Run& run : runs) {
        writer.begin(run, speeds[at]);
        for (std::size_t i = 0; i < run.steps.size(); ++i, ++at) {
            const Step& step = run.steps[i];
            const bool last = i + 1 == run.steps.size();
            writer.drive(step, speeds[at], speeds[at + 1],
                         last ? step.piece.endCurvature : run.steps[i + 1].piece.curvature);
        }
    }
    return writer.take();
}

}  // namespace furrow
