#include "planner/path/speed_profile.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/turns/straight_turn.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace furrow {

namespace {

// Samples closer than this are the same.
constexpr double kShortestStepM = 1e-6;
// A line that is moved by so little is the same: a hundredth of what chords of samples are off.
constexpr double kUnnoticedM = 5e-5;
// Below this speed stopping to steer is as quick.
constexpr double kLeastPassingMps = 0.2;
// For a derivative, 1/m.
constexpr double kNextCurvature = 1e-6;
// A jump of the curvature that takes the steering less time is drawing.
constexpr double kSteeredAtOnceS = 1e-3;

/// A stretch between two samples: a line, an arc or a piece of a clothoid.
struct Step {
    Pose from;
    Pose to;
    CurvePiece piece;
    double limitMps = 0.0;
    double pauseS = 0.0;  ///< before it: the machine steers standing
    bool steers = false;  ///< the wheels turn while it is passed, which needs all of its time
};

/// Steps of one leg in one gear. They become a segment of the path.
struct Run {
    const Leg* leg = nullptr;
    Gear gear = Gear::Forward;
    std::vector<Step> steps;
    double pauseS = 0.0;  ///< time before it, on the spot, for more than steering
    double turnsS = 0.0;  ///< before it, on the spot
    bool stands = false;  ///< before it, for any time
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

/// The speed at which the steering follows the curvature. The wheels turn fastest where they are straightest.
double steeredLimit(const CurvePiece& piece, const Machine& machine) {
    const double from = piece.curvature.si();
    const double to = piece.endCurvature.si();
    const double change = std::abs(to - from);
    if (change == 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const double flattest = from * to <= 0.0 ? 0.0 : std::min(std::abs(from), std::abs(to));
    const Curvature here = Curvature::fromSi(flattest);
    const double steersS =
        machine.steeringDuration(here, here + Curvature::fromSi(kNextCurvature)).si() / kNextCurvature;
    return piece.length.si() / (steersS * change);
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

/// The way over which steering may go from one curvature to another so that the line moves by no more than
/// drawing does: over a way w to a curvature larger by k, by k w² / 24.
double unnoticedWayM(double jump) {
    return std::sqrt(24.0 * kUnnoticedM / jump);
}

/// Divides a step in two, at a place within it. False if that place is one of its ends.
bool split(std::vector<Step>& steps, std::size_t index, double atM) {
    Step& first = steps[index];
    if (atM < kShortestStepM || atM > first.piece.length.si() - kShortestStepM) {
        return false;
    }
    const Length way = metres(atM);
    Step second = first;
    second.pauseS = 0.0;
    second.steers = false;
    second.from = advanced(first.from, first.piece, way);
    second.piece.curvature = first.piece.curvatureAt(way);
    second.piece.length = first.piece.length - way;
    first.to = second.from;
    first.piece.endCurvature = second.piece.curvature;
    first.piece.length = way;
    steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(index) + 1, second);
    return true;
}

/// Slows a run down before and after the start of a step.
void slowAround(std::vector<Step>& steps, std::size_t start, double speedMps, double halfM) {
    split(steps, start, halfM);
    steps[start].limitMps = std::min(steps[start].limitMps, speedMps);
    steps[start].steers = true;
    const bool isSplit = split(steps, start - 1, steps[start - 1].piece.length.si() - halfM);
    Step& before = steps[isSplit ? start : start - 1];
    before.limitMps = std::min(before.limitMps, speedMps);
    before.steers = true;
}

/// Where the curvature jumps, the machine stops and steers. At a small jump it only slows down, so that the
/// wheels turn while it passes. Before it sets off, it is steered already.
void addSteering(std::vector<Run>& runs, const Machine& machine) {
    const CurvePiece* before = nullptr;
    CurvePiece last;
    for (Run& run : runs) {
        for (Step& step : run.steps) {
            step.limitMps = std::min(step.limitMps, steeredLimit(step.piece, machine));
        }
        for (std::size_t i = 0; i < run.steps.size(); ++i) {
            const CurvePiece piece = run.steps[i].piece;
            const double steersS = before != nullptr
                                       ? machine.steeringDuration(before->endCurvature, piece.curvature).si()
                                       : 0.0;
            if (steersS > kSteeredAtOnceS) {
                const double jump = std::abs((piece.curvature - before->endCurvature).si());
                const double halfM =
                    i > 0 ? std::min({0.5 * unnoticedWayM(jump), piece.length.si(), before->length.si()})
                          : 0.0;
                if (halfM > kLeastPassingMps * steersS) {
                    const std::size_t size = run.steps.size();
                    slowAround(run.steps, i, halfM / steersS, halfM);
                    i += run.steps.size() - size;
                } else {
                    run.steps[i].pauseS = steersS;
                }
            }
            last = run.steps[i].piece;
            before = &last;
        }
    }
}

/// The machine turns on the spot where headings jump.
void addSpotTurns(std::vector<Run>& runs, const Machine& machine) {
    for (std::size_t r = 1; r < runs.size(); ++r) {
        runs[r].turnsS =
            turningOnTheSpot(runs[r - 1].steps.back().to, runs[r].steps.front().from, machine).si();
    }
}

/// The machine stands to fold its implement for the road, and to unfold it again.
void addFolding(std::vector<Run>& runs, const Machine& machine) {
    for (std::size_t r = 1; r < runs.size(); ++r) {
        if (runs[r].leg->folded != runs[r - 1].leg->folded) {
            runs[r].stands = true;
            runs[r].pauseS += machine.spec().implement.timeToFold.si();
        }
    }
}

/// The machine stands at refill points.
void addRefills(std::vector<Run>& runs, const Machine& machine) {
    const Duration fills = machine.spec().tank ? machine.spec().tank->fillTime() : Duration{};
    for (std::size_t r = 1; r < runs.size(); ++r) {
        if (runs[r].leg != runs[r - 1].leg && runs[r - 1].leg->refills) {
            runs[r].stands = true;
            runs[r].pauseS += fills.si();
        }
    }
}

/// The legs of a turn from `begin` on: several if it turns on the spot in between.
std::size_t endOfTurn(std::span<const Leg> legs, std::size_t begin) {
    const auto isOther = [](const Leg& leg) { return leg.kind != SegmentKind::Turn; };
    return static_cast<std::size_t>(std::ranges::find_if(legs.subspan(begin), isOther) - legs.begin());
}

/// What lifting and lowering leaves to be done while the turn of these legs is driven, beside the turns on
/// the spot.
double handlingWhileDriven(std::span<const Leg> legs, std::size_t begin, std::size_t end,
                           const Machine& machine) {
    double handlingS = (machine.spec().implement.liftTime + machine.spec().implement.lowerTime).si();
    for (std::size_t i = std::max<std::size_t>(begin, 1); handlingS > 0.0 && i <= end && i < legs.size();
         ++i) {
        handlingS -= turningOnTheSpot(legs[i - 1].line.end(), legs[i].line.start, machine).si();
    }
    return std::max(0.0, handlingS);
}

/// The implement is lifted and lowered between two stretches of work, also while the machine turns on the
/// spot. The turn is slow enough for that, or has a pause if it has no length.
std::vector<Run> runsOf(std::span<const Leg> legs, const Machine& machine, SteeringLimit steering) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < legs.size();) {
        if (legs[i].kind != SegmentKind::Turn) {
            addRuns(legs[i], std::numeric_limits<double>::infinity(), machine, runs);
            ++i;
            continue;
        }
        const std::size_t end = endOfTurn(legs, i);
        const double handledS = handlingWhileDriven(legs, i, end, machine);
        double lengthM = 0.0;
        for (const Leg& leg : legs.subspan(i, end - i)) {
            lengthM += leg.line.length().si();
        }
        const bool hasWay = lengthM > kShortestStepM;
        for (; i < end; ++i) {
            addRuns(legs[i],
                    handledS > 0.0 && hasWay ? lengthM / handledS : std::numeric_limits<double>::infinity(),
                    machine, runs);
        }
        if (handledS > 0.0 && !hasWay) {
            runs.back().pauseS = handledS;
        }
    }
    addSpotTurns(runs, machine);
    addFolding(runs, machine);
    addRefills(runs, machine);
    if (steering == SteeringLimit::Kept) {
        addSteering(runs, machine);
    }
    return runs;
}

/// Bounds of the speeds at the ends of every step, in order: one more than there are steps.
std::vector<double> speedLimitsAtEnds(std::span<const Run> runs) {
    std::vector<double> speeds{0.0};
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const bool stops = r > 0 && (runs[r].gear != runs[r - 1].gear || runs[r].pauseS > 0.0 ||
                                     runs[r].stands || runs[r].turnsS > 0.0);
        if (stops) {
            speeds.back() = 0.0;
        }
        for (const Step& step : runs[r].steps) {
            speeds.back() = step.pauseS > 0.0 ? 0.0 : std::min(speeds.back(), step.limitMps);
            speeds.push_back(step.limitMps);
        }
    }
    speeds.back() = 0.0;
    return speeds;
}

