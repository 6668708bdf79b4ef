#include "planner/machine/machine_file.h"

#include "planner/core/text_file.h"
#include "planner/settings/settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <format>
#include <fstream>
#include <numbers>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

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

struct Range {
    double min;
    double max;
};

template <auto... Path>
constexpr MachineKey number(std::string_view key, std::string_view name, std::string_view unit, Range range,
                            std::string_view description) {
    using Target = std::remove_cvref_t<decltype(member<Path...>(std::declval<MachineSpec&>()))>;
    return {.key = key,
            .name = name,
            .unit = unit,
            .description = description,
            .min = range.min,
            .max = range.max,
            .mayBeMissing = IsOptional<Target>::value,
            .choices = {},
            .get = &getNumber<Scale::Si, Path...>,
            .set = &setNumber<Scale::Si, Path...>};
}

template <auto... Path>
constexpr MachineKey angle(std::string_view key, std::string_view name, std::string_view unit, Range range,
                           std::string_view description) {
    MachineKey made = number<Path...>(key, name, unit, range, description);
    made.get = &getNumber<Scale::Degrees, Path...>;
    made.set = &setNumber<Scale::Degrees, Path...>;
    return made;
}

template <auto Whole, auto Part>
constexpr MachineKey part(std::string_view key, std::string_view name, std::string_view unit, Range range,
                          std::string_view description) {
    return {.key = key,
            .name = name,
            .unit = unit,
            .description = description,
            .min = range.min,
            .max = range.max,
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

constexpr MachineKey kKeys[] = {
    text<&MachineSpec::id>("id", "Id", "Short name for the command line."),
    text<&MachineSpec::name>("name", "Name", "What the machine is called."),
    number<kTractor, &Tractor::width>("vehicle_width_m", "Vehicle width", "m", {0.1, 10.0},
                                      "Width the tractor occupies, wheels included."),
    number<kTractor, &Tractor::length>("vehicle_length_m", "Vehicle length", "m", {0.1, 20.0},
                                       "From the tractor's nose to its rear end."),
    number<kTractor, &Tractor::rearOverhang>("rear_overhang_m", "Rear overhang", "m", {0.0, 10.0},
                                             "From the fixed axle to the tractor's rear end."),
    number<kTractor, &Tractor::wheelbase>("wheelbase_m", "Wheelbase", "m", {0.1, 10.0},
                                          "Between the fixed and the steered axle."),
    number<kTractor, &Tractor::minTurningRadius>("min_turning_radius_m", "Smallest turning radius", "m",
                                                 {0.1, 50.0},
                                                 "Smallest circle the middle of the fixed axle can follow; "
                                                 "from the steering angle where it is not given."),
    angle<kTractor, &Tractor::maxSteeringAngle>("max_steering_angle_deg", "Largest steering angle", "°",
                                                {1.0, 85.0}, "How far the steered wheels turn to one side."),
    number<kTractor, &Tractor::maxCurvatureRate>(
        "max_curvature_rate_1pm2", "Largest curvature rate", "1/m²", {0.001, 10.0},
        "How fast the curvature may change along the path; from the steering rate where it is not given."),
    angle<kTractor, &Tractor::steeringRateRadps>("steering_rate_degps", "Steering rate", "°/s", {1.0, 180.0},
                                                 "How fast the steered wheels turn."),
    flag<kTractor, &Tractor::canReverse>("can_reverse", "Can reverse", "The tractor may drive backwards."),
    flag<kTractor, &Tractor::canTurnInPlace>("can_turn_in_place", "Can turn in place",
                                             "The tractor may turn about its own middle."),
    number<kTractor, &Tractor::workingSpeed>("working_speed_mps", "Working speed", "m/s", {0.1, 15.0},
                                             "Speed with the implement at work."),
    number<kTractor, &Tractor::turningSpeed>("turning_speed_mps", "Turning speed", "m/s", {0.1, 15.0},
                                             "Largest speed in turns."),
    number<kTractor, &Tractor::transferSpeed>("transfer_speed_mps", "Transfer speed", "m/s", {0.1, 15.0},
                                              "Speed on longer ways with the implement lifted."),
    number<kTractor, &Tractor::reverseSpeed>("reverse_speed_mps", "Reverse speed", "m/s", {0.1, 15.0},
                                             "Speed backwards."),
    number<kTractor, &Tractor::maxAcceleration>("max_acceleration_mps2", "Largest acceleration", "m/s²",
                                                {0.05, 5.0}, "When speeding up and when braking."),
    number<kTractor, &Tractor::maxLateralAcceleration>("max_lateral_acceleration_mps2",
                                                       "Largest lateral acceleration", "m/s²", {0.1, 5.0},
                                                       "Limits the speed in tight bends."),
    number<kImplement, &Implement::operatingWidth>("operating_width_m", "Operating width", "m", {0.1, 60.0},
                                                   "Width worked in one pass."),
    number<kImplement, &Implement::raisedWidth>(
        "raised_width_m", "Raised width", "m", {0.1, 60.0},
        "Width while lifted or folded for a turn; the operating width where it is not given."),
    number<kImplement, &Implement::transportWidth>(
        "transport_width_m", "Transport width", "m", {0.1, 60.0},
        "Width while folded for the road, through gates and on ways in and out; the raised width where it is not given."),
    number<kImplement, &Implement::timeToFold>(
        "time_to_fold_s", "Time to fold", "s",
        {0.0, 3600.0}, "To fold to the transport width, standing; the same again to unfold."),
    mounting(),
    number<kImplement, &Implement::hitchOffset>(
        "implement_hitch_offset_m", "Hitch offset", "m", {-20.0, 20.0},
        "From the fixed axle to the hitch, negative behind the axle."),
    number<kImplement, &Implement::offset>(
        "implement_offset_m", "Implement offset", "m", {-30.0, 30.0},
        "From the fixed axle to the middle of the working parts, negative behind the axle."),
    number<kImplement, &Implement::lateralOffset>(
        "implement_lateral_offset_m", "Lateral offset", "m", {-30.0, 30.0},
        "Of the middle of the operating width, positive to the left."),
    number<kImplement, &Implement::length>("implement_length_m", "Implement length", "m", {0.0, 30.0},
                                           "Along the direction of travel."),
    angle<kImplement, &Implement::maxHitchAngle>("max_hitch_angle_deg", "Largest hitch angle", "°",
                                                 {1.0, 120.0},
                                                 "How far a trailed implement may swing to one side."),
    number<kImplement, &Implement::liftTime>("lift_time_s", "Time to lift", "s", {0.0, 60.0},
                                             "From working depth to clear of the ground."),
    number<kImplement, &Implement::lowerTime>("lower_time_s", "Time to lower", "s", {0.0, 60.0},
                                              "From clear of the ground to working depth."),
    number<kImplement, &Implement::runIn>("run_in_m", "Run-in", "m", {0.0, 50.0},
                                          "Straight way needed before the implement is lowered."),
    flag<kImplement, &Implement::canReverse>("implement_can_reverse", "Implement can reverse",
                                             "The tractor may drive backwards with it."),
    part<&MachineSpec::tank, &Tank::capacity>("tank_capacity", "Tank or bunker", "", {0.0, 1e7},
                                              "What it holds, in your own unit: litres, kilograms, seeds."),
    part<&MachineSpec::tank, &Tank::ratePerM2>(
        "tank_rate_per_m2", "Rate", "per m²", {0.0, 1000.0},
        "What is spread or gathered on a square metre, in the same unit."),
    part<&MachineSpec::fuel, &FuelUse::workingLph>("fuel_working_lph", "Fuel at work", "l/h", {0.0, 500.0},
                                                   "Litres of fuel per hour of work."),
    part<&MachineSpec::fuel, &FuelUse::turningLph>("fuel_turning_lph", "Fuel in turns", "l/h", {0.0, 500.0},
                                                   "Litres of fuel per hour of turns and transfers."),
};

Error refused(std::string_view origin, const Message& place, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = place.empty() ? Message{origin} : message("{}, {}", origin, place),
            .remedy = std::move(remedy)};
}

Error unknownKey(std::string_view origin, std::string_view key) {
    std::vector<std::string_view> known;
    for (const MachineKey& entry : kKeys) {
        known.push_back(entry.key);
    }
    const std::string nearest = nearestName(key, known);
    return refused(origin, key, message("there is no '{}' in a machine", key),
                   nearest.empty()
                       ? "remove it; keys look like operating_width_m, vehicle_width_m, can_reverse"
                       : message("did you mean '{}'?", nearest));
}

std::string joined(std::span<const std::string_view> words) {
    std::string text;
    for (const std::string_view word : words) {
        text += std::format("{}\"{}\"", text.empty() ? "" : " or ", word);
    }
    return text;
}

// The kind of value for a key, as a remedy: "give a number in m".
Message wanted(const MachineKey& key) {
    switch (key.kind) {
        case MachineKeyKind::Flag: return "give true or false";
        case MachineKeyKind::Text:
            return key.choices.empty() ? Message{"give a text in quotes"}
                                       : message("give {}", joined(key.choices));
        case MachineKeyKind::Number: break;
    }
    return key.unit.empty() ? "give a number" : message("give a number in {}", key.unit);
}

Result<MachineValue> valueOf(const MachineKey& key, const nlohmann::json& json, std::string_view origin) {
    if (json.is_null() && key.mayBeMissing) {
        return MachineValue{};
    }
    switch (key.kind) {
        case MachineKeyKind::Number:
            if (json.is_number()) {
                return json.get<double>();
            }
            break;
        case MachineKeyKind::Flag:
            if (json.is_boolean()) {
                return json.get<bool>();
            }
            break;
        case MachineKeyKind::Text:
            if (json.is_string()) {
                auto held = json.get<std::string>();
                if (key.choices.empty() || std::ranges::contains(key.choices, held)) {
                    return held;
                }
            }
            break;
    }
    return std::unexpected(refused(
        origin, key.key,
        message("{} does not fit here", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)),
        wanted(key)));
}

