#include "planner/settings/parameter.h"

namespace furrow {

SettingValue Parameter::defaultValue() const {
    if (kind == ParameterKind::Line || kind == ParameterKind::Numbers) {
        return std::string{};
    }
    if (!standard) {
        return Auto{};
    }
    switch (kind) {
        case ParameterKind::Flag: return *standard != 0.0;
        case ParameterKind::Choice: return std::string{choices[static_cast<std::size_t>(*standard)].id};
        default: return *standard;
    }
}

}  // namespace furrow
