#include "planner/machine/machine.h"

#include "planner/machine/machine_keys.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// After 1.5 of its own lengths, a trailed implement at 45 degrees is within 11 degrees of the line: tan(a /
// 2) falls with exp(-s / l).
constexpr double kLengthsToComeIntoLine = 1.5;

/// Largest part of the radius that is kept for steering.
constexpr double kMostReserve = 0.05;

/// Time from straight wheels to full lock, if the machine gives no rate.
constexpr Duration kFullLockTime = seconds(2.0);

Error refused(std::string_view key, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = message("machine, {}", key),
            .remedy = std::move(remedy)};
}

/// Whether a number lies in the range of a key.
bool isInRange(std::string_view key, double value) {
    const auto found = std::ranges::find(machineKeys(), key, &MachineKey::key);
    return value >= found->least && value <= found->most;
}

/// A turning radius, or an angle that gives one.
Result<void> checkSteering(const Tractor& tractor) {
    if (tractor.minTurningRadius) {
        return {};
    }
    if (!tractor.maxSteeringAngle) {
        return std::unexpected(refused("min_turning_radius_m",
                                       "neither turning radius nor steering angle is given",
                                       "give min_turning_radius_m or max_steering_angle_deg"));
    }
    const double radiusM = tractor.wheelbase.si() / std::tan(tractor.maxSteeringAngle->si());
    if (!isInRange("min_turning_radius_m", radiusM)) {
        return std::unexpected(
            refused("max_steering_angle_deg",
                    message("with this wheelbase, {} degrees give a turning radius of {:.2f} m",
                            inDegrees(*tractor.maxSteeringAngle), radiusM),
                    "correct one of them, or give min_turning_radius_m"));
    }
    return {};
}

/// The speed for which the change of the curvature along the way is stated.
Speed steeredSpeed(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    return tractor.canReverse ? std::max(machine.turningSpeed(), tractor.reverseSpeed)
                              : machine.turningSpeed();
}

}  // namespace

Result<Machine> Machine::create(const MachineSpec& spec) {
    const Tractor& tractor = spec.tractor;
    const Implement& implement = spec.implement;
    if (auto checked = checkRanges(spec).and_then([&] { return checkSteering(tractor); }); !checked) {
        return std::unexpected(checked.error());
    }
    const Length widest =
        std::max({implement.operatingWidth, implement.raisedWidth.value_or(Length{}), tractor.width});
    if (implement.transportWidth.value_or(widest) > widest) {
        return std::unexpected(
            refused("transport_width_m",
                    message("{:.2f} m for transport is wider than the machine at work, {:.2f} m",
                            implement.transportWidth->si(), widest.si()),
                    "give its width while it is folded"));
    }
    return Machine{spec};
}

Length Machine::minTurningRadius() const {
    const Tractor& tractor = spec_.tractor;
    return tractor.minTurningRadius ? *tractor.minTurningRadius
                                    : tractor.wheelbase / std::tan(tractor.maxSteeringAngle->si());
}

CurvatureRate Machine::maxCurvatureRate() const {
    const Tractor& tractor = spec_.tractor;
    if (tractor.maxCurvatureRate) {
        return *tractor.maxCurvatureRate;
    }
    const Speed speed = steeredSpeed(*this);
    // The curvature is tan(steering angle) / wheelbase. Its derivative has 1 / cos² >= 1 as a factor.
    const double steered = tractor.steeringRateRadps ? *tractor.steeringRateRadps / tractor.wheelbase.si()
                                                     : 1.0 / (kFullLockTime.si() * minTurningRadius().si());
    return CurvatureRate::fromSi(steered / speed.si());
}

Duration Machine::steeringDuration(Curvature from, Curvature to) const {
    const Tractor& tractor = spec_.tractor;
    if (tractor.maxCurvatureRate || !tractor.steeringRateRadps) {
        const double perSecond = maxCurvatureRate().si() * steeredSpeed(*this).si();
        return seconds(std::abs((to - from).si()) / perSecond);
    }
    const double wheelbaseM = tractor.wheelbase.si();
    const double turned = std::atan(wheelbaseM * to.si()) - std::atan(wheelbaseM * from.si());
    return seconds(std::abs(turned) / *tractor.steeringRateRadps);
}

Speed Machine::turningSpeed() const {
    const double lateral = std::sqrt(spec_.tractor.maxLateralAcceleration.si() * minTurningRadius().si());
    return std::min(spec_.tractor.turningSpeed, metresPerSecond(lateral));
}

Length Machine::runIn() const {
    const Implement& implement = spec_.implement;
    const Length trailing =
        implement.mounting == Mounting::Trailed ? implement.hitchOffset - implement.offset : Length{};
    return std::max(implement.runIn, kLengthsToComeIntoLine * trailing);
}

Length Machine::turningWidth() const {
    return std::max(spec_.tractor.width,
                    spec_.implement.raisedWidth.value_or(spec_.implement.operatingWidth));
}

Length Machine::transportWidth() const {
    const Implement& implement = spec_.implement;
    const Length raised = implement.raisedWidth.value_or(implement.operatingWidth);
    return std::max(spec_.tractor.width, implement.transportWidth.value_or(raised));
}

Machine Machine::folded() const {
    Machine other = *this;
    if (spec_.implement.transportWidth) {
        other.spec_.implement.raisedWidth = spec_.implement.transportWidth;
    }
    return other;
}

Length Machine::workingFootprintWidth() const {
    return std::max(spec_.tractor.width, spec_.implement.operatingWidth);
}

Machine Machine::withSteeringReserve() const {
    const Length radius = minTurningRadius();
    const Length steered =
        metres(steeringDuration({}, Curvature::fromSi(1.0 / radius.si())).si() * turningSpeed().si());
    Machine other = *this;
    // Over a way w to the curvature k, an arc moves by k w² / 24, and a little more.
    other.spec_.tractor.minTurningRadius =
        radius + std::min(metres(steered.si() * steered.si() / (20.0 * radius.si())), kMostReserve * radius);
    return other;
}

Ring Machine::turningFootprint() const {
    return footprint(spec_.implement.raisedWidth.value_or(spec_.implement.operatingWidth));
}

Ring Machine::workingFootprint() const {
    return footprint(spec_.implement.operatingWidth);
}

Ring Machine::footprint(Length implementWidth) const {
    const Tractor& tractor = spec_.tractor;
    const Implement& implement = spec_.implement;
    const double front = (tractor.length - tractor.rearOverhang).si();
    const double rear = -tractor.rearOverhang.si();
    const double half = 0.5 * tractor.width.si();
    const double implementFront = (implement.offset + 0.5 * implement.length).si();
    const double implementRear = (implement.offset - 0.5 * implement.length).si();
    const double implementHalf = 0.5 * implementWidth.si();
    const double left = std::max(half, implement.lateralOffset.si() + implementHalf);
    const double right = std::min(-half, implement.lateralOffset.si() - implementHalf);
    if (implementFront <= rear) {
        // Behind the tractor: an eight-cornered T, seen from above with the nose to the right.
        //     +--+
        //     |  +-------+
        //     |  +-------+
        //     +--+
        return {{implementRear, right}, {implementFront, right}, {implementFront, -half},
                {front, -half},         {front, half},           {implementFront, half},
                {implementFront, left}, {implementRear, left}};
    }
    // Beside or around the tractor: one box around both is close enough and never too small.
    const double back = std::min(rear, implementRear);
    const double nose = std::max(front, implementFront);
    return {{back, right}, {nose, right}, {nose, left}, {back, left}};
}

}  // namespace furrow
