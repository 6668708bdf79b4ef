#include "planner/machine/machine_keys.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

namespace furrow {

namespace {

constexpr std::string_view kMountings[] = {"mounted", "trailed"};

// Follows member pointers from the spec: member<&MachineSpec::tractor, &Tractor::width>(spec).
template <auto... Path>
constexpr auto& member(auto& spec) {
    return (spec.*....*Path);
}

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
double plainNumber(const T& value) {
    if constexpr (requires { value.si(); }) {
        return value.si();
    } else {
        return value;
    }
}

template <class T>
T typedNumber(double value) {
    if constexpr (requires { T::fromSi(value); }) {
        return T::fromSi(value);
    } else {
        return value;
    }
}

constexpr double toRadians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

// Several numbers of degrees mean this angle. Takes the one with few decimals, so that 30 stays 30.
double fromRadians(double radians) {
    const double exact = radians * 180.0 / std::numbers::pi;
    const double rounded = std::round(exact * 1e9) / 1e9;
    return toRadians(rounded) == radians ? rounded : exact;
}

enum class Scale { Si, Degrees };

template <Scale scale, auto... Path>
MachineValue getNumber(const MachineSpec& spec) {
    const auto& value = member<Path...>(spec);
    const auto inFileUnit = [](const auto& held) {
        return scale == Scale::Degrees ? fromRadians(plainNumber(held)) : plainNumber(held);
    };
    if constexpr (IsOptional<std::remove_cvref_t<decltype(value)>>::value) {
        return value ? MachineValue{inFileUnit(*value)} : MachineValue{};
    } else {
        return inFileUnit(value);
    }
}

template <Scale scale, auto... Path>
void setNumber(MachineSpec& spec, const MachineValue& value) {
    auto& target = member<Path...>(spec);
    using Target = std::remove_cvref_t<decltype(target)>;
    const double* number = std::get_if<double>(&value);
    const double si = number == nullptr ? 0.0 : (scale == Scale::Degrees ? toRadians(*number) : *number);
    if constexpr (IsOptional<Target>::value) {
        target = number == nullptr ? Target{} : Target{typedNumber<typename Target::value_type>(si)};
    } else if (number != nullptr) {
        target = typedNumber<Target>(si);
    }
}

// Tank and fuel use exist as a whole or not at all. The first number given creates them.
template <auto Whole, auto Part>
MachineValue getPart(const MachineSpec& spec) {
    const auto& whole = spec.*Whole;
    return whole ? MachineValue{(*whole).*Part} : MachineValue{};
}

template <auto Whole, auto Part>
void setPart(MachineSpec& spec, const MachineValue& value) {
    auto& whole = spec.*Whole;
    if (const double* number = std::get_if<double>(&value)) {
        if (!whole) {
            whole.emplace();
        }
        (*whole).*Part = *number;
    } else {
        whole.reset();
    }
}

/// A number of a part that may be missing there. It creates the part; without it the rest of the part stays.
template <auto Whole, auto Part>
MachineValue getPartOption(const MachineSpec& spec) {
    const auto& whole = spec.*Whole;
    return whole && (*whole).*Part ? MachineValue{*((*whole).*Part)} : MachineValue{};
}

template <auto Whole, auto Part>
void setPartOption(MachineSpec& spec, const MachineValue& value) {
    auto& whole = spec.*Whole;
    const double* number = std::get_if<double>(&value);
    if (number != nullptr && !whole) {
        whole.emplace();
    }
    if (whole) {
        (*whole).*Part = number != nullptr ? std::optional{*number} : std::nullopt;
    }
}

struct Range {
    double min;
    double max;
};

template <auto... Path>
constexpr MachineKey number(std::string_view key, std::string_view name, std::string_view unit, Range usual,
                            Range possible, std::string_view description) {
    using Target = std::remove_cvref_t<decltype(member<Path...>(std::declval<MachineSpec&>()))>;
    return {.key = key,
            .name = name,
            .unit = unit,
            .description = description,
            .min = usual.min,
            .max = usual.max,
            .least = possible.min,
            .most = possible.max,
            .mayBeMissing = IsOptional<Target>::value,
            .choices = {},
            .get = &getNumber<Scale::Si, Path...>,
            .set = &setNumber<Scale::Si, Path...>};
}

template <auto... Path>
constexpr MachineKey angle(std::string_view key, std::string_view name, std::string_view unit, Range usual,
                           Range possible, std::string_view description) {
    MachineKey made = number<Path...>(key, name, unit, usual, possible, description);
    made.get = &getNumber<Scale::Degrees, Path...>;
    made.set = &setNumber<Scale::Degrees, Path...>;
    return made;
}

template <auto Whole, auto Part>
constexpr MachineKey part(std::string_view key, std::string_view name, std::string_view unit, Range usual,
                          Range possible, std::string_view description) {
    return {.key = key,
            .name = name,
            .unit = unit,
            .description = description,
            .min = usual.min,
            .max = usual.max,
            .least = possible.min,
            .most = possible.max,
            .mayBeMissing = true,
            .choices = {},
            .get = &getPart<Whole, Part>,
            .set = &setPart<Whole, Part>};
}

template <auto... Path>
constexpr MachineKey flag(std::string_view key, std::string_view name, std::string_view description) {
    return {.key = key,
            .kind = MachineKeyKind::Flag,
            .name = name,
            .unit = {},
            .description = description,
            .choices = {},
            .get = [](const MachineSpec& spec) { return MachineValue{member<Path...>(spec)}; },
            .set =
                [](MachineSpec& spec, const MachineValue& value) {
                    if (const bool* held = std::get_if<bool>(&value)) {
                        member<Path...>(spec) = *held;
                    }
                }};
}

template <auto Member>
constexpr MachineKey text(std::string_view key, std::string_view name, std::string_view description) {
    return {.key = key,
            .kind = MachineKeyKind::Text,
            .name = name,
            .unit = {},
            .description = description,
            .choices = {},
            .get = [](const MachineSpec& spec) { return MachineValue{spec.*Member}; },
            .set =
                [](MachineSpec& spec, const MachineValue& value) {
                    if (const auto* held = std::get_if<std::string>(&value)) {
                        spec.*Member = *held;
                    }
                }};
}

constexpr MachineKey mounting() {
    return {.key = "implement_mounting",
            .kind = MachineKeyKind::Text,
            .name = "Mounting",
            .unit = {},
            .description = "Carried by the tractor, or pulled on a hitch and following its own track.",
            .choices = kMountings,
            .get =
                [](const MachineSpec& spec) {
                    const bool trailed = spec.implement.mounting == Mounting::Trailed;
                    return MachineValue{std::string{kMountings[trailed ? 1 : 0]}};
                },
            .set =
                [](MachineSpec& spec, const MachineValue& value) {
                    if (const auto* held = std::get_if<std::string>(&value)) {
                        spec.implement.mounting =
                            *held == kMountings[1] ? Mounting::Trailed : Mounting::Mounted;
                    }
                }};
}

constexpr auto kTractor = &MachineSpec::tractor;
constexpr auto kImplement = &MachineSpec::implement;

constexpr MachineKey tankFillTime() {
    MachineKey made = part<&MachineSpec::tank, &Tank::capacity>(
        "tank_fill_time_s", "Time to fill", "s", {0.0, 7200.0}, {0.0, 86400.0},
        "That the machine stands each time its tank is filled or its bunker emptied; 300 s where it is not given.");
    made.get = &getPartOption<&MachineSpec::tank, &Tank::fillTimeS>;
    made.set = &setPartOption<&MachineSpec::tank, &Tank::fillTimeS>;
    return made;
}

constexpr MachineKey kKeys[] = {
    text<&MachineSpec::id>("id", "Id", "Short name for the command line."),
    text<&MachineSpec::name>("name", "Name", "What the machine is called."),
    number<kTractor, &Tractor::width>("vehicle_width_m", "Vehicle width", "m", {0.1, 10.0}, {0.05, 20.0},
                                      "Width the tractor occupies, wheels included."),
    number<kTractor, &Tractor::length>("vehicle_length_m", "Vehicle length", "m", {0.1, 20.0}, {0.05, 50.0},
                                       "From the tractor's nose to its rear end."),
    number<kTractor, &Tractor::rearOverhang>("rear_overhang_m", "Rear overhang", "m", {0.0, 10.0},
                                             {0.0, 20.0}, "From the fixed axle to the tractor's rear end."),
    number<kTractor, &Tractor::wheelbase>("wheelbase_m", "Wheelbase", "m", {0.1, 10.0}, {0.05, 20.0},
                                          "Between the fixed and the steered axle."),
    number<kTractor, &Tractor::minTurningRadius>("min_turning_radius_m", "Smallest turning radius", "m",
                                                 {0.1, 50.0}, {0.05, 200.0},
                                                 "Smallest circle the middle of the fixed axle can follow; "
                                                 "from the steering angle where it is not given."),
    angle<kTractor, &Tractor::maxSteeringAngle>("max_steering_angle_deg", "Largest steering angle", "°",
                                                {1.0, 85.0}, {0.5, 89.5},
                                                "How far the steered wheels turn to one side."),
    number<kTractor, &Tractor::maxCurvatureRate>(
        "max_curvature_rate_1pm2", "Largest curvature rate", "1/m²", {0.001, 10.0}, {1e-5, 100.0},
        "How fast the curvature may change along the path; from the steering rate where it is not given."),
    angle<kTractor, &Tractor::steeringRateRadps>("steering_rate_degps", "Steering rate", "°/s", {1.0, 180.0},
                                                 {1.0, 720.0}, "How fast the steered wheels turn."),
    flag<kTractor, &Tractor::canReverse>("can_reverse", "Can reverse", "The tractor may drive backwards."),
    flag<kTractor, &Tractor::canTurnInPlace>("can_turn_in_place", "Can turn in place",
                                             "The tractor may turn about its own middle."),
    number<kTractor, &Tractor::workingSpeed>("working_speed_mps", "Working speed", "m/s", {0.1, 15.0},
                                             {0.01, 25.0}, "Speed with the implement at work."),
    number<kTractor, &Tractor::turningSpeed>("turning_speed_mps", "Turning speed", "m/s", {0.1, 15.0},
                                             {0.01, 25.0}, "Largest speed in turns."),
    number<kTractor, &Tractor::transferSpeed>("transfer_speed_mps", "Transfer speed", "m/s", {0.1, 15.0},
                                              {0.01, 25.0},
                                              "Speed on longer ways with the implement lifted."),
    number<kTractor, &Tractor::reverseSpeed>("reverse_speed_mps", "Reverse speed", "m/s", {0.1, 15.0},
                                             {0.01, 25.0}, "Speed backwards."),
    number<kTractor, &Tractor::maxAcceleration>("max_acceleration_mps2", "Largest acceleration", "m/s²",
                                                {0.05, 5.0}, {0.01, 20.0},
                                                "When speeding up and when braking."),
    number<kTractor, &Tractor::maxLateralAcceleration>("max_lateral_acceleration_mps2",
                                                       "Largest lateral acceleration", "m/s²", {0.1, 5.0},
                                                       {0.01, 20.0}, "Limits the speed in tight bends."),
    number<kImplement, &Implement::operatingWidth>("operating_width_m", "Operating width", "m", {0.1, 60.0},
                                                   {0.05, 100.0}, "Width worked in one pass."),
    number<kImplement, &Implement::raisedWidth>(
        "raised_width_m", "Raised width", "m", {0.1, 60.0}, {0.05, 100.0},
        "Width while lifted or folded for a turn; the operating width where it is not given."),
    number<kImplement, &Implement::transportWidth>(
        "transport_width_m", "Transport width", "m", {0.1, 60.0}, {0.05, 100.0},
        "Width while folded for the road, through gates and on ways in and out; the raised width where it is not given."),
    number<kImplement, &Implement::timeToFold>(
        "time_to_fold_s", "Time to fold", "s",
        {0.0, 3600.0}, {0.0, 3600.0}, "To fold to the transport width, standing; the same again to unfold."),
    mounting(),
    number<kImplement, &Implement::hitchOffset>(
        "implement_hitch_offset_m", "Hitch offset", "m", {-20.0, 20.0}, {-30.0, 30.0},
        "From the fixed axle to the hitch, negative behind the axle."),
    number<kImplement, &Implement::offset>(
        "implement_offset_m", "Implement offset", "m", {-30.0, 30.0}, {-50.0, 50.0},
        "From the fixed axle to the middle of the working parts, negative behind the axle."),
    number<kImplement, &Implement::lateralOffset>(
        "implement_lateral_offset_m", "Lateral offset", "m", {-30.0, 30.0}, {-50.0, 50.0},
        "Of the middle of the operating width, positive to the left."),
    number<kImplement, &Implement::length>("implement_length_m", "Implement length", "m", {0.0, 30.0},
                                           {0.0, 50.0}, "Along the direction of travel."),
    angle<kImplement, &Implement::maxHitchAngle>("max_hitch_angle_deg", "Largest hitch angle", "°",
                                                 {1.0, 120.0}, {0.5, 180.0},
                                                 "How far a trailed implement may swing to one side."),
    number<kImplement, &Implement::liftTime>("lift_time_s", "Time to lift", "s", {0.0, 60.0}, {0.0, 600.0},
                                             "From working depth to clear of the ground."),
    number<kImplement, &Implement::lowerTime>("lower_time_s", "Time to lower", "s", {0.0, 60.0}, {0.0, 600.0},
                                              "From clear of the ground to working depth."),
    number<kImplement, &Implement::runIn>("run_in_m", "Run-in", "m", {0.0, 50.0}, {0.0, 100.0},
                                          "Straight way needed before the implement is lowered."),
    flag<kImplement, &Implement::canReverse>("implement_can_reverse", "Implement can reverse",
                                             "The tractor may drive backwards with it."),
    part<&MachineSpec::tank, &Tank::capacity>("tank_capacity", "Tank or bunker", "", {0.0, 1e7}, {0.0, 1e9},
                                              "What it holds, in your own unit: litres, kilograms, seeds."),
    part<&MachineSpec::tank, &Tank::ratePerM2>(
        "tank_rate_per_m2", "Rate", "per m²", {0.0, 1000.0}, {0.0, 1e6},
        "What is spread or gathered on a square metre, in the same unit."),
    tankFillTime(),
    part<&MachineSpec::fuel, &FuelUse::workingLph>("fuel_working_lph", "Fuel at work", "l/h", {0.0, 500.0},
                                                   {0.0, 5000.0}, "Litres of fuel per hour of work."),
    part<&MachineSpec::fuel, &FuelUse::turningLph>("fuel_turning_lph", "Fuel in turns", "l/h", {0.0, 500.0},
                                                   {0.0, 5000.0},
                                                   "Litres of fuel per hour of turns and transfers."),
};

/// How much of a key's unit the same number is in the units that are taken for it.
constexpr double kInsteadOfMetres[] = {0.001, 0.01};         // millimetres, centimetres
constexpr double kInsteadOfMetresPerSecond[] = {1.0 / 3.6};  // km/h

/// What the key usually is: the middle of its usual range, as sizes go.
double usualSize(const MachineKey& key) {
    const double most = std::max(std::abs(key.min), std::abs(key.max));
    return std::sqrt(std::max(key.min, 0.01 * most) * most);
}

/// The number that was meant by one in millimetres, centimetres or km/h: of those in the usual range the
/// one nearest to what is usual.
std::optional<double> meant(const MachineKey& key, double value) {
    std::span<const double> factors;
    if (key.unit == "m") {
        factors = kInsteadOfMetres;
    } else if (key.unit == "m/s") {
        factors = kInsteadOfMetresPerSecond;
    }
    std::optional<double> best;
    const auto distance = [usual = usualSize(key)](double size) {
        return std::abs(std::log(std::abs(size) / usual));
    };
    for (const double factor : factors) {
        const double candidate = value * factor;
        const bool isUsual = candidate >= key.min && candidate <= key.max && candidate != 0.0;
        if (isUsual && (!best || distance(candidate) < distance(*best))) {
            best = candidate;
        }
    }
    return best;
}

std::string inUnitOf(const MachineKey& key, double number) {
    return std::format("{:.6g}{}{}", number, key.unit.empty() || key.unit.starts_with("°") ? "" : " ",
                       key.unit);
}

Error outOfRange(const MachineKey& key, double value) {
    const std::optional<double> instead = meant(key, value);
    return {.code = ErrorCode::InputRefused,
            .what = message("{} is beyond what machines have", inUnitOf(key, value)),
            .where = message("machine, {}", key.key),
            .remedy = instead ? message("did you mean {}?", inUnitOf(key, *instead))
                              : message("give a number from {} to {}", std::format("{:g}", key.least),
                                        inUnitOf(key, key.most))};
}

}  // namespace

std::span<const MachineKey> machineKeys() {
    return kKeys;
}

Result<void> checkRanges(const MachineSpec& spec) {
    for (const MachineKey& key : kKeys) {
        const MachineValue held = key.get(spec);
        const double* const number = std::get_if<double>(&held);
        if (number != nullptr && !(*number >= key.least && *number <= key.most)) {
            return std::unexpected(outOfRange(key, *number));
        }
    }
    return {};
}

}  // namespace furrow
