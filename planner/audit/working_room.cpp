#include "planner/audit/working_room.h"

#include "planner/audit/convex.h"
#include "planner/audit/length.h"
#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace furrow {

namespace {

constexpr int kHeadings = 48;
// Steps on the way that is as long as the run-in.
constexpr int kWayPoses = 2;
/// A smaller excess does not count, as everywhere in the audit.
constexpr double kTouchingM = 2.0 * kChordErrorM;
/// Shorter edges give no direction for a pass.
constexpr double kShortestEdgeM = 0.5;
constexpr double kFlatRingM2 = 1e-9;
/// Edges whose directions differ by less are one direction to try.
constexpr double kSameWay = 0.01;
/// Approximate number of squares across a piece.
constexpr double kSquaresAcross = 16.0;
constexpr double kLargestSquareM = 1.5;
/// A larger piece has room somewhere. If that much has been tested, the rest is taken to have room, too.
constexpr Area kLargestInDoubt = squareMetres(1000.0);
constexpr Area kMostInDoubt = squareMetres(20'000.0);

/// The centre of gravity of a ring. Empty if the ring has no area.
std::optional<Point> middleOf(const Ring& ring) {
    double twice = 0.0;
    Point sum;
    for (std::size_t i = 2; i < ring.size(); ++i) {
        const double part = cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
        twice += part;
        sum = sum + part * (ring[i - 1] + ring[i] - 2.0 * ring[0]);
    }
    return std::abs(twice) > kFlatRingM2 ? std::optional{ring[0] + (1.0 / (3.0 * twice)) * sum}
                                         : std::nullopt;
}

struct Rectangle {
    Point middle;
    double halfLengthM = 0.0;
    double halfWidthM = 0.0;
};

/// Adds the corners of a part after a move of `wayM` along an arc about its axle.
void addCorners(const Rectangle& part, Point axle, double wayM, double curvature1pm, Ring& corners) {
    const double turn = wayM * curvature1pm;
    const Point nose{std::cos(turn), std::sin(turn)};
    const Point moved =
        curvature1pm == 0.0 ? Point{wayM, 0.0} : (1.0 / curvature1pm) * Point{nose.y, 1.0 - nose.x};
    for (const double along : {-part.halfLengthM, part.halfLengthM}) {
        for (const double aside : {-part.halfWidthM, part.halfWidthM}) {
            const Point corner = part.middle - axle + Point{along, aside};
            corners.push_back(axle + moved + corner.x * nose + corner.y * Point{-nose.y, nose.x});
        }
    }
}

std::vector<Point> headingsAllRound() {
    std::vector<Point> noses;
    for (int i = 0; i < kHeadings; ++i) {
        const double heading = 2.0 * std::numbers::pi * i / kHeadings;
        noses.push_back({std::cos(heading), std::sin(heading)});
    }
    return noses;
}

/// The values of s for which an edge meets a convex ring moved by s to -y. Empty if it never does.
std::optional<std::pair<double, double>> meetingShifts(const Ring& ring, Edge edge) {
    if (edge.from.x > edge.to.x) {
        std::swap(edge.from, edge.to);
    }
    const double slope =
        edge.to.x > edge.from.x ? (edge.to.y - edge.from.y) / (edge.to.x - edge.from.x) : 0.0;
    std::pair<double, double> shifts{std::numeric_limits<double>::infinity(),
                                     -std::numeric_limits<double>::infinity()};
    const auto add = [&](double ringY, double edgeY) {
        shifts.first = std::min(shifts.first, ringY - edgeY);
        shifts.second = std::max(shifts.second, ringY - edgeY);
    };
    Point from = ring.back();
    for (const Point& to : ring) {
        if (to.x >= edge.from.x && to.x <= edge.to.x) {
            add(to.y, edge.from.y + (to.x - edge.from.x) * slope);
        }
        for (const Point& end : {edge.from, edge.to}) {
            if ((end.x - from.x) * (end.x - to.x) < 0.0) {
                add(from.y + (end.x - from.x) / (to.x - from.x) * (to.y - from.y), end.y);
            }
        }
        from = to;
    }
    return shifts.first < shifts.second ? std::optional{shifts} : std::nullopt;
}

}  // namespace

WorkingRoom::WorkingRoom(const MultiPolygon& drivable, const Machine& machine, const MachineShape& shape)
    : edges_{drivable}, halfWidthM_{0.5 * shape.operatingWidthM} {
    const Footprint footprint = footprintOf(machine);
    const Point axle{-shape.implementOffsetM, -shape.lateralOffsetM};  // from the middle of the working line
    const Rectangle tractor{.middle = axle + Point{footprint.tractor.offsetM, 0.0},
                            .halfLengthM = footprint.tractor.halfLengthM - kTouchingM,
                            .halfWidthM = footprint.tractor.halfWidthM - kTouchingM};
    const Rectangle implement{.middle = {},
                              .halfLengthM = std::max(0.0, footprint.lowered.halfLengthM - kTouchingM),
                              .halfWidthM = footprint.lowered.halfWidthM - kTouchingM};
    // The connection of the two is thin.
    const Rectangle bar{
        .middle = {0.5 * axle.x, axle.y}, .halfLengthM = 0.5 * std::abs(axle.x), .halfWidthM = 0.0};
    const double runInM = machine.runIn().si();
    const double sharpest1pm = 1.0 / machine.minTurningRadius().si();
    for (const double curvature1pm : {0.0, sharpest1pm, -sharpest1pm}) {
        Sweep sweep;
        for (const Rectangle& part : {tractor, implement, bar}) {
            Ring corners;
            for (int i = 0; i <= kWayPoses; ++i) {
                addCorners(part, axle, -runInM * i / kWayPoses, curvature1pm, corners);
            }
            Ring hull = hullAround(std::move(corners));
            sweep.push_back({.ring = hull, .box = bounds(hull)});
            for (const Point& corner : hull) {
                lookM_ = std::max(lookM_, lengthOf(corner) + halfWidthM_);
            }
        }
        sweeps_.push_back(std::move(sweep));
        if (runInM <= 0.0) {
            break;
        }
    }
}

bool WorkingRoom::reaches(Point place, Hint& hint) const {
    std::vector<Edge> edges;
    const Point look{lookM_, lookM_};
    edges_.visitNear({.min = place - look, .max = place + look}, [&](const Edge& edge) {
        if (squaredDistanceToSegment(place, edge) < lookM_ * lookM_) {
            edges.push_back(edge);
        }
    });
    std::ranges::sort(edges, {}, [](const Edge& edge) {
        return std::tuple{edge.from.x, edge.from.y, edge.to.x, edge.to.y};
    });
    const auto same = [](const Edge& a, const Edge& b) { return a.from == b.from && a.to == b.to; };
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());

