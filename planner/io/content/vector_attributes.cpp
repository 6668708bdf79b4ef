#include "planner/io/content/vector_attributes.h"

#include <algorithm>
#include <vector>

namespace furrow {

namespace {

/// @param name  of attributeNames()
const std::string& valueOf(const VectorFeature& feature, std::string_view name) {
    const auto names = attributeNames();
    return feature.attributes[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())];
}

}  // namespace

std::span<const std::string_view> attributeNames() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const std::span<const std::string_view> some :
             {std::span<const std::string_view>{kIdNames}, std::span<const std::string_view>{kNameNames},
              std::span<const std::string_view>{kLongitudeNames},
              std::span<const std::string_view>{kLatitudeNames}, std::span<const std::string_view>{kWktNames},
              std::span<const std::string_view>{kOtherNames}}) {
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }();
    return names;
}

const std::string& attribute(const VectorFeature& feature, AttributeName name) {
    return valueOf(feature, name.text());
}

std::string firstAttribute(const VectorFeature& feature, std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        if (const std::string& value = valueOf(feature, name); !value.empty()) {
            return value;
        }
    }
    return {};
}

std::string nameOf(const VectorFeature& feature) {
    return firstAttribute(feature, kNameNames);
}

std::string idOf(const VectorFeature& feature) {
    const std::string given = firstAttribute(feature, kIdNames);
    return given.empty() ? feature.key : given;
}

}  // namespace furrow