Result<nlohmann::json> parsed(std::string_view text, std::string_view origin) {
    std::vector<std::string> keys;
    const auto collectKeys = [&keys](int depth, nlohmann::json::parse_event_t event, nlohmann::json& value) {
        if (event == nlohmann::json::parse_event_t::key && depth == 1) {
            keys.push_back(value.get<std::string>());
        }
        return true;
    };
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text, collectKeys);
    } catch (const nlohmann::json::parse_error& error) {
        return std::unexpected(refused(origin, lineAndColumn(text, error.byte > 0 ? error.byte - 1 : 0),
                                       "this is not JSON from here on",
                                       "look for a missing comma, quote or brace just before it"));
    } catch (const nlohmann::json::exception&) {
        return std::unexpected(
            refused(origin, "", "a number is too large to be read", "give a smaller number"));
    }
    if (!json.is_object()) {
        return std::unexpected(refused(origin, "", "a machine is one JSON object",
                                       "write {\"name\": ..., \"operating_width_m\": ...}"));
    }
    std::ranges::sort(keys);
    if (const auto twice = std::ranges::adjacent_find(keys); twice != keys.end()) {
        return std::unexpected(refused(origin, *twice, "the key is there twice", "keep one of them"));
    }
    return json;
}

}  // namespace

std::span<const MachineKey> machineKeys() {
    return kKeys;
}