    static const std::vector<Point> kAllRound = headingsAllRound();
    std::vector<Point> noses = kAllRound;
    std::vector<Point> ways;
    for (const Edge& edge : edges) {
        const Point way = edge.to - edge.from;
        const double lengthM = lengthOf(way);
        if (lengthM < kShortestEdgeM) {
            continue;
        }
        const Point along = (1.0 / lengthM) * way;
        const auto isSame = [along](Point other) {
            return std::min(std::abs(cross(along, other)), std::abs(dot(along, other))) < kSameWay;
        };
        if (std::ranges::none_of(ways, isSame)) {
            ways.push_back(along);
            const Point across{-along.y, along.x};
            noses.insert(noses.end(), {along, -1.0 * along, across, -1.0 * across});
        }
    }
    if (std::ranges::contains(noses, hint.nose) &&
        reachesAhead(place, hint.nose, edges, sweeps_[hint.sweep])) {
        return true;
    }
    for (std::size_t i = 0; i < sweeps_.size(); ++i) {
        const auto nose = std::ranges::find_if(
            noses, [&](Point each) { return reachesAhead(place, each, edges, sweeps_[i]); });
        if (nose != noses.end()) {
            hint = {.nose = *nose, .sweep = i};
            return true;
        }
    }
    return false;
}

