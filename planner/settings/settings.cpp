#include "planner/settings/settings.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/wkt.h"
#include "planner/settings/operation.h"
#include "planner/settings/places.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <format>
#include <iterator>
#include <numeric>
#include <vector>

namespace furrow {

namespace {

Message rangeText(const Parameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::Length:
            return message("give a number from {} to {} m", parameter.min, parameter.max);
        case ParameterKind::Angle:
            return message("give a number from {} to {} degrees", parameter.min, parameter.max);
        case ParameterKind::Percent:
            return message("give a number from {} to {} %", parameter.min, parameter.max);
        default: return message("give a number from {} to {}", parameter.min, parameter.max);
    }
}

Error refused(const Parameter& parameter, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = std::string{parameter.key},
            .remedy = std::move(remedy)};
}

Result<void> checkNumber(const Parameter& parameter, double number) {
    const Message range = rangeText(parameter);
    if (!std::isfinite(number) || number < parameter.min || number > parameter.max) {
        return std::unexpected(refused(parameter, message("{} is out of range", number), range));
    }
    if (parameter.kind == ParameterKind::Count && number != std::floor(number)) {
        return std::unexpected(refused(parameter, message("{} is not a whole number", number), range));
    }
    return {};
}

Result<void> checkChoice(const Parameter& parameter, std::string_view id) {
    if (std::ranges::any_of(parameter.choices, [id](const Choice& choice) { return choice.id == id; })) {
        return {};
    }
    std::string known;
    for (const Choice& choice : parameter.choices) {
        known += (known.empty() ? "" : ", ") + std::string{choice.id};
    }
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = message("there is no '{}'", id),
                                 .where = std::string{parameter.key},
                                 .remedy = message("use one of: {}", known)});
}

/// Whole numbers divided by commas, blanks allowed; nothing where it is not that.
std::optional<std::vector<int>> parsedNumbers(std::string_view text) {
    std::vector<int> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skipBlanks = [&] {
        while (at != end && *at == ' ') {
            ++at;
        }
    };
    for (skipBlanks(); at != end; skipBlanks()) {
        if (!numbers.empty() && *at++ != ',') {
            return std::nullopt;
        }
        skipBlanks();
        int number = 0;
        const auto [stopped, error] = std::from_chars(at, end, number);
        if (error != std::errc{}) {
            return std::nullopt;
        }
        numbers.push_back(number);
        at = stopped;
    }
    return numbers;
}

bool isOnGlobe(const Point& point) {
    return std::abs(point.x) <= 180.0 && std::abs(point.y) <= 90.0;
}

GeoPoint geoPoint(const Point& point) {
    return {.lonDeg = point.x, .latDeg = point.y};
}

/// The lines of a WKT text; nothing where it holds something else or leaves the globe.
std::optional<std::vector<std::vector<GeoPoint>>> parsedLines(const std::string& text) {
    std::vector<std::vector<GeoPoint>> lines;
    if (text.empty()) {
        return lines;
    }
    const auto given = linesOfWkt(text);
    if (!given) {
        return std::nullopt;
    }
    for (const Polyline& line : *given) {
        if (!std::ranges::all_of(line, isOnGlobe)) {
            return std::nullopt;
        }
        std::ranges::transform(line, std::back_inserter(lines.emplace_back()), geoPoint);
    }
    return lines;
}

/// The points of a WKT line or point; nothing where it is not that or not on the globe.
std::optional<std::vector<GeoPoint>> parsedLine(const std::string& text) {
    std::vector<GeoPoint> line;
    if (text.empty()) {
        return line;
    }
    const auto points = pointsOfWkt(text);
    if (!points) {
        return std::nullopt;
    }
    if (!std::ranges::all_of(*points, isOnGlobe)) {
        return std::nullopt;
    }
    std::ranges::transform(*points, std::back_inserter(line), geoPoint);
    return line;
}

