#include "planner/audit/driven_passes.h"

#include "planner/audit/boundary_index.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <map>

namespace furrow {

namespace {

constexpr int kPoints = 20;

/// Points evenly along a line, half a step from its ends.
std::vector<Point> pointsAlong(const Polyline& line) {
    const double whole = lengthM(line);
    std::vector<Point> points;
    double before = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double piece = distance(line[i - 1], line[i]);
        while (static_cast<int>(points.size()) < kPoints &&
               (static_cast<double>(points.size()) + 0.5) / kPoints * whole <= before + piece) {
            const double at = (static_cast<double>(points.size()) + 0.5) / kPoints * whole - before;
            points.push_back(line[i - 1] + (piece > 0.0 ? at / piece : 0.0) * (line[i] - line[i - 1]));
        }
        before += piece;
    }
    return points;
}

/// The tracks of tractor and implement in one segment.
class Track {
public:
    explicit Track(const SegmentMotion& motion) {
        for (const MotionState& state : motion.states) {
            tractor_.push_back(state.position);
            implement_.push_back(state.implement);
        }
        box_ = bounds({{.outer = tractor_, .holes = {}}});
        const Bounds behind = bounds({{.outer = implement_, .holes = {}}});
        box_.min = {std::min(box_.min.x, behind.min.x), std::min(box_.min.y, behind.min.y)};
        box_.max = {std::max(box_.max.x, behind.max.x), std::max(box_.max.y, behind.max.y)};
    }

    bool passes(Point point, double near) const {
        return point.x > box_.min.x - near && point.x < box_.max.x + near && point.y > box_.min.y - near &&
               point.y < box_.max.y + near &&
               (comesNear(implement_, point, near) || comesNear(tractor_, point, near));
    }

private:
    static bool comesNear(const std::vector<Point>& line, Point point, double near) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (squaredDistanceToSegment(point, {line[i - 1], line[i]}) <= near * near) {
                return true;
            }
        }
        return false;
    }

    std::vector<Point> tractor_;
    std::vector<Point> implement_;
    Bounds box_;
};

}  // namespace

std::vector<double> drivenShares(const AuditInput& input, const std::vector<SegmentMotion>& motions) {
    std::vector<Track> tracks;
    std::multimap<int, std::size_t> numbered;  // the path may be wrong, so a number only tells where to look
                                               // first
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (input.segments[i].implementDown) {
            numbered.emplace(input.segments[i].number, tracks.size());
            tracks.emplace_back(motions[i]);
        }
    }
    std::vector<double> shares;
    shares.reserve(input.passes.size());
    for (const PlannedPass& pass : input.passes) {
        const double near = 0.25 * pass.width.si();
        const auto [first, last] = numbered.equal_range(pass.number);
        std::vector<Point> points = pointsAlong(pass.line);
        std::erase_if(points, [&](Point point) { return isInside(input.leftOnPurpose, point); });
        const auto seen = std::ranges::count_if(points, [&](Point point) {
            return std::any_of(first, last,
                               [&](const auto& each) { return tracks[each.second].passes(point, near); }) ||
                   std::ranges::any_of(tracks, [&](const Track& track) { return track.passes(point, near); });
        });
        shares.push_back(points.empty() ? 1.0
                                        : static_cast<double>(seen) / static_cast<double>(points.size()));
    }
    return shares;
}

}  // namespace furrow