// The working line lies over the place if that is s to the left of its middle. Each edge that meets a part
// for some s excludes an interval of s.
bool WorkingRoom::reachesAhead(Point place, Point nose, const std::vector<Edge>& edges,
                               const Sweep& sweep) const {
    std::vector<std::pair<double, double>> ruledOut;
    const Point left{-nose.y, nose.x};
    for (const Edge& edge : edges) {
        const Edge seen{{dot(edge.from - place, nose), dot(edge.from - place, left)},
                        {dot(edge.to - place, nose), dot(edge.to - place, left)}};
        const Bounds box = bounds(seen.from, seen.to);
        for (const auto& [part, around] : sweep) {
            // Edges before or behind the part, and those that it only meets farther aside than it may be.
            if (box.max.x < around.min.x || box.min.x > around.max.x ||
                around.max.y - box.min.y < -halfWidthM_ || around.min.y - box.max.y > halfWidthM_) {
                continue;
            }
            if (const auto interval = meetingShifts(part, seen)) {
                ruledOut.push_back(*interval);
            }
        }
    }
    std::ranges::sort(ruledOut);
    double free = -halfWidthM_;
    for (const auto& [begin, end] : ruledOut) {
        if (begin > free) {
            break;
        }
        free = std::max(free, end);
    }
    return free <= halfWidthM_;
}

namespace {

/// Squares over the parts of a polygon within reach, neighbours as one. Empty if all of it is within reach.
std::optional<MultiPolygon> squaresWithRoom(const Polygon& polygon, const WorkingRoom& room, double sizeM) {
    const Bounds box = bounds(polygon);
    MultiPolygon squares;
    WorkingRoom::Hint hint;
    bool isWhole = true;
    for (double y = box.min.y; y < box.max.y; y += sizeM) {
        Ring row = cut(cut(polygon.outer, {0.0, y}, {1.0, 0.0}).first, {0.0, y + sizeM}, {1.0, 0.0}).second;
        if (row.size() < 3) {
            continue;
        }
        const Bounds extent = bounds(row);
        std::optional<double> begun;
        const auto end = [&](double x) {
            if (begun) {
                squares.push_back(
                    {.outer = {{*begun, y}, {x, y}, {x, y + sizeM}, {*begun, y + sizeM}}, .holes = {}});
                begun.reset();
            }
        };
        for (double x = extent.min.x; x < extent.max.x && row.size() > 2; x += sizeM) {
            auto [square, rest] = cut(row, {x + sizeM, 0.0}, {0.0, 1.0});
            row = std::move(rest);
            const std::optional<Point> middle = middleOf(square);
            if (!middle) {
                continue;
            }
            if (room.reaches(*middle, hint)) {
                begun = begun.value_or(x);
            } else {
                isWhole = false;
                end(x);
            }
        }
        end(extent.max.x);
    }
    return isWhole ? std::nullopt : std::optional{std::move(squares)};
}

/// The parts of a piece with room, in squares of this size.
Result<MultiPolygon> partsOf(const Polygon& piece, const WorkingRoom& room, double sizeM,
                             const JobContext& job) {
    const std::optional<MultiPolygon> squares = squaresWithRoom(piece, room, sizeM);
    if (!squares) {
        return MultiPolygon{piece};
    }
    if (squares->empty()) {
        return MultiPolygon{};
    }
    // The sides of squares are equal to the last bit, so no grid is needed. On one, this was most of the time
    // of an audit.
    return unionOf(*squares, job).and_then([&](const MultiPolygon& one) {
        return intersection({piece}, one, job);
    });
}

}  // namespace

Result<MultiPolygon> partsWithRoom(const MultiPolygon& polygons, const WorkingRoom& room,
                                   Length operatingWidth, const JobContext& job, KnownPieces* known) {
    const double finestM = std::clamp(operatingWidth.si() / 16.0, 0.25, 0.5);
    MultiPolygon parts;
    Area looked;
    for (const Polygon& polygon : polygons) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (area(polygon) > kLargestInDoubt || looked > kMostInDoubt) {
            parts.push_back(polygon);
            continue;
        }
        looked += area(polygon);
        const auto withRoom = [&](const Polygon& piece) {
            const double sizeM =
                std::clamp(std::sqrt(area(piece).si()) / kSquaresAcross, finestM, kLargestSquareM);
            return partsOf(piece, room, sizeM, job);
        };
        auto some = known != nullptr ? known->get(polygon, withRoom) : withRoom(polygon);
        if (!some) {
            return some;
        }
        std::ranges::move(*some, std::back_inserter(parts));
    }
    std::ranges::stable_sort(parts, std::ranges::greater{}, [](const Polygon& part) { return area(part); });
    return parts;
}

}  // namespace furrow
