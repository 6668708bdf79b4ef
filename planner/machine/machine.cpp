#include "planner/machine/machine.h"

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

constexpr Duration kLongestFolding = seconds(3600.0);

Error refused(std::string_view key, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = message("machine, {}", key),
            .remedy = std::move(remedy)};
}

struct Requirement {
    std::string_view key;
    double value;
    bool mayBeZero = false;
};

/// Numbers above 0, or of 0 and more.
Result<void> checkNumbers(const MachineSpec& spec) {
    const Tractor& tractor = spec.tractor;
    const Implement& implement = spec.implement;
    const Requirement requirements[] = {
        {"operating_width_m", implement.operatingWidth.si()},
        {"raised_width_m", implement.raisedWidth.value_or(metres(1.0)).si()},
        {"transport_width_m", implement.transportWidth.value_or(metres(1.0)).si()},
        {"vehicle_width_m", tractor.width.si()},
        {"vehicle_length_m", tractor.length.si()},
        {"rear_overhang_m", tractor.rearOverhang.si(), true},
        {"wheelbase_m", tractor.wheelbase.si()},
        {"min_turning_radius_m", tractor.minTurningRadius.value_or(metres(1.0)).si()},
        {"max_curvature_rate_1pm2", tractor.maxCurvatureRate.value_or(CurvatureRate::fromSi(1.0)).si()},
        {"steering_rate_degps", tractor.steeringRateRadps.value_or(1.0)},
        {"working_speed_mps", tractor.workingSpeed.si()},
        {"turning_speed_mps", tractor.turningSpeed.si()},
        {"transfer_speed_mps", tractor.transferSpeed.si()},
        {"reverse_speed_mps", tractor.reverseSpeed.si()},
        {"max_acceleration_mps2", tractor.maxAcceleration.si()},
        {"max_lateral_acceleration_mps2", tractor.maxLateralAcceleration.si()},
        {"implement_length_m", implement.length.si(), true},
        {"time_to_fold_s", implement.timeToFold.si(), true},
        {"lift_time_s", implement.liftTime.si(), true},
        {"lower_time_s", implement.lowerTime.si(), true},
        {"run_in_m", implement.runIn.si(), true},
    };
    for (const Requirement& requirement : requirements) {
        const bool largeEnough = requirement.mayBeZero ? requirement.value >= 0.0 : requirement.value > 0.0;
        if (!std::isfinite(requirement.value) || !largeEnough) {
            return std::unexpected(
                refused(requirement.key, message("{} cannot be worked with", requirement.value),
                        requirement.mayBeZero ? "give a number of 0 or more" : "give a number above 0"));
        }
    }
    return {};
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
    if (!(*tractor.maxSteeringAngle > degrees(0.0) && *tractor.maxSteeringAngle < degrees(90.0))) {
        return std::unexpected(
            refused("max_steering_angle_deg",
                    message("{} degrees cannot be steered", inDegrees(*tractor.maxSteeringAngle)),
                    "give an angle above 0 and below 90 degrees"));
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
    if (auto checked = checkNumbers(spec).and_then([&] { return checkSteering(tractor); }); !checked) {
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
    if (implement.timeToFold > kLongestFolding) {
        return std::unexpected(refused(
            "time_to_fold_s", message("{:.0f} s to fold are more than an hour", implement.timeToFold.si()),
            "give a number from 0 to 3600"));
    }
    for (const double offset :
         {implement.offset.si(), implement.hitchOffset.si(), implement.lateralOffset.si()}) {
        if (!std::isfinite(offset)) {
            return std::unexpected(refused("implement offsets", "an offset is not a finite number",
                                           "give the offsets in metres"));
        }
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
