#include "planner/audit/kinematics.h"

#include "planner/audit/length.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace furrow {

namespace {

// Larger ones are breaks. Smaller ones only appear in the figures. Chords of samples are within 1 cm.
constexpr double kJumpM = 0.05;
constexpr double kHeadingJumpRad = 0.02;
constexpr double kNoJumpM = 1e-9;
/// If the next segment begins farther away, a segment in between is missing.
constexpr double kGapM = 2.0;
// Over shorter ways, rounding of positions and headings hides the curvature.
constexpr double kShortestWayM = 1e-3;
constexpr double kCurvatureShare = 1.002;
constexpr double kSpeedShare = 1.001;
// Samples show the mean of a step. Noise of positions on short steps is far below the second value.
constexpr double kSteeringShare = 1.05;
constexpr double kSteeredAtOnceS = 0.02;
// Times of folding may differ by rounding.
constexpr double kFoldedS = 1e-3;
// Files of others state places to a millimetre.
constexpr double kPlaceNoiseM = 3e-4;

/// The movement from one sample to the next, from the points only.
struct Step {
    double wayM = 0.0;
    double turnRad = 0.0;
    double jumpM = 0.0;        ///< between the second point and the place to which the first one leads
    double sidewaysRad = 0.0;  ///< between the direction of movement and the heading of the vehicle
    double changed1pm = 0.0;   ///< the curvature's change from begin to end

    bool standsStill() const { return wayM < 1e-9; }
};

Step stepBetween(const PathSample& a, const PathSample& b, double gear) {
    const Point chord = b.position - a.position;
    Step step{.wayM = lengthOf(chord), .turnRad = wrapped(b.headingRad - a.headingRad)};
    const double half = 0.5 * std::abs(step.turnRad);
    const double chordShare = half > 1e-9 ? std::sin(half) / half : 1.0;
    const double driven = b.sM - a.sM;
    const double middle = a.headingRad + 0.5 * step.turnRad + (gear < 0.0 ? std::numbers::pi : 0.0);
    // If the curvature changes evenly, the chord leads aside by a twelfth of its change.
    const double skew = -(b.curvature1pm - a.curvature1pm) * driven * gear / 12.0;
    const auto missBy = [&](double aside) {
        return lengthOf(chord - driven * chordShare * direction(middle + aside));
    };
    step.jumpM = missBy(0.0);
    if (step.jumpM > kNoJumpM) {
        step.jumpM = std::min(step.jumpM, missBy(skew));
    }
    if (step.wayM > kShortestWayM) {
        const double moved = std::atan2(chord.y, chord.x);
        const double plain = std::abs(wrapped(moved - middle));
        step.sidewaysRad = std::min(plain, std::abs(wrapped(moved - middle - skew)));
        step.wayM /= std::max(chordShare, 0.5);
        step.changed1pm = -12.0 * wrapped(moved - middle) / (step.wayM * gear);
    }
    return step;
}

/// The time that the machine stands between two samples, at the end with speed 0. The acceleration is
/// constant.
double standsS(const PathSample& a, const PathSample& b) {
    const double allS = b.tS - a.tS;
    const double sum = a.speedMps + b.speedMps;
    return sum > 1e-9 ? std::max(0.0, allS - 2.0 * (b.sM - a.sM) / sum) : 0.0;
}

/// The time half-way between two samples.
double halfWayS(const PathSample& a, const PathSample& b) {
    const double change = b.speedMps - a.speedMps;
    const double middle = std::sqrt(0.5 * (a.speedMps * a.speedMps + b.speedMps * b.speedMps));
    const double share = std::abs(change) > 1e-6 ? (middle - a.speedMps) / change : 0.5;
    const double stoodS = standsS(a, b);
    return a.tS + (a.speedMps <= b.speedMps ? stoodS : 0.0) + share * (b.tS - a.tS - stoodS);
}

struct Limits {
    double curvature1pm = std::numeric_limits<double>::infinity();
    bool hasSteering = false;  ///< the machine states how fast it steers
    double lateralMps2 = std::numeric_limits<double>::infinity();
    const Tractor* tractor = nullptr;

    double speedOf(const PathSegment& segment) const {
        if (tractor == nullptr) {
            return std::numeric_limits<double>::infinity();
        }
        if (segment.gear == Gear::Reverse) {
            return std::max(tractor->reverseSpeed, tractor->turningSpeed).si();
        }
        switch (segment.kind) {
            case SegmentKind::Swath:
            case SegmentKind::HeadlandPass: return tractor->workingSpeed.si();
            // A curve is entered and left at the speed of the stretch that it joins.
            case SegmentKind::Turn: return std::max(tractor->turningSpeed, tractor->workingSpeed).si();
            default: return std::max(tractor->transferSpeed, tractor->workingSpeed).si();
        }
    }
};

Limits limitsOf(const AuditInput& input) {
    Limits limits;
    if (!input.machine) {
        return limits;
    }
    const Tractor& tractor = input.machine->spec().tractor;
    limits.tractor = &tractor;
    limits.curvature1pm = 1.0 / input.machine->minTurningRadius().si();
    limits.lateralMps2 = tractor.maxLateralAcceleration.si();
    limits.hasSteering = tractor.maxCurvatureRate || tractor.steeringRateRadps;
    return limits;
}

class Meter {
public:
    explicit Meter(const AuditInput& input) : input_{input}, limits_{limitsOf(input)} {}

