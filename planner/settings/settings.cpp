#include "planner/settings/settings.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/settings/operation.h"

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

}  // namespace

void SettingReads::addValue(const Parameter& parameter) {
    const std::scoped_lock lock{mutex_};
    values_.insert(&parameter);
}

void SettingReads::addGiven(const Parameter& parameter) {
    const std::scoped_lock lock{mutex_};
    given_.insert(&parameter);
}

void SettingReads::add(const SettingReads& others) {
    const std::scoped_lock lock{mutex_, others.mutex_};
    values_.insert(others.values_.begin(), others.values_.end());
    given_.insert(others.given_.begin(), others.given_.end());
}

bool SettingReads::areEqualIn(const Settings& a, const Settings& b) const {
    const std::scoped_lock lock{mutex_};
    return std::ranges::all_of(values_,
                               [&](const Parameter* each) { return a.value(*each) == b.value(*each); }) &&
           std::ranges::all_of(given_,
                               [&](const Parameter* each) { return a.isSet(*each) == b.isSet(*each); });
}

Result<void> Settings::set(const Parameter& parameter, const SettingValue& value) {
    const auto wrongKind = [&](const Message& wanted) {
        return std::unexpected(refused(parameter, message("'{}' is not {}", settingText(value), wanted),
                                       message("give {}", wanted)));
    };
    Result<void> checked;
    if (std::holds_alternative<Auto>(value)) {
        if (!parameter.canBeAuto) {
            return wrongKind(parameter.kind == ParameterKind::Choice ? "one of its choices"
                                                                     : "a value of its own");
        }
    } else if (parameter.kind == ParameterKind::Flag) {
        if (!std::holds_alternative<bool>(value)) {
            return wrongKind("true or false");
        }
    } else if (parameter.kind == ParameterKind::Choice) {
        const auto* id = std::get_if<std::string>(&value);
        if (id == nullptr) {
            return wrongKind("one of its choices");
        }
        checked = checkChoice(parameter, *id);
    } else if (parameter.kind == ParameterKind::Line) {
        const auto* text = std::get_if<std::string>(&value);
        if (text == nullptr || !parsedLine(*text)) {
            return wrongKind("a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)");
        }
    } else if (parameter.kind == ParameterKind::Lines) {
        const auto* text = std::get_if<std::string>(&value);
        if (text == nullptr || !parsedLines(*text)) {
            return wrongKind(
                "lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))");
        }
    } else if (parameter.kind == ParameterKind::File) {
        if (!std::holds_alternative<std::string>(value)) {
            return wrongKind("the path of a file");
        }
    } else if (parameter.kind == ParameterKind::Place) {
        if (!std::holds_alternative<std::string>(value)) {
            return wrongKind("the name of a gate or a point in WGS84 such as POINT (4.1 52.0)");
        }
    } else if (parameter.kind == ParameterKind::Numbers) {
        const auto* text = std::get_if<std::string>(&value);
        if (text == nullptr || !parsedNumbers(*text)) {
            return wrongKind("whole numbers divided by commas");
        }
    } else {
        const auto* number = std::get_if<double>(&value);
        if (number == nullptr) {
            return wrongKind("a number");
        }
        checked = checkNumber(parameter, *number);
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

void Settings::writeDown(const SettingReads& reads) const {
    if (listener_.reads) {
        listener_.reads->add(reads);
    }
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
