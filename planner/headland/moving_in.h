#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <vector>

namespace furrow {

// Internal to the headland passes: a line moves in where the footprint would be outside.

/// Points of a ring that change it less are left out.
inline constexpr Length kRingTolerance = metres(5e-4);

/// A place where the footprint is outside, and the distance that the pass has to move in there.
struct Excess {
    Point place;
    double moveM = 0.0;
    double outsideM = 0.0;
};

/// The distance that the pass moves in at each place. It falls with the distance from the place of the
/// excess.
class Displacement {
public:
    explicit Displacement(double reachM) : reachM_{reachM} {}

    /// Adds the excesses of one round to those of the rounds before.
    void add(std::vector<Excess> excesses);
    bool isEmpty() const { return rounds_.empty(); }
    /// Whether the last round has moved this place.
    bool changedLastAt(Point point) const { return rounds_.empty() || mostAt(point, rounds_.back()) > 0.0; }
    double at(Point point) const;

private:
    double mostAt(Point point, const std::vector<Excess>& round) const;

    double reachM_;
    std::vector<std::vector<Excess>> rounds_;
};

/// All rings moved to the left of their direction, made valid. Cancelled.
Result<MultiPolygon> moved(const MultiPolygon& polygons, const Displacement& displacement,
                           const JobContext& job);

}  // namespace furrow