Result<Machine> parseMachine(std::string_view json, std::string_view origin) {
    const Result<nlohmann::json> object = parsed(json, origin);
    if (!object) {
        return std::unexpected(object.error());
    }
    MachineSpec spec;
    for (const auto& [name, held] : object->items()) {
        const auto key = std::ranges::find(kKeys, std::string_view{name}, &MachineKey::key);
        if (key == std::end(kKeys)) {
            return std::unexpected(unknownKey(origin, name));
        }
        const Result<MachineValue> value = valueOf(*key, held, origin);
        if (!value) {
            return std::unexpected(value.error());
        }
        key->set(spec, *value);
    }
    if (!object->contains("operating_width_m")) {
        return std::unexpected(refused(origin, "operating_width_m", "the operating width is missing",
                                       "give operating_width_m in metres"));
    }
    if (spec.implement.mounting == Mounting::Trailed && !object->contains("implement_can_reverse")) {
        spec.implement.canReverse = false;
    }
    if (spec.name.empty()) {
        spec.name = spec.id.empty() ? std::filesystem::path{origin}.stem().string() : spec.id;
    }
    if (spec.id.empty()) {
        spec.id = spec.name;
    }
    return Machine::create(spec).transform_error([origin](Error error) {
        error.where = message("{}: {}", origin, error.where);
        return error;
    });
}

Result<Machine> readMachineFile(const std::filesystem::path& path) {
    const auto unreadable = [&path](Message what, Message remedy) {
        return std::unexpected(Error{.code = ErrorCode::ReadFailed,
                                     .what = std::move(what),
                                     .where = path.string(),
                                     .remedy = std::move(remedy)});
    };
    std::error_code status;
    if (!std::filesystem::exists(path, status)) {
        return unreadable("there is no such file", "check the path");
    }
    if (std::filesystem::is_directory(path, status)) {
        return unreadable("this is a folder", "give a machine file (JSON)");
    }
    std::ifstream file{path, std::ios::binary};
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        return unreadable("the file cannot be read", "check that you may read it");
    }
    return parseMachine(text.view(), path.string());
}

std::string machineJson(const MachineSpec& spec) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const MachineKey& key : kKeys) {
        const MachineValue value = key.get(spec);
        if (const double* number = std::get_if<double>(&value)) {
            json[std::string{key.key}] = *number;
        } else if (const bool* isSo = std::get_if<bool>(&value)) {
            json[std::string{key.key}] = *isSo;
        } else if (const auto* words = std::get_if<std::string>(&value)) {
            json[std::string{key.key}] = *words;
        }
    }
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace furrow
