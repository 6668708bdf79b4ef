#include "planner/io/plan_files/settings_file.h"

#include "planner/core/json_text.h"
#include "planner/core/text_file.h"
#include "planner/plan/method_registry.h"

#include <nlohmann/json.hpp>

namespace furrow {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// [3, -1] as "3,-1": how the settings hold lists.
std::string dividedByCommas(const OrderedJson& list) {
    std::string text;
    for (const OrderedJson& entry : list) {
        text += (text.empty() ? "" : ",") + entry.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    }
    return text;
}

Result<void> applyValue(Settings& settings, const std::string& key, const OrderedJson& value,
                        std::string_view origin) {
    const auto parameter = findParameter(key);
    Result<void> applied;
    if (!parameter) {
        applied = std::unexpected(parameter.error());
    } else if (value.is_boolean()) {
        applied = settings.set(**parameter, value.get<bool>());
    } else if (value.is_number()) {
        applied = settings.set(**parameter, value.get<double>());
    } else if (value.is_string() && value.get<std::string>() == "auto") {
        applied = settings.set(**parameter, Auto{});
    } else if (value.is_string()) {
        applied = settings.set(**parameter, value.get<std::string>());
    } else if (value.is_array()) {
        applied = settings.set(**parameter, dividedByCommas(value));
    } else {
        applied =
            std::unexpected(Error{.code = ErrorCode::InputRefused,
                                  .what = "a setting is a number, true, false, a name or a list of numbers",
                                  .where = key,
                                  .remedy = "correct its value"});
    }
    if (!applied) {
        Error error = applied.error();
        error.where = message("{}, {}", origin, error.where);
        return std::unexpected(error);
    }
    return {};
}

Result<void> applyObject(Settings& settings, const std::string& prefix, const OrderedJson& object,
                         std::string_view origin) {
    for (const auto& [name, value] : object.items()) {
        const std::string key = prefix.empty() ? name : prefix + "." + name;
        const auto applied = value.is_object() && prefix.empty() ? applyObject(settings, key, value, origin)
                                                                 : applyValue(settings, key, value, origin);
        if (!applied) {
            return applied;
        }
    }
    return {};
}

}  // namespace

Result<void> applySettingsJson(Settings& settings, std::string_view json, std::string_view origin) {
    const auto parsed = readJson<OrderedJson>(json, JsonKeys::Unique);
    if (!parsed) {
        const JsonFault& fault = parsed.error();
        return std::unexpected(
            Error{.code = ErrorCode::InputRefused,
                  .what = fault.what,
                  .where = fault.place.empty() ? Message{origin} : message("{}, {}", origin, fault.place),
                  .remedy = fault.remedy});
    }
    if (!parsed->is_object()) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "it is not a JSON object",
                                     .where = std::string{origin},
                                     .remedy = "give a JSON object such as {\"headland.width_m\": 12}"});
    }
    return applyObject(settings, "", *parsed, origin);
}

Result<void> applySettingsFile(Settings& settings, const std::filesystem::path& path) {
    return writtenText(path, "give a JSON file of settings").and_then([&](const std::string& text) {
        return applySettingsJson(settings, text, path.string());
    });
}

}  // namespace furrow
