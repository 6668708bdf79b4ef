#include "planner/plan/shown_value.h"

#include "planner/settings/settings.h"

#include <algorithm>
#include <string>
#include <variant>

namespace furrow {

Message shownValue(const Parameter& parameter, const SettingValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) {
        return *flag ? Message{"on"} : Message{"off"};
    }
    if (parameter.kind == ParameterKind::Choice) {
        const auto found = std::ranges::find(parameter.choices, settingText(value), &Choice::id);
        return Message{found->name};
    }
    if (std::holds_alternative<Auto>(value)) {
        return "auto";
    }
    const auto* number = std::get_if<double>(&value);
    if (number != nullptr && parameter.kind == ParameterKind::Length) {
        return message("{:.2f} m", *number);
    }
    return Message{settingText(value).empty() ? "nothing" : settingText(value)};
}

}  // namespace furrow
