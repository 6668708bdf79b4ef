#include "planner/settings/parameter.h"

namespace furrow {

bool isText(ParameterKind kind) {
    return kind == ParameterKind::Line || kind == ParameterKind::Lines || kind == ParameterKind::File ||
           kind == ParameterKind::Place || kind == ParameterKind::Places || kind == ParameterKind::Numbers;
}

SettingValue Parameter::defaultValue() const {
    if (isText(kind)) {
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