/// The kind of value that a parameter takes, where this is none of it.
std::optional<Message> wantedInstead(const Parameter& parameter, const SettingValue& value) {
    const ParameterKind kind = parameter.kind;
    if (std::holds_alternative<Auto>(value)) {
        return parameter.canBeAuto             ? std::nullopt
               : kind == ParameterKind::Choice ? std::optional<Message>{"one of its choices"}
                                               : std::optional<Message>{"a value of its own"};
    }
    const auto* const text = std::get_if<std::string>(&value);
    const auto unless = [](bool fits, Message wanted) {
        return fits ? std::nullopt : std::optional{std::move(wanted)};
    };
    switch (kind) {
        case ParameterKind::Flag: return unless(std::holds_alternative<bool>(value), "true or false");
        case ParameterKind::Choice: return unless(text != nullptr, "one of its choices");
        case ParameterKind::File: return unless(text != nullptr, "the path of a file");
        case ParameterKind::Place:
            return unless(text != nullptr, "the name of a gate or a point in WGS84 such as POINT (4.1 52.0)");
        case ParameterKind::Places:
            return unless(text != nullptr && givenPlaces(*text).has_value(),
                          "names of gates or points in WGS84 such as MULTIPOINT ((4.1 52.0), (4.2 52.0))");
        case ParameterKind::Line:
            return unless(text != nullptr && parsedLine(*text).has_value(),
                          "a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)");
        case ParameterKind::Lines:
            return unless(
                text != nullptr && parsedLines(*text).has_value(),
                "lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))");
        case ParameterKind::Numbers:
            return unless(text != nullptr && parsedNumbers(*text).has_value(),
                          "whole numbers divided by commas");
        default: return unless(std::holds_alternative<double>(value), "a number");
    }
}

}  // namespace

void SettingReads::addValue(const Parameter& parameter) {
    const std::scoped_lock lock{mutex_};
    values_.insert(&parameter);
}

void SettingReads::addGiven(const Parameter& parameter) {
    const std::scoped_lock lock{mutex_};
    given_.insert(&parameter);
}

bool SettingReads::areEqualIn(const Settings& a, const Settings& b) const {
    const std::scoped_lock lock{mutex_};
    return std::ranges::all_of(values_,
                               [&](const Parameter* each) { return a.value(*each) == b.value(*each); }) &&
           std::ranges::all_of(given_,
                               [&](const Parameter* each) { return a.isSet(*each) == b.isSet(*each); });
}

Result<void> Settings::set(const Parameter& parameter, const SettingValue& value) {
    const auto wanted = wantedInstead(parameter, value);
    if (wanted) {
        return std::unexpected(refused(parameter, message("'{}' is not {}", settingText(value), *wanted),
                                       message("give {}", *wanted)));
    }
    Result<void> checked;
    if (const auto* number = std::get_if<double>(&value)) {
        checked = checkNumber(parameter, *number);
    } else if (const auto* text = std::get_if<std::string>(&value);
               text != nullptr && parameter.kind == ParameterKind::Choice) {
        checked = checkChoice(parameter, *text);
    }
    if (!checked) {
        return checked;
    }
    // Only what differs is kept, so that two requests that mean the same compare equal. What depends on the
    // operation stays as it was given, whichever of the two is set first.
    if (value == parameter.defaultValue() && !isSetByOperation(parameter.key)) {
        clear(parameter);
    } else {
        given_.insert_or_assign(std::string{parameter.key}, value);
    }
    return {};
}

Result<void> Settings::setText(const Parameter& parameter, std::string_view text) {
    if (text == "auto" && parameter.canBeAuto) {
        return set(parameter, Auto{});
    }
    switch (parameter.kind) {
        case ParameterKind::Choice:
        case ParameterKind::Line:
        case ParameterKind::Lines:
        case ParameterKind::File:
        case ParameterKind::Place:
        case ParameterKind::Places:
        case ParameterKind::Numbers: return set(parameter, std::string{text});
        case ParameterKind::Flag:
            if (text == "true" || text == "false") {
                return set(parameter, text == "true");
            }
            return set(parameter, std::string{text});
        default: {
            double number = 0.0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            if (error != std::errc{} || end != text.data() + text.size()) {
                return set(parameter, std::string{text});
            }
            return set(parameter, number);
        }
    }
}

