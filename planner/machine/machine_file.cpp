#include "planner/machine/machine_file.h"

#include "planner/core/json_text.h"
#include "planner/core/text_file.h"
#include "planner/settings/settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <format>
#include <utility>
#include <vector>

namespace furrow {

namespace {

Error refused(std::string_view origin, const Message& place, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = place.empty() ? Message{origin} : message("{}, {}", origin, place),
            .remedy = std::move(remedy)};
}

Error unknownKey(std::string_view origin, std::string_view key) {
    std::vector<std::string_view> known;
    for (const MachineKey& entry : machineKeys()) {
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
    const auto json = readJson<nlohmann::json>(text, JsonKeys::Unique);
    if (!json) {
        return std::unexpected(refused(origin, json.error().place, json.error().what, json.error().remedy));
    }
    if (!json->is_object()) {
        return std::unexpected(refused(origin, "", "a machine is one JSON object",
                                       "write {\"name\": ..., \"operating_width_m\": ...}"));
    }
    return *json;
}

}  // namespace

Result<Machine> parseMachine(std::string_view json, std::string_view origin) {
    const Result<nlohmann::json> object = parsed(json, origin);
    if (!object) {
        return std::unexpected(object.error());
    }
    MachineSpec spec;
    for (const auto& [name, held] : object->items()) {
        const auto key = std::ranges::find(machineKeys(), std::string_view{name}, &MachineKey::key);
        if (key == machineKeys().end()) {
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
    return writtenText(path, "give a machine file (JSON)").and_then([&path](const std::string& text) {
        return parseMachine(text, path.string());
    });
}

std::string machineJson(const MachineSpec& spec) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const MachineKey& key : machineKeys()) {
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
