#pragma once

#include "planner/core/message.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/point.h"
#include "planner/units/quantity.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

enum class SegmentKind { Swath, Turn, HeadlandPass, Transfer, Refill, Wait };

/// "swath", "turn", "headland_pass" ... as in plan files.
std::string_view segmentKindId(SegmentKind kind);
/// The kind with such an id. Empty for other texts.
std::optional<SegmentKind> segmentKindFrom(std::string_view id);

/// The vehicle at one instant.
struct PathSample {
    double sM = 0.0;            ///< distance driven since the start, m
    double tS = 0.0;            ///< time since the start, s
    Point position;             ///< of the tractor's reference point
    double headingRad = 0.0;    ///< of the nose, in [0, 2 pi)
    double curvature1pm = 0.0;  ///< positive to the left along the nose
    double speedMps = 0.0;      ///< not negative
    /// What is in the tank or bunker, in the user's own unit; empty if the plan does not follow it.
    std::optional<double> level = {};

    friend bool operator==(const PathSample&, const PathSample&) = default;
};

/// One piece of the path: a swath, a turn, ... with at least two samples.
struct PathSegment {
    SegmentKind kind = SegmentKind::Swath;
    std::string turnType;  ///< of turns: "dubins", "straight"
    int number = 0;        ///< of the swath, or of the headland pass from the outside; 0 for others
    Gear gear = Gear::Forward;
    bool implementDown = false;
    bool folded = false;   ///< driven with the implement folded for the road
    bool refills = false;  ///< at its end the machine stands at a refill point
    bool drivable = true;
    Message reason;  ///< why it is not drivable
    std::vector<PathSample> samples;

    Length length() const { return metres(samples.back().sM - samples.front().sM); }
    Duration duration() const { return seconds(samples.back().tS - samples.front().tS); }
    friend bool operator==(const PathSegment&, const PathSegment&) = default;
};

/// "swath 3", "headland pass 1": the name of a stretch in findings.
Message nameOf(const PathSegment& segment);
Message passName(SegmentKind kind, int number);

/// Whether a segment is on the way in before all work, or on the way out after it. The implement is folded
/// for transport there. Cost: O(segments).
bool isWayInOrOut(std::span<const PathSegment> segments, std::size_t segment);

/// The whole drivable line. Each segment starts at the end of the one before.
struct Path {
    std::vector<PathSegment> segments;

    Length length() const;
    Duration duration() const;
    /// The length of all segments of one kind.
    Length length(SegmentKind kind) const;
    Duration duration(SegmentKind kind) const;
    /// The length with the implement down: swaths and headland passes.
    Length workedLength() const;
    Duration workedDuration() const;
    /// The length in reverse gear.
    Length reversedLength() const;
    /// The number of ways from one swath to the next, regardless of their segments.
    int turnCount() const;
    /// How often the tank is filled or the bunker emptied.
    int refillCount() const;
    /// The number of these ways, of transfers and of ways to refill that contain a segment that cannot be
    /// driven.
    int undrivableCount() const;
    /// The worked stretch before or after a segment without work. Null at the path's ends.
    const PathSegment* workBefore(std::size_t segment) const;
    const PathSegment* workAfter(std::size_t segment) const;
    friend bool operator==(const Path&, const Path&) = default;
};

}  // namespace furrow