/// The same, so that the machine can speed up and brake.
void reach(std::vector<double>& speeds, std::span<const double> lengths, double acceleration) {
    const auto reachable = [acceleration](double fromMps, double lengthM) {
        return std::sqrt(fromMps * fromMps + 2.0 * acceleration * lengthM);
    };
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        speeds[i + 1] = std::min(speeds[i + 1], reachable(speeds[i], lengths[i]));
    }
    for (std::size_t i = lengths.size(); i > 0; --i) {
        speeds[i - 1] = std::min(speeds[i - 1], reachable(speeds[i], lengths[i - 1]));
    }
}

/// Where the wheels turn while a step is passed, it is passed at one speed: braking within it would take the
/// time from one side of the jump. Not beside a stop.
bool levelOut(std::vector<double>& speeds, std::span<Run> runs) {
    bool changed = false;
    std::size_t at = 0;
    for (Run& run : runs) {
        for (Step& step : run.steps) {
            const double slowest = std::min(speeds[at], speeds[at + 1]);
            if (step.steers && slowest > 0.0 && slowest < step.limitMps) {
                step.limitMps = slowest;
                changed = changed || speeds[at] != speeds[at + 1];
                speeds[at] = slowest;
                speeds[at + 1] = slowest;
            }
            ++at;
        }
    }
    return changed;
}

