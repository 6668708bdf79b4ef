#include "planner/audit/driven_passes.h"

#include "planner/audit/boundary_index.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <utility>
#include <vector>

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

bool isNear(const Bounds& box, Point point, double near) {
    return point.x > box.min.x - near && point.x < box.max.x + near && point.y > box.min.y - near &&
           point.y < box.max.y + near;
}

/// A line of many points, with a box around every few of its edges.
class BoxedLine {
public:
    explicit BoxedLine(std::vector<Point> points) : points_{std::move(points)}, all_{bounds(points_)} {
        for (std::size_t first = 0; first + 1 < points_.size(); first += kEdges) {
            const std::size_t end = std::min(first + kEdges + 1, points_.size());
            boxes_.push_back(bounds(std::span{points_}.subspan(first, end - first)));
        }
    }

    bool passes(Point point, double near) const {
        for (std::size_t box = 0; isNear(all_, point, near) && box < boxes_.size(); ++box) {
            if (isNear(boxes_[box], point, near) && comesNear(box * kEdges, point, near)) {
                return true;
            }
        }
        return false;
    }

private:
    static constexpr std::size_t kEdges = 16;

    bool comesNear(std::size_t first, Point point, double near) const {
        for (std::size_t i = first + 1; i < std::min(first + kEdges + 1, points_.size()); ++i) {
            if (squaredDistanceToSegment(point, {points_[i - 1], points_[i]}) <= near * near) {
                return true;
            }
        }
        return false;
    }

    std::vector<Point> points_;
    Bounds all_;
    std::vector<Bounds> boxes_;
};

/// The tracks of tractor and implement in one segment.
class Track {
public:
    explicit Track(const SegmentMotion& motion)
        : tractor_{placesOf(motion, &MotionState::position)},
          implement_{placesOf(motion, &MotionState::implement)} {}

    bool passes(Point point, double near) const {
        return implement_.passes(point, near) || tractor_.passes(point, near);
    }

private:
    static std::vector<Point> placesOf(const SegmentMotion& motion, Point MotionState::* place) {
        std::vector<Point> places;
        std::ranges::transform(motion.states, std::back_inserter(places), place);
        return places;
    }

    BoxedLine tractor_;
    BoxedLine implement_;
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
