#include "planner/io/files/json_values.h"

#include <limits>

namespace furrow {

double numberAt(const nlohmann::json& array, std::size_t index) {
    return array.is_array() && index < array.size() && array[index].is_number()
               ? array[index].get<double>()
               : std::numeric_limits<double>::quiet_NaN();
}

const nlohmann::json& memberOf(const nlohmann::json& object, const char* name) {
    static const nlohmann::json kNone;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return object.is_object() && found != object.end() ? *found : kNone;
}

std::string textOf(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : std::string{};
}

}  // namespace furrow
