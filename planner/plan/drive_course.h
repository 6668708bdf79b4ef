#pragma once

#include "planner/plan/plan.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// The machine at one moment of the drive over a plan.
struct DriveState {
    Duration time;  ///< since the start
    Length driven;  ///< since the start
    Length worked;  ///< of it with the implement down
    std::size_t segment = 0;
    Point position;   ///< of the reference point
    Angle heading;    ///< of the nose
    Point implement;  ///< middle of the working line; a trailed one is on its own track
    Angle implementHeading;
    Speed speed;
    Curvature curvature;
    /// In the tank or bunker; empty if the plan does not follow it.
    std::optional<double> level = {};
};

/// A plan as a drive that is looked at: where the machine is at any moment. The implement follows as in the
/// audit (SegmentMotion). Between two stations everything changes evenly; the error of a place is at most 1
/// cm. Immutable; thread-safe. About 100 bytes a station.
class DriveCourse {
public:
    /// Cancelled. Cost: O(samples), as one part of the audit.
    static Result<DriveCourse> of(const Plan& plan, const JobContext& job = {});

    Duration duration() const { return stations_.back().time; }
    Length length() const { return stations_.back().driven; }
    /// With the implement down.
    Length workedLength() const { return stations_.back().worked; }
    /// At a moment; before the start and after the end as there. Cost: O(log stations).
    DriveState at(Duration time) const;
    /// In driving order, with rising times; at least two.
    std::span<const DriveState> stations() const { return stations_; }
    /// The last station that is not after this moment. Cost: O(log stations).
    std::size_t stationBefore(Duration time) const;
    /// When a segment of the path begins.
    Duration startOf(std::size_t segment) const { return starts_[segment]; }
    std::size_t segmentCount() const { return starts_.size(); }
    /// Whether the implement is down from this station to the next.
    bool worksAfter(std::size_t station) const { return works_[station]; }

private:
    DriveCourse() = default;
    void add(const DriveState& state, bool works);

    std::vector<DriveState> stations_;
    std::vector<bool> works_;
    std::vector<Duration> starts_;
};

/// The angle of the steered wheels on this curvature, positive to the left.
Angle steeringAngle(const Machine& machine, Curvature curvature);

}  // namespace furrow
