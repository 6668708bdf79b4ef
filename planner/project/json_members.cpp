#include "planner/project/json_members.h"

#include <algorithm>

namespace furrow {

std::string otherMembers(const OrderedJson& object, std::initializer_list<std::string_view> known) {
    OrderedJson others = OrderedJson::object();
    for (const auto& [key, value] : object.items()) {
        if (std::ranges::find(known, std::string_view{key}) == known.end()) {
            others[key] = value;
        }
    }
    return others.empty() ? std::string{} : textOf(others);
}

void addMembers(OrderedJson& object, std::string_view others) {
    if (others.empty()) {
        return;
    }
    const OrderedJson added = OrderedJson::parse(others);
    for (const auto& [key, value] : added.items()) {
        if (!object.contains(key)) {
            object[key] = value;
        }
    }
}

std::string textOf(const OrderedJson& json) {
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace furrow
