#include "tests/planner/sweep/sweep_values.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"
#include "planner/settings/settings.h"
#include "tests/planner/sweep/site_marks.h"

#include <algorithm>
#include <format>
#include <map>

namespace furrow::test {

namespace {

using Maker = std::function<std::optional<std::string>(const SweepSite&)>;

// What people type, where it is not a default: little, as usual, much.
const std::map<std::string_view, std::vector<std::string>> kNumbers{
    {"field.margin_m", {"0.1", "0.5", "2"}},    {"field.overhang_m", {"0.5", "6"}},
    {"headland.width_m", {"0", "15", "40"}},    {"headland.passes", {"0", "1", "2", "3", "4"}},
    {"swaths.overlap_m", {"0.05", "0.3"}},      {"swaths.angle_deg", {"33", "90", "-45"}},
    {"swaths.step_deg", {"0.5", "5", "45"}},    {"swaths.tramline_every", {"2", "3", "4"}},
    {"swaths.round_up_to_m", {"0", "5", "20"}}, {"swaths.edge", {"1", "2", "9999"}},
    {"route.cluster", {"2", "3", "10"}},        {"route.skip", {"2", "3", "8"}},
};

SweepValue made(std::string label, Maker text, bool mustBeTold = false) {
    return {.label = std::move(label), .text = std::move(text), .mustBeTold = mustBeTold};
}

/// A length that goes with the machine.
SweepValue widths(double count) {
    return made(std::format("{} widths", count), [count](const SweepSite& site) {
        return std::format("{:.2f}", count * site.machine.operatingWidth().si());
    });
}

std::vector<SweepValue> numbers(const Parameter& parameter) {
    std::vector<SweepValue> values;
    if (const auto known = kNumbers.find(parameter.key); known != kNumbers.end()) {
        std::ranges::transform(known->second, std::back_inserter(values), fixedValue);
    } else {
        for (const double number : {parameter.min, parameter.min + parameter.step,
                                    parameter.standard.value_or(parameter.min) + 3.0 * parameter.step}) {
            if (number <= parameter.max && number != parameter.standard) {
                values.push_back(fixedValue(std::format("{}", number)));
            }
        }
    }
    if (parameter.key == "headland.width_m") {
        values.push_back(widths(1.5));
        values.push_back(widths(3.0));
    }
    if (parameter.key == "swaths.overlap_m") {
        values.push_back(widths(0.5));
    }
    return values;
}

std::vector<SweepValue> lines(std::string_view method) {
    if (method == "pivot") {
        return {made("the middle", [](const SweepSite& site) { return pointText(site, middleOf(site)); }),
                made("a corner", [](const SweepSite& site) {
                    return pointText(site, site.field->boundary().front().outer.front());
                })};
    }
    if (method == "a-plus") {
        return {made("the middle", [](const SweepSite& site) { return pointText(site, middleOf(site)); })};
    }
    if (method == "ab-curve") {
        return {made("a bend along the longest edge",
                     [](const SweepSite& site) { return lineText(site, bendAlongEdge(site)); })};
    }
    return {made("along the longest edge",
                 [](const SweepSite& site) { return lineText(site, besideLongestEdge(site, 0.5)); }),
            made("through the middle, 33 degrees off",
                 [](const SweepSite& site) { return lineText(site, throughMiddle(site, 33.0, 40.0)); })};
}

/// Lines that end up to an operating width short are drawn on: there is none where the field has no room for
/// more.
std::optional<std::string> endingInTheField(const SweepSite& site) {
    constexpr double kReachM = 8.0;
    constexpr double kWidths = 5.0;  // headlands are up to three
    const Polyline line = throughMiddle(site, 60.0, kReachM);
    const double roomM = insideM(site.field->drivable(), middleOf(site)) - kReachM;
    return roomM < kWidths * site.machine.operatingWidth().si() ? std::nullopt
                                                                : std::optional{lineText(site, line)};
}

std::vector<SweepValue> splits() {
    return {made("across the middle",
                 [](const SweepSite& site) { return lineText(site, throughMiddle(site, 90.0, 3000.0)); }),
            made("two lines",
                 [](const SweepSite& site) {
                     return std::format("MULTILINESTRING ({}, {})",
                                        lineText(site, throughMiddle(site, 90.0, 3000.0)).substr(11),
                                        lineText(site, throughMiddle(site, 10.0, 3000.0)).substr(11));
                 }),
            made("ends in the field", endingInTheField, true)};
}

std::vector<SweepValue> places() {
    return {made("beside the longest edge",
                 [](const SweepSite& site) {
                     const Polyline line = besideLongestEdge(site, 0.7);
                     return pointText(site, 0.5 * (line.front() + line.back()));
                 }),
            made("the middle", [](const SweepSite& site) { return pointText(site, middleOf(site)); }),
            made("the gate",
                 [](const SweepSite& site) -> std::optional<std::string> {
                     const auto& gates = site.field->source().gates;
                     return gates.empty() ? std::nullopt : std::optional{gates.back().name};
                 }),
            made(
                "outside",
                [](const SweepSite& site) {
                    return pointText(site, bounds(site.field->boundary()).max + Point{20.0, 20.0});
                },
                true)};
}

/// The numbers of the swaths of the default plan, which is as good as any for a first try.
std::vector<SweepValue> orders() {
    const auto order = [](bool backwards) {
        return [backwards](const SweepSite& site) -> std::optional<std::string> {
            if (!site.standard) {
                return std::nullopt;
            }
            std::string text;
            const auto count = static_cast<int>(site.standard->swaths.swaths.size());
            for (int i = 1; i <= count; ++i) {
                const int number = backwards ? count + 1 - i : i;
                text += std::format("{}{}{}", i == 1 ? "" : ",", i % 2 == 0 ? "-" : "", number);
            }
            return text;
        };
    };
    return {made("from the first", order(false)), made("from the last", order(true)), fixedValue("1")};
}

std::vector<SweepValue> texts(const Parameter& parameter, std::string_view method) {
    if (parameter.key == "swaths.rows") {
        return {made("a row every width", [](const SweepSite& site) { return rowFile(site, 1.0); }),
                made("a row every four widths", [](const SweepSite& site) { return rowFile(site, 4.0); })};
    }
    if (parameter.key == "swaths.elevation") {
        return {made("a slope", [](const SweepSite& site) { return heightFile(site, false); }),
                made("a hill", [](const SweepSite& site) { return heightFile(site, true); })};
    }
    if (parameter.key == "route.order") {
        return orders();
    }
    switch (parameter.kind) {
        case ParameterKind::Line: return lines(method);
        case ParameterKind::Lines: return splits();
        case ParameterKind::Place:
        case ParameterKind::Places: return places();
        case ParameterKind::Numbers: return {fixedValue("2"), fixedValue("1,3")};
        default: return {};
    }
}

}  // namespace

SweepValue fixedValue(std::string text) {
    return made(text, [text](const SweepSite&) { return text; });
}

std::vector<SweepValue> sweepValues(const Parameter& parameter, std::string_view method) {
    std::vector<SweepValue> values;
    switch (parameter.kind) {
        case ParameterKind::Choice:
            for (const Choice& choice : parameter.choices) {
                if (SettingValue{std::string{choice.id}} != parameter.defaultValue()) {
                    values.push_back(fixedValue(std::string{choice.id}));
                }
            }
            return values;
        case ParameterKind::Flag: return {fixedValue(parameter.standard == 1.0 ? "false" : "true")};
        case ParameterKind::Length:
        case ParameterKind::Angle:
        case ParameterKind::Percent:
        case ParameterKind::Count: return numbers(parameter);
        default: return texts(parameter, method);
    }
}

}  // namespace furrow::test
