#include "planner/path/lifted_legs.h"

#include "planner/geometry/curve_parts.h"
#include "planner/swaths/mainland_edges.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

constexpr double kLookM = 0.25;
constexpr double kEndM = 0.01;
// Length of the chords that draw lanes in bends.
constexpr double kChordM = 1.0;

struct LoweredLine {
    Point right;
    Point left;
};

bool meets(const LoweredLine& line, Point from, Point to) {
    const Point along = line.left - line.right;
    const Point edge = to - from;
    const double fromSide = cross(along, from - line.right);
    const double toSide = cross(along, to - line.right);
    const double rightSide = cross(edge, line.right - from);
    const double leftSide = cross(edge, line.left - from);
    return (fromSide > 0.0) != (toSide > 0.0) && (rightSide > 0.0) != (leftSide > 0.0);
}

/// One polygon that is not worked.
class UnworkedLand {
public:
    explicit UnworkedLand(const Polygon& polygon)
        : polygon_{{polygon}}, edges_{polygon_}, box_{bounds(polygon_)} {}

    bool isTouched(const LoweredLine& line) const {
        if (std::max(line.right.x, line.left.x) < box_.min.x ||
            std::min(line.right.x, line.left.x) > box_.max.x ||
            std::max(line.right.y, line.left.y) < box_.min.y ||
            std::min(line.right.y, line.left.y) > box_.max.y) {
            return false;
        }
        bool touched = edges_.contains(line.right);
        forEachEdge(polygon_, [&](Point from, Point to) { touched = touched || meets(line, from, to); });
        return touched;
    }

private:
    MultiPolygon polygon_;
    MainlandEdges edges_;
    Bounds box_;
};

/// Poses along a line, with a fast lookup.
class PosesAlong {
public:
    explicit PosesAlong(const Curve& line) : line_{line} {
        Pose pose = line.start;
        for (const CurvePiece& piece : line.pieces) {
            begins_.push_back({lengthM_, pose});
            pose = advanced(pose, piece, piece.length);
            lengthM_ += piece.length.si();
        }
    }

    double lengthM() const { return lengthM_; }
    Pose at(double m) const {
        if (begins_.empty()) {
            return line_.start;
        }
        const auto after = std::ranges::upper_bound(begins_ | std::views::drop(1), m, {}, &Begin::m);
        const auto i = static_cast<std::size_t>(after - begins_.begin()) - 1;
        return advanced(begins_[i].pose, line_.pieces[i], metres(m - begins_[i].m));
    }

private:
    struct Begin {
        double m = 0.0;
        Pose pose;
    };
    const Curve& line_;
    std::vector<Begin> begins_;
    double lengthM_ = 0.0;
};

/// A stretch of a leg, in metres from its start.
struct Stretch {
    double fromM = 0.0;
    double toM = 0.0;
    bool works = true;
};

class Lifter {
public:
    Lifter(const MultiPolygon& unworked, const Machine& machine, Length shortest)
        : implement_{machine.spec().implement}, shortestM_{shortest.si()} {
        for (const Polygon& polygon : unworked) {
            land_.emplace_back(polygon);
        }
    }

    void add(const Leg& leg, LiftedLegs& result) const {
        const std::vector<Stretch> stretches =
            leg.implementDown ? stretchesOf(leg.line) : std::vector<Stretch>{};
        if (stretches.size() < 2 && (stretches.empty() || stretches.front().works)) {
            result.legs.push_back(leg);
            return;
        }
        for (const Stretch& stretch : stretches) {
            Leg part = leg;
            part.line = partOf(leg.line, metres(stretch.fromM), metres(stretch.toM));
            if (!stretch.works) {
                part.kind = SegmentKind::Transfer;
                part.number = 0;
                part.implementDown = false;
                addLanes(leg.line, stretch, result.passedOver);
            }
            result.legs.push_back(std::move(part));
        }
    }

private:
    LoweredLine at(const PosesAlong& line, double m) const {
        const Pose pose = line.at(m);
        const Point nose = direction(pose.heading.si());
        const Point left{-nose.y, nose.x};
        const Point middle =
            pose.position + implement_.offset.si() * nose + implement_.lateralOffset.si() * left;
        const double half = 0.5 * implement_.operatingWidth.si();
        return {.right = middle - half * left, .left = middle + half * left};
    }

