#include "planner/io/content/field_choice.h"

#include "planner/geodesy/local_frame.h"
#include "planner/settings/settings.h"

#include <algorithm>
#include <charconv>
#include <format>
#include <string>
#include <utility>
#include <vector>

namespace furrow {

namespace {

constexpr std::size_t kFieldsListed = 20;

Error usage(Message what, Message remedy) {
    return {.code = ErrorCode::Usage, .what = std::move(what), .where = "field", .remedy = std::move(remedy)};
}

Message described(const FieldSource& field, std::size_t number) {
    std::string text = std::format("{}", number);
    if (field.id != text) {
        text += " " + field.id;
    }
    if (!field.name.empty() && field.name != field.id) {
        text += std::format(" '{}'", field.name);
    }
    return message("{} ({:.2f} ha)", text, inHectares(areaOf(field)));
}

Message listed(std::span<const FieldSource> fields) {
    Message text;
    for (std::size_t i = 0; i < std::min(fields.size(), kFieldsListed); ++i) {
        text = i == 0 ? described(fields[i], i + 1) : message("{}, {}", text, described(fields[i], i + 1));
    }
    if (fields.size() > kFieldsListed) {
        text = message("{} and {} more", text, fields.size() - kFieldsListed);
    }
    return text;
}

}  // namespace

Result<std::size_t> pickFieldIndex(std::span<const FieldSource> fields,
                                   std::optional<std::string_view> fieldId) {
    if (!fieldId) {
        if (fields.size() == 1) {
            return 0;
        }
        return std::unexpected(usage(message("the file has {} fields: {}", fields.size(), listed(fields)),
                                     "choose one by its number, id or name with --field-id"));
    }
    const std::string_view wanted = *fieldId;
    for (const auto member : {&FieldSource::id, &FieldSource::name}) {
        const auto first = std::ranges::find(fields, wanted, member);
        if (first == fields.end()) {
            continue;
        }
        if (std::ranges::find(first + 1, fields.end(), wanted, member) == fields.end()) {
            return static_cast<std::size_t>(first - fields.begin());
        }
        std::string numbers;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (fields[i].*member == wanted) {
                numbers += std::format("{}{}", numbers.empty() ? "" : ", ", i + 1);
            }
        }
        return std::unexpected(usage(message("several fields are called '{}'", wanted),
                                     message("choose one by its number in the file: {}", numbers)));
    }
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (error == std::errc{} && end == wanted.data() + wanted.size() && number >= 1 &&
        number <= fields.size()) {
        return number - 1;
    }
    std::vector<std::string_view> names;
    for (const FieldSource& field : fields) {
        names.push_back(field.id);
        names.push_back(field.name);
    }
    const std::string nearest = nearestName(wanted, names);
    return std::unexpected(
        usage(message("there is no field '{}' in the file", wanted),
              nearest.empty()
                  ? message("it has {}: {}", counted("{} field", "{} fields", fields.size()), listed(fields))
                  : message("did you mean '{}'?", nearest)));
}

Result<FieldSource> pickField(std::span<const FieldSource> fields, std::optional<std::string_view> fieldId) {
    return pickFieldIndex(fields, fieldId).transform([fields](std::size_t index) { return fields[index]; });
}

Area areaOf(const FieldSource& field) {
    Area sum;
    for (const GeoPolygon& part : field.parts) {
        sum += geodesicArea(part);
    }
    return sum;
}

}  // namespace furrow
