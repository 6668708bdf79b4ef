#pragma once

#include "planner/path/finding.h"
#include "planner/path/gate_ways.h"
#include "planner/path/path_builder.h"
#include "planner/turns/rig.h"

#include <array>
#include <optional>
#include <vector>

namespace furrow {

/// The ways in and out. On them, and on the ways from and to them, the implement is folded.
struct GateWays {
    std::optional<Pose> in;         ///< where the way in ends
    std::optional<Pose> out;        ///< where the way out begins
    std::vector<Finding> findings;  ///< gates to which no way leads, and why

    bool leads(const Pose& leaving, const Pose& arriving) const { return leaving == in || arriving == out; }
};

/// Start and end of a route, if they are given.
using RouteEnds = std::array<std::optional<RoutePlace>, 2>;

/// Puts the way in before the legs and the way out behind them. There has to be a leg.
GateWays addGateWays(std::vector<Leg>& legs, const RouteEnds& places, const Field& field, const Rig& rig);

}  // namespace furrow
