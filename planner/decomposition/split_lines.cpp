#include "planner/decomposition/split_lines.h"

#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <limits>

namespace furrow {

namespace {

// An extended line reaches this far across the edge or line at its end, so that it is cut through.
constexpr double kPastEdgeM = 1e-3;

/// The distance from a point ahead to a segment. Infinite if it is not met.
double aheadM(Point from, Point along, Point a, Point b) {
    const auto [ahead, behind] = toMeeting(from, along, a, b - a);
    const bool meets = ahead > 0.0 && behind <= 0.0 && behind >= -1.0;
    return meets ? ahead : std::numeric_limits<double>::infinity();
}

/// One end of one of the lines.
struct LineEnd {
    std::size_t line;
    bool isLast;
};

class Splitter {
public:
    Splitter(std::vector<Polyline> lines, const MultiPolygon& mainland, Length most)
        : lines_{std::move(lines)}, mainland_{mainland}, most_{most} {}

    SplitLines drawnThrough() {
        SplitLines result{.lines = lines_, .faults = {}};
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            std::optional<SplitFault> fault;
            for (const bool isLast : {false, true}) {
                const LineEnd end{i, isLast};
                const std::optional<Length> missing = missingAt(end);
                if (!missing) {
                    continue;
                }
                Polyline& line = result.lines[i];
                const Point place = pointAt(end);
                if (*missing <= most_) {
                    const Point on = place + (missing->si() + kPastEdgeM) * directionAt(end);
                    line.insert(isLast ? line.end() : line.begin(), on);
                } else if (!fault || *missing > *fault->missing) {
                    fault = SplitFault{.line = i, .place = place, .missing = missing};
                }
            }
            if (!fault && !meetsMainland(lines_[i])) {
                fault = SplitFault{.line = i, .place = lines_[i].front(), .missing = {}};
            }
            if (fault) {
                result.faults.push_back(*fault);
            }
        }
        return result;
    }

private:
    Point pointAt(LineEnd end) const {
        return end.isLast ? lines_[end.line].back() : lines_[end.line].front();
    }

    Point directionAt(LineEnd end) const {
        const Polyline& line = lines_[end.line];
        const Point place = pointAt(end);
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Point way = place - (end.isLast ? line[line.size() - 1 - i] : line[i]);
            if (norm(way) > kContactM) {
                return (1.0 / norm(way)) * way;
            }
        }
        return {1.0, 0.0};
    }

    /// The straight distance from an end inside the mainland. Empty if the end is outside, or already on a
    /// line.
    std::optional<Length> missingAt(LineEnd end) const {
        const Point place = pointAt(end);
        if (!isInside(mainland_, place)) {
            return std::nullopt;
        }
        const Point along = directionAt(end);
        double nearestM = std::numeric_limits<double>::infinity();
        bool endsOnLine = false;
        forEachEdge(mainland_,
                    [&](Point a, Point b) { nearestM = std::min(nearestM, aheadM(place, along, a, b)); });
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const Polyline& line = lines_[i];
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                const bool isOwn = i == end.line && k == (end.isLast ? line.size() - 2 : 0);
                if (isOwn) {
                    continue;
                }
                endsOnLine = endsOnLine || distanceToSegment(place, line[k], line[k + 1]) < kContactM;
                nearestM = std::min(nearestM, aheadM(place, along, line[k], line[k + 1]));
            }
        }
        return endsOnLine ? std::nullopt : std::optional{metres(nearestM)};
    }

    bool meetsMainland(const Polyline& line) const {
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const Point way = line[k + 1] - line[k];
            bool meets = isInside(mainland_, line[k + 1]);
            forEachEdge(mainland_,
                        [&](Point a, Point b) { meets = meets || aheadM(line[k], way, a, b) <= 1.0; });
            if (meets) {
                return true;
            }
        }
        return false;
    }

    std::vector<Polyline> lines_;
    const MultiPolygon& mainland_;
    Length most_;
};

}  // namespace

SplitLines drawnThrough(std::vector<Polyline> lines, const MultiPolygon& mainland, Length most) {
    std::erase_if(lines, [](const Polyline& line) { return line.size() < 2; });
    return Splitter{std::move(lines), mainland, most}.drawnThrough();
}

}  // namespace furrow