void Settings::add(const Settings& others) {
    for (const auto& [key, value] : others.given_) {
        given_.insert_or_assign(key, value);
    }
}

void Settings::clear(const Parameter& parameter) {
    if (const auto found = given_.find(parameter.key); found != given_.end()) {
        given_.erase(found);
    }
}

Settings Settings::writingDown(std::shared_ptr<SettingReads> reads) const {
    Settings listening = *this;
    listening.listener_.reads = std::move(reads);
    return listening;
}

SettingValue Settings::value(const Parameter& parameter) const {
    if (listener_.reads) {
        listener_.reads->addValue(parameter);
    }
    if (const auto found = given_.find(parameter.key); found != given_.end()) {
        return found->second;
    }
    if (isSetByOperation(parameter.key)) {
        return std::ranges::find(operation().defaults, parameter.key, &OperationDefault::key)->value;
    }
    return parameter.defaultValue();
}

const Operation& Settings::operation() const {
    return operationOf(choice(kOperationKind));
}

bool Settings::isSet(const Parameter& parameter) const {
    if (listener_.reads) {
        listener_.reads->addGiven(parameter);
    }
    return given_.contains(parameter.key);
}

std::optional<double> Settings::number(const Parameter& parameter) const {
    const SettingValue held = value(parameter);
    const auto* number = std::get_if<double>(&held);
    return number == nullptr ? std::nullopt : std::optional{*number};
}

std::optional<Length> Settings::length(const Parameter& parameter) const {
    return number(parameter).transform(metres);
}

std::optional<Angle> Settings::angle(const Parameter& parameter) const {
    return number(parameter).transform(degrees);
}

std::optional<int> Settings::count(const Parameter& parameter) const {
    return number(parameter).transform([](double held) { return static_cast<int>(held); });
}

std::optional<double> Settings::percent(const Parameter& parameter) const {
    return number(parameter);
}

std::string Settings::choice(const Parameter& parameter) const {
    return std::get<std::string>(value(parameter));
}

bool Settings::flag(const Parameter& parameter) const {
    return std::get<bool>(value(parameter));
}

std::vector<GeoPoint> Settings::line(const Parameter& parameter) const {
    return parsedLine(settingText(value(parameter))).value_or(std::vector<GeoPoint>{});
}

std::vector<std::vector<GeoPoint>> Settings::lines(const Parameter& parameter) const {
    return parsedLines(settingText(value(parameter))).value_or(std::vector<std::vector<GeoPoint>>{});
}

std::string Settings::file(const Parameter& parameter) const {
    return settingText(value(parameter));
}

std::string Settings::place(const Parameter& parameter) const {
    return settingText(value(parameter));
}

std::vector<int> Settings::numbers(const Parameter& parameter) const {
    return parsedNumbers(settingText(value(parameter))).value_or(std::vector<int>{});
}

std::string settingText(const SettingValue& value) {
    if (std::holds_alternative<Auto>(value)) {
        return "auto";
    }
    if (const auto* flag = std::get_if<bool>(&value)) {
        return *flag ? "true" : "false";
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return std::format("{}", *number);
    }
    return std::get<std::string>(value);
}

std::string nearestName(std::string_view name, std::span<const std::string_view> names) {
    // Levenshtein distance, one row at a time.
    const auto typingErrors = [](std::string_view a, std::string_view b) {
        std::vector<std::size_t> row(b.size() + 1);
        std::iota(row.begin(), row.end(), std::size_t{0});
        for (std::size_t i = 1; i <= a.size(); ++i) {
            std::size_t diagonal = row[0];
            row[0] = i;
            for (std::size_t j = 1; j <= b.size(); ++j) {
                const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
                diagonal = row[j];
                row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
            }
        }
        return row.back();
    };
    std::string_view best;
    std::size_t fewest = std::max<std::size_t>(3, name.size() / 2);
    for (const std::string_view candidate : names) {
        if (const std::size_t errors = typingErrors(name, candidate); errors < fewest) {
            fewest = errors;
            best = candidate;
        }
    }
    return std::string{best};
}

}  // namespace furrow