    Kinematics measure() {
        for (std::size_t i = 0; i < input_.segments.size(); ++i) {
            const PathSegment& segment = input_.segments[i];
            if (i > 0) {
                join(input_.segments[i - 1], segment, i);
            }
            drive(segment, i);
        }
        return std::move(found_);
    }

private:
    /// The step before.
    struct Last {
        double curvature;
        double wayM;
        double ends;  ///< its curvature at its end
        double halfWayS;
        double standsAtEndS;
        double gear;
    };

    void join(const PathSegment& before, const PathSegment& next, std::size_t index) {
        const PathSample& from = before.samples.back();
        const PathSample& to = next.samples.front();
        const double gap = distance(from.position, to.position);
        found_.maxPositionJumpM = std::max(found_.maxPositionJumpM, gap);
        if (gap > kGapM) {
            found_.breaks.push_back({Break::Kind::Gap, index, from.position, gap});
        } else if (gap > kJumpM) {
            found_.breaks.push_back({Break::Kind::Jump, index, from.position, gap});
        }
        const double turn = std::abs(wrapped(to.headingRad - from.headingRad));
        if (input_.statedMotion && gap <= kGapM) {
            found_.maxHeadingJumpRad = std::max(found_.maxHeadingJumpRad, turn);
            if (turn > kHeadingJumpRad) {
                found_.breaks.push_back({Break::Kind::HeadingJump, index, from.position, turn});
            }
        }
        if (gap > kJumpM || turn > kHeadingJumpRad) {
            last_.reset();
        }
        if (last_) {
            last_->standsAtEndS += to.tS - from.tS;
        }
        if (before.folded != next.folded) {
            checkFolding(from, to, index);
        }
        if (input_.statedMotion && (to.tS < from.tS - 1e-6 || to.sM < from.sM - 1e-6)) {
            found_.time.add(from.tS - to.tS, to.position, index);
        }
    }

    /// From one stretch to the next the machine stands, folding its implement or unfolding it.
    void checkFolding(const PathSample& from, const PathSample& to, std::size_t index) {
        if (!input_.statedMotion || !input_.machine) {
            return;
        }
        const double foldsS = input_.machine->spec().implement.timeToFold.si();
        const bool stands = std::max(from.speedMps, to.speedMps) <= kStandingMps;
        const double missingS = foldsS - (stands ? to.tS - from.tS : 0.0);
        if (!stands || missingS > kFoldedS) {
            found_.folding.add(missingS, from.position, index);
        }
    }

    void drive(const PathSegment& segment, std::size_t index) {
        const double gear = segment.gear == Gear::Reverse ? -1.0 : 1.0;
        const double speedLimit = limits_.speedOf(segment);
        Trouble tight;
        for (std::size_t k = 1; k < segment.samples.size(); ++k) {
            const PathSample& a = segment.samples[k - 1];
            const PathSample& b = segment.samples[k];
            if (gear < 0.0) {
                if (found_.reversedM == 0.0) {
                    found_.reversedPlace = a.position;
                }
                found_.reversedM += lengthOf(b.position - a.position);
            }
            if (!input_.statedMotion) {
                continue;
            }
            driveStep(a, b, gear, index, tight);
            checkTime(a, b, index);
            for (const PathSample* sample : {&a, &b}) {
                if (sample->speedMps > speedLimit * kSpeedShare) {
                    found_.speed.add(sample->speedMps - speedLimit, sample->position, index);
                }
                const double lateral = sample->speedMps * sample->speedMps * std::abs(sample->curvature1pm);
                if (lateral > limits_.lateralMps2 * 1.01) {
                    found_.lateral.add(lateral, sample->position, index);
                }
            }
        }
        if (tight.count > 0) {
            found_.tooTight.emplace_back(index, tight);
        }
    }