    bool isUnworked(const PosesAlong& line, double m) const {
        const LoweredLine working = at(line, m);
        return std::ranges::any_of(land_, [&](const UnworkedLand& land) { return land.isTouched(working); });
    }

    /// The place of the change between two places that differ.
    double change(const PosesAlong& line, double fromM, double toM, bool fromIsUnworked) const {
        while (toM - fromM > kEndM) {
            const double middle = 0.5 * (fromM + toM);
            (isUnworked(line, middle) == fromIsUnworked ? fromM : toM) = middle;
        }
        // The land to be left is never entered.
        return fromIsUnworked ? toM : fromM;
    }

    std::vector<Stretch> stretchesOf(const Curve& driven) const {
        const PosesAlong line{driven};
        const double lengthM = line.lengthM();
        const int looks = std::max(1, static_cast<int>(std::ceil(lengthM / kLookM)));
        std::vector<Stretch> stretches;
        double fromM = 0.0;
        double lastM = 0.0;
        bool unworked = isUnworked(line, 0.0);
        for (int i = 1; i <= looks; ++i) {
            const double m = lengthM * i / looks;
            if (isUnworked(line, m) != unworked) {
                const double at = change(line, lastM, m, unworked);
                stretches.push_back({fromM, at, !unworked});
                fromM = at;
                unworked = !unworked;
            }
            lastM = m;
        }
        stretches.push_back({fromM, lengthM, !unworked});
        return withoutShort(std::move(stretches));
    }

    /// A stretch of work that is too short for lowering the implement joins its unworked neighbours.
    std::vector<Stretch> withoutShort(std::vector<Stretch> stretches) const {
        if (stretches.size() < 2) {
            return stretches;
        }
        std::vector<Stretch> kept;
        for (Stretch stretch : stretches) {
            stretch.works = stretch.works && stretch.toM - stretch.fromM >= shortestM_;
            if (!kept.empty() && kept.back().works == stretch.works) {
                kept.back().toM = stretch.toM;
            } else {
                kept.push_back(stretch);
            }
        }
        return kept;
    }

    void addLanes(const Curve& driven, const Stretch& stretch, MultiPolygon& lanes) const {
        const int chords = std::max(1, static_cast<int>(std::ceil((stretch.toM - stretch.fromM) / kChordM)));
        const bool straight = std::ranges::all_of(driven.pieces, [](const CurvePiece& piece) {
            return piece.curvature == Curvature{} && piece.endCurvature == Curvature{};
        });
        const PosesAlong line{driven};
        const int steps = straight ? 1 : chords;
        LoweredLine before = at(line, stretch.fromM);
        for (int i = 1; i <= steps; ++i) {
            const LoweredLine next = at(line, stretch.fromM + (stretch.toM - stretch.fromM) * i / steps);
            lanes.push_back({.outer = {before.right, next.right, next.left, before.left}, .holes = {}});
            before = next;
        }
    }

    const Implement& implement_;
    double shortestM_;
    std::vector<UnworkedLand> land_;
};

}  // namespace

LiftedLegs liftedOver(const std::vector<Leg>& legs, const MultiPolygon& unworked, const Machine& machine,
                      Length shortest) {
    if (unworked.empty()) {
        return {.legs = legs, .passedOver = {}};
    }
    const Lifter lifter{unworked, machine, shortest};
    LiftedLegs result;
    for (const Leg& leg : legs) {
        lifter.add(leg, result);
    }
    return result;
}

}  // namespace furrow
