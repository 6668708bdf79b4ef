#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/settings/parameter.h"
#include "planner/units/quantity.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

struct Operation;

class Settings;

/// Which settings a stage asked for while it ran: on others its result does not depend. Several threads may
/// ask.
class SettingReads {
public:
    void addValue(const Parameter& parameter);
    void addGiven(const Parameter& parameter);

    /// Whether both give the same answers to all questions.
    bool areEqualIn(const Settings& a, const Settings& b) const;

private:
    mutable std::mutex mutex_;
    std::set<const Parameter*> values_;
    std::set<const Parameter*> given_;  ///< asked whether they were given
};

/// The settings that differ from their defaults. What has been set fits its parameter: kind, range, choice.
class Settings {
public:
    /// Sets one value. InputRefused: wrong kind, out of range. Usage: no such choice (the message lists
    /// them).
    Result<void> set(const Parameter& parameter, const SettingValue& value);
    /// The same from text, as in `--set key=value`.
    Result<void> setText(const Parameter& parameter, std::string_view text);
    /// Sets what is set there; the rest stays.
    void add(const Settings& others);
    /// Back to the default.
    void clear(const Parameter& parameter);

    /// As given; what the operation sets; or the parameter's default.
    SettingValue value(const Parameter& parameter) const;
    bool isSet(const Parameter& parameter) const;
    /// Of operation.kind.
    const Operation& operation() const;

    std::optional<Length> length(const Parameter& parameter) const;
    std::optional<Angle> angle(const Parameter& parameter) const;
    std::optional<int> count(const Parameter& parameter) const;
    /// As given: 0.5 is half a percent.
    std::optional<double> percent(const Parameter& parameter) const;
    std::string choice(const Parameter& parameter) const;
    bool flag(const Parameter& parameter) const;
    std::vector<GeoPoint> line(const Parameter& parameter) const;
    std::vector<std::vector<GeoPoint>> lines(const Parameter& parameter) const;
    /// A file's path as it was given.
    std::string file(const Parameter& parameter) const;
    /// Names of gates or points as WKT, as they were given.
    std::string place(const Parameter& parameter) const;
    std::vector<int> numbers(const Parameter& parameter) const;

    /// The same settings; they and their copies write down what they are asked for.
    Settings writingDown(std::shared_ptr<SettingReads> reads) const;

    friend bool operator==(const Settings&, const Settings&) = default;

private:
    /// No part of the value: two settings are equal whoever listens.
    struct Listener {
        std::shared_ptr<SettingReads> reads;
        friend bool operator==(const Listener&, const Listener&) { return true; }
    };

    std::optional<double> number(const Parameter& parameter) const;
    std::map<std::string, SettingValue, std::less<>> given_;
    Listener listener_;
};

/// A value as text: "24", "auto", "true", "dubins".
std::string settingText(const SettingValue& value);

/// Of these names the one with the fewest typing errors against `name`; empty where none is near.
std::string nearestName(std::string_view name, std::span<const std::string_view> names);

}  // namespace furrow