    void driveStep(const PathSample& a, const PathSample& b, double gear, std::size_t index, Trouble& tight) {
        const Step step = stepBetween(a, b, gear);
        found_.maxPositionJumpM = std::max(found_.maxPositionJumpM, step.jumpM);
        if (step.standsStill()) {
            const double turn = std::abs(step.turnRad);
            found_.maxHeadingJumpRad = std::max(found_.maxHeadingJumpRad, turn);
            if (turn > kHeadingJumpRad) {
                found_.breaks.push_back({Break::Kind::HeadingJump, index, a.position, turn});
                last_.reset();
            }
            return;
        }
        found_.maxHeadingJumpRad = std::max(found_.maxHeadingJumpRad, step.sidewaysRad);
        // A sample off the line shows as both kinds. It is the position that jumps if the nose still points
        // along the chord, or if the distance differs from the stated one.
        const bool sideways = step.sidewaysRad > kHeadingJumpRad && step.wayM > kJumpM;
        const double driven = b.sM - a.sM;
        const bool wayDiffers = std::abs(lengthOf(b.position - a.position) - driven) > kJumpM + 0.02 * driven;
        if (sideways && !wayDiffers) {
            found_.breaks.push_back({Break::Kind::Heading, index, a.position, step.sidewaysRad});
        } else if (step.jumpM > kJumpM) {
            found_.breaks.push_back({Break::Kind::Jump, index, a.position, step.jumpM});
        }
        if (sideways || step.jumpM > kJumpM || step.wayM < kShortestWayM) {
            last_.reset();
            return;
        }
        const double curvature = gear * step.turnRad / step.wayM;
        found_.maxCurvature1pm = std::max(found_.maxCurvature1pm, std::abs(curvature));
        if (std::abs(curvature) > limits_.curvature1pm * kCurvatureShare + 1e-9 / step.wayM) {
            tight.add(std::abs(curvature), a.position, index);
        }
        const auto [low, high] = std::minmax(a.curvature1pm, b.curvature1pm);
        const double mismatch = std::max({0.0, low - curvature, curvature - high});
        found_.maxMismatch1pm = std::max(found_.maxMismatch1pm, mismatch);
        if (mismatch > 0.005 + 1e-6 / step.wayM) {
            found_.mismatch.add(mismatch, a.position, index);
        }
        if (last_) {
            const double rate = std::abs(curvature - last_->curvature) / (0.5 * (step.wayM + last_->wayM));
            if (last_->gear == gear) {
                found_.maxRate1pm2 = std::max(found_.maxRate1pm2, rate);
            }
            checkSteering(*last_, {curvature, step, a, b}, index);
        }
        const double standsAtEndS = b.speedMps < a.speedMps ? standsS(a, b) : 0.0;
        last_ = {curvature, step.wayM, curvature + 0.5 * step.changed1pm, halfWayS(a, b), standsAtEndS, gear};
    }

    struct Present {
        double curvature;
        const Step& step;
        const PathSample& a;
        const PathSample& b;
    };

    double steeringS(double from, double to) const {
        return input_.machine->steeringDuration(Curvature::fromSi(from), Curvature::fromSi(to)).si();
    }

    /// The time from the middle of one step to the middle of the next, and the time that the machine stands
    /// between them if the curvature jumps there. Long steps show a jump, short ones a change.
    void checkSteering(const Last& last, const Present& now, std::size_t index) {
        if (!limits_.hasSteering) {
            return;
        }
        const auto check = [&](double needsS, double hasS) {
            if (needsS <= kSteeringShare * hasS + kSteeredAtOnceS) {
                return false;
            }
            const double times = std::min(needsS / std::max(hasS, 1e-9), 1e6);
            if (found_.steering.count == 0 || times > found_.steering.worst) {
                found_.steerableMps = std::max(now.a.speedMps, now.b.speedMps) / times;
            }
            found_.steering.add(times, now.a.position, index);
            return true;
        };
        if (check(steeringS(last.curvature, now.curvature), halfWayS(now.a, now.b) - last.halfWayS)) {
            return;
        }
        const auto noise = [](double wayM) { return 12.0 * kPlaceNoiseM / (wayM * wayM); };
        const double begins = now.curvature - 0.5 * now.step.changed1pm;
        const double jump = std::abs(begins - last.ends) - noise(last.wayM) - noise(now.step.wayM);
        if (jump > 0.0) {
            const double standsFirstS = now.a.speedMps <= now.b.speedMps ? standsS(now.a, now.b) : 0.0;
            check(steeringS(last.ends, begins) * jump / std::abs(begins - last.ends),
                  last.standsAtEndS + standsFirstS);
        }
    }

    void checkTime(const PathSample& a, const PathSample& b, std::size_t index) {
        const double time = b.tS - a.tS;
        const double way = b.sM - a.sM;
        const double fastest = std::max(a.speedMps, b.speedMps);
        // A step may be slower than both ends (lifting, waiting), which only the machine's clock knows.
        // Faster is impossible.
        if (time < -1e-6 || way < -1e-6 || way > fastest * time * 1.01 + 1e-3) {
            found_.time.add(std::abs(time), a.position, index);
            found_.missingTimeS += std::max(0.0, (fastest > kStandingMps ? way / fastest : 0.0) - time);
        }
    }

    const AuditInput& input_;
    Limits limits_;
    Kinematics found_;
    std::optional<Last> last_;
};

}  // namespace

Kinematics measureKinematics(const AuditInput& input) {
    return Meter{input}.measure();
}

}  // namespace furrow
