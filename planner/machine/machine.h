#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/units/quantity.h"

#include <optional>
#include <string>

namespace furrow {

/// The driving vehicle. Its reference point is the middle of the fixed axle.
struct Tractor {
    Length width = metres(2.5);
    Length length = metres(4.5);
    /// From the fixed axle to the tractor's rear end.
    Length rearOverhang = metres(1.0);
    Length wheelbase = metres(2.6);
    /// Smallest radius that the reference point can drive. If not given, from the steering angle.
    std::optional<Length> minTurningRadius;
    std::optional<Angle> maxSteeringAngle;
    /// Largest change of the curvature along the path. If not given, from the steering rate.
    std::optional<CurvatureRate> maxCurvatureRate;
    /// Radians per second of the steered wheels.
    std::optional<double> steeringRateRadps;
    bool canReverse = true;
    bool canTurnInPlace = false;
    Speed workingSpeed = metresPerSecond(2.5);
    Speed turningSpeed = metresPerSecond(1.5);
    Speed transferSpeed = metresPerSecond(2.5);
    Speed reverseSpeed = metresPerSecond(1.0);
    Acceleration maxAcceleration = Acceleration::fromSi(0.5);
    Acceleration maxLateralAcceleration = Acceleration::fromSi(2.0);

    friend bool operator==(const Tractor&, const Tractor&) = default;
};

enum class Mounting { Mounted, Trailed };

/// The working part. Its place is given from the tractor's fixed axle, positive to the front and to the left.
struct Implement {
    Length operatingWidth = metres(2.5);
    /// Width while lifted or folded for a turn. If not given, the operating width.
    std::optional<Length> raisedWidth;
    /// Width while folded for the road, through gates and on ways in and out. If not given, the raised width.
    /// No larger than the machine's width at work.
    std::optional<Length> transportWidth;
    /// To fold for the road, and to unfold again, standing.
    Duration timeToFold = seconds(0.0);
    Mounting mounting = Mounting::Mounted;
    /// From the fixed axle to the hitch, negative behind the axle.
    Length hitchOffset = metres(-1.0);
    /// From the fixed axle to the middle of the working parts, negative behind the axle.
    Length offset = metres(-2.0);
    /// Of the middle of the operating width, positive to the left.
    Length lateralOffset = metres(0.0);
    /// Along the direction of travel.
    Length length = metres(1.0);
    std::optional<Angle> maxHitchAngle;
    Duration liftTime = seconds(0.0);
    Duration lowerTime = seconds(0.0);
    /// Straight distance needed before it is lowered.
    Length runIn = metres(0.0);
    bool canReverse = true;

    friend bool operator==(const Implement&, const Implement&) = default;
};

/// The carried or gathered material, in the user's own unit (litres, kilograms ...).
struct Tank {
    double capacity = 0.0;
    double ratePerM2 = 0.0;
    /// That the machine stands to fill or to empty it. If not given, `kUsualFillTime`.
    std::optional<double> fillTimeS = {};

    Duration fillTime() const { return fillTimeS ? seconds(*fillTimeS) : kUsualFillTime; }
    static constexpr Duration kUsualFillTime = seconds(300.0);

    friend bool operator==(const Tank&, const Tank&) = default;
};

/// Litres per hour.
struct FuelUse {
    double workingLph = 0.0;
    double turningLph = 0.0;

    friend bool operator==(const FuelUse&, const FuelUse&) = default;
};

struct MachineSpec {
    std::string id;
    std::string name;
    Tractor tractor;
    Implement implement;
    std::optional<Tank> tank;
    std::optional<FuelUse> fuel;

    friend bool operator==(const MachineSpec&, const MachineSpec&) = default;
};

/// A tractor with its implement. Every Machine that exists can be planned with.
class Machine {
public:
    /// InputRefused, naming the key: a number beyond what real machines have (machine_keys.h), neither radius
    /// nor steering angle, wider for transport than at work.
    static Result<Machine> create(const MachineSpec& spec);

    const MachineSpec& spec() const { return spec_; }
    const std::string& id() const { return spec_.id; }
    const std::string& name() const { return spec_.name; }
    Length operatingWidth() const { return spec_.implement.operatingWidth; }
    /// As given, or wheelbase / tan(steering angle).
    Length minTurningRadius() const;
    /// As given. Otherwise from the steering rate at the turning (or reverse) speed, with the wheels
    /// straight, where the change is slowest. Otherwise from straight to the smallest radius within two
    /// seconds.
    CurvatureRate maxCurvatureRate() const;
    /// The time in which the steering gets from one curvature to another, driving or standing. From the
    /// steering rate and the wheelbase, or from the curvature rate at the turning speed.
    Duration steeringDuration(Curvature from, Curvature to) const;
    /// The turning speed, or less if the lateral acceleration would be too large at the smallest radius.
    Speed turningSpeed() const;
    /// The straight distance before the implement is lowered: as given, and for a trailed one at least enough
    /// to come into line.
    Length runIn() const;
    /// Width of tractor and raised implement, whichever is more.
    Length turningWidth() const;
    /// Width of tractor and implement folded for transport, whichever is more.
    Length transportWidth() const;
    /// The same machine with its implement folded: its raised width is this machine's transport width.
    Machine folded() const;
    /// Width of tractor and lowered implement, whichever is more.
    Length workingFootprintWidth() const;
    /// The same machine with room for steering in its turns: its radius is larger by what a turn on full lock
    /// moves inwards while the steering goes there.
    Machine withSteeringReserve() const;
    /// The occupied area while turning, counter-clockwise, reference point at the origin, nose to +x. A
    /// trailed implement counts as rigid; the audit follows its own track.
    Ring turningFootprint() const;
    /// The same with the implement lowered.
    Ring workingFootprint() const;

    friend bool operator==(const Machine&, const Machine&) = default;

private:
    Ring footprint(Length implementWidth) const;
    explicit Machine(MachineSpec spec) : spec_{std::move(spec)} {}
    MachineSpec spec_;
};

}  // namespace furrow