/// Speeds at the ends of every step. Slows steps down on which the wheels turn.
std::vector<double> speedsAtEnds(std::span<Run> runs, double acceleration) {
    std::vector<double> lengths;
    for (const Run& run : runs) {
        std::ranges::transform(run.steps, std::back_inserter(lengths),
                               [](const Step& step) { return step.piece.length.si(); });
    }
    std::vector<double> speeds = speedLimitsAtEnds(runs);
    do {
        reach(speeds, lengths, acceleration);
    } while (levelOut(speeds, runs));
    return speeds;
}

/// Writes the samples in order and adds up distance and time.
class PathWriter {
public:
    explicit PathWriter(double acceleration) : acceleration_{acceleration} {}

    void begin(const Run& run, double speedMps, bool refills) {
        // The implement is handled or folded, the wheels are steered, and the machine turns at the same time.
        timeS_ += std::max({run.pauseS, run.steps.front().pauseS, run.turnsS});
        path_.segments.push_back(
            {.kind = run.leg->kind,
             .turnType = std::string{run.leg->kind == SegmentKind::Turn ? run.leg->line.type : ""},
             .number = run.leg->number,
             .gear = run.gear,
             .implementDown = run.leg->implementDown,
             .folded = run.leg->folded,
             .refills = refills});
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

    void stand(double pauseS) { timeS_ += pauseS; }

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

Path withSpeeds(std::span<const Leg> legs, const Machine& machine, SteeringLimit steering) {
    const double acceleration = machine.spec().tractor.maxAcceleration.si();
    std::vector<Run> runs = runsOf(legs, machine, steering);
    const std::vector<double> speeds = speedsAtEnds(runs, acceleration);
    PathWriter writer{acceleration};
    std::size_t at = 0;
    for (const Run& run : runs) {
        const bool endsLeg = &run == &runs.back() || (&run + 1)->leg != run.leg;
        writer.begin(run, speeds[at], run.leg->refills && endsLeg);
        for (std::size_t i = 0; i < run.steps.size(); ++i, ++at) {
            const Step& step = run.steps[i];
            if (i > 0) {
                writer.stand(step.pauseS);
            }
            const bool last = i + 1 == run.steps.size();
            writer.drive(step, speeds[at], speeds[at + 1],
                         last ? step.piece.endCurvature : run.steps[i + 1].piece.curvature);
        }
    }
    return writer.take();
}

}  // namespace furrow
