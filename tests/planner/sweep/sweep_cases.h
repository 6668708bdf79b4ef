#pragma once

#include "tests/planner/sweep/sweep_values.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::test {

/// One setting and what is tried for it.
struct SweepSetting {
    std::string key;
    SweepValue value;

    std::string told() const { return key + "=" + value.label; }
};

/// What is changed, and what else has to be set for that to be read: the method that reads a setting, its
/// line.
struct SweepChange {
    std::vector<SweepSetting> changed;
    std::vector<SweepSetting> partners;

    /// "swaths.angle_deg=33 (swaths.method=fixed)"; "defaults" for nothing.
    std::string name() const;
};

/// A change on one shape with one machine.
struct SweepCase {
    std::string shape;
    std::string machine;  ///< its id
    SweepChange change;

    std::string name() const { return shape + " | " + machine + " | " + change.name(); }
};

/// No change, then every value of every setting of the method registry.
std::vector<SweepChange> everyChange();

/// `count` times two settings at once, drawn from `changes`, each pair once. The same seed draws the same.
std::vector<SweepChange> drawnPairs(const std::vector<SweepChange>& changes, std::size_t count,
                                    std::uint64_t seed);

/// Of every change on every shape with every machine those whose name falls into the share `oneIn`. A new
/// setting changes nothing in which of the others are drawn.
std::vector<SweepCase> drawnCases(const std::vector<SweepCase>& all, std::uint64_t oneIn, std::uint64_t seed);

/// All combinations, those of one shape and machine behind each other.
std::vector<SweepCase> casesOf(const std::vector<SweepChange>& changes,
                               const std::vector<std::string>& shapes,
                               const std::vector<std::string>& machines);

}  // namespace furrow::test
