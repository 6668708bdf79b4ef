#include "planner/geometry/boundary_distance.h"

#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace furrow {

namespace {

// Large fields get larger cells.
constexpr double kMostCellsAcross = 500.0;
// Cell size as a share of the reach. Smaller cells hold fewer edges that are not near, but there are more
// cells.
constexpr double kCellShare = 0.5;
// Extra distance against rounding at the sides of cells.
constexpr double kSpareM = 1e-6;
// So few edges of a cell are all looked at.
constexpr std::size_t kFewEdges = 6;

bool isBefore(Point a, Point b) {
    return std::pair{a.x, a.y} < std::pair{b.x, b.y};
}

Point inwardNormal(Point from, Point to) {
    // The inside lies to the left of every edge: outer rings run counter-clockwise, holes clockwise.
    const Point way = to - from;
    const double length = norm(way);
    return length > 0.0 ? Point{-way.y / length, way.x / length} : Point{};
}

template <class Edges>
auto part(Edges& edges, std::uint32_t first, std::uint32_t last) {
    return std::span{edges}.subspan(first, last - first);
}

/// Puts those first, in their order, that are at most by `acrossM` farther away than the nearest. Returns
/// their number.
template <class Away>
std::uint32_t putNearestFirst(std::span<std::uint32_t> edges, double acrossM, const Away& awayM) {
    if (edges.size() < kFewEdges) {
        return static_cast<std::uint32_t>(edges.size());
    }
    std::vector<std::pair<double, std::uint32_t>> all;
    std::ranges::transform(edges, std::back_inserter(all),
                           [&](std::uint32_t e) { return std::pair{awayM(e), e}; });
    const double mostM = std::ranges::min_element(all)->first + acrossM;
    const auto others =
        std::ranges::stable_partition(all, [&](const auto& edge) { return edge.first <= mostM; });
    std::ranges::transform(all, edges.begin(), &std::pair<double, std::uint32_t>::second);
    return static_cast<std::uint32_t>(all.size() - others.size());
}

}  // namespace

inline std::optional<std::size_t> BoundaryDistance::cellOf(Point point) const {
    const double x = (point.x - corner_.x) * perCell_;
    const double y = (point.y - corner_.y) * perCell_;
    // Also false for NaN.
    if (!(x >= 0.0 && y >= 0.0 && x < static_cast<double>(columns_) && y < static_cast<double>(rows_))) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x);
}

inline std::span<const std::uint32_t> BoundaryDistance::edgesNear(Point point) const {
    const std::optional<std::size_t> cell = cellOf(point);
    return cell ? part(edgesOf_, firstOf_[2 * *cell], firstOf_[2 * *cell + 2])
                : std::span<const std::uint32_t>{};
}

BoundaryDistance::BoundaryDistance(const MultiPolygon& polygons, Length reach)
    : reachM_{reach.si()}, cellM_{kCellShare * reach.si()} {
    const auto add = [this](const Ring& ring) {
        const std::size_t size = ring.size();
        for (std::size_t i = 0; i < size; ++i) {
            const Point before = ring[(i + size - 1) % size];
            const Point from = ring[i];
            const Point to = ring[(i + 1) % size];
            const Point after = ring[(i + 2) % size];
            const Point own = inwardNormal(from, to);
            if (cross(to - from, after - to) < 0.0) {
                inwardCorners_.push_back(to);
            }
            const double square = dot(to - from, to - from);
            edges_.push_back({.from = from,
                              .way = to - from,
                              .perSquare = square > 0.0 ? 1.0 / square : 0.0,
                              .fromNormal = inwardNormal(before, from) + own,
                              .toNormal = own + inwardNormal(to, after)});
        }
    };
    for (const Polygon& polygon : polygons) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
    std::ranges::sort(inwardCorners_, {}, &Point::x);
    findMeetings();
    sortIntoCells();
    findSides();
}

void BoundaryDistance::findMeetings() {
    std::vector<Point> corners;
    std::ranges::transform(edges_, std::back_inserter(corners), &Edge::from);
    std::ranges::sort(corners, isBefore);
    for (std::size_t i = 1; i < corners.size(); ++i) {
        if (corners[i] == corners[i - 1]) {
            meetings_.push_back(corners[i]);
        }
    }
}

// A point nearest to a corner lies in the only gap between its edges of half a turn or more. The edge next to
// the point in angle is a side of that gap.
double BoundaryDistance::sideAtMeeting(Point point, Point corner) const {
    const Point away = point - corner;
    double nextTo = -std::numeric_limits<double>::infinity();
    double side = 0.0;
    for (const std::uint32_t e : edgesNear(point)) {
        const Edge& edge = edges_[e];
        const Point to = edge.from + edge.way;
        const bool begins = distance(edge.from, corner) < kRoundingM;
        if (begins == (distance(to, corner) < kRoundingM)) {
            continue;
        }
        const Point along = begins ? edge.way : -1.0 * edge.way;
        if (const double cosine = dot(away, along) / norm(along); cosine > nextTo) {
            nextTo = cosine;
            side = cross(edge.way, away);
        }
    }
    return side;
}

/// Each edge is cut into pieces no longer than a cell. It belongs to every cell within reach of the box
/// around a piece.
void BoundaryDistance::sortIntoCells() {
    if (edges_.empty()) {
        return;
    }
    Point low = edges_.front().from;
    Point high = low;
    for (const Edge& edge : edges_) {
        low = {std::min(low.x, edge.from.x), std::min(low.y, edge.from.y)};
        high = {std::max(high.x, edge.from.x), std::max(high.y, edge.from.y)};
    }
    cellM_ = std::max(cellM_, std::max(high.x - low.x, high.y - low.y) / kMostCellsAcross);
    perCell_ = 1.0 / cellM_;
    const Point reach{reachM_ + kSpareM, reachM_ + kSpareM};
    corner_ = low - reach;
    columns_ = cellAt(high + reach).first + 1;
    rows_ = cellAt(high + reach).second + 1;
    firstOf_.assign(2 * columns_ * rows_ + 1, 0);
    forEachCellNear(reachM_, [this](std::size_t cell, std::uint32_t) { ++firstOf_[2 * cell + 2]; });
    std::partial_sum(firstOf_.begin(), firstOf_.end(), firstOf_.begin());
    edgesOf_.resize(firstOf_.back());
    std::vector<std::uint32_t> next = firstOf_;
    forEachCellNear(reachM_, [&](std::size_t cell, std::uint32_t e) { edgesOf_[next[2 * cell]++] = e; });
    // No place of a cell is farther from its middle than half its diagonal.
    const double acrossM = std::numbers::sqrt2 * cellM_ + kSpareM;
    for (std::size_t cell = 0; cell < columns_ * rows_; ++cell) {
        const Point middle = corner_ + Point{(static_cast<double>(cell % columns_) + 0.5) * cellM_,
                                             (static_cast<double>(cell / columns_) + 0.5) * cellM_};
        const std::span<std::uint32_t> edges = part(edgesOf_, firstOf_[2 * cell], firstOf_[2 * cell + 2]);
        firstOf_[2 * cell + 1] =
            firstOf_[2 * cell] + putNearestFirst(edges, acrossM, [&](std::uint32_t e) {
                return distanceToSegment(middle, edges_[e].from, edges_[e].from + edges_[e].way);
            });
    }
}

// A cell without edges lies on one side of all edges. A line through the middles of its row tells which side.
void BoundaryDistance::findSides() {
    sides_.assign(columns_ * rows_, Side::Outside);
    std::vector<std::vector<double>> crossings(rows_);
    for (const Edge& edge : edges_) {
        const double fromY = (edge.from.y - corner_.y) / cellM_ - 0.5;
        const double toY = (edge.from.y + edge.way.y - corner_.y) / cellM_ - 0.5;
        for (double row = std::ceil(std::min(fromY, toY)); row < std::max(fromY, toY); row += 1.0) {
            const double x = edge.from.x + (row - fromY) / (toY - fromY) * edge.way.x;
            crossings[static_cast<std::size_t>(row)].push_back((x - corner_.x) / cellM_ - 0.5);
        }
    }
    for (std::size_t row = 0; row < rows_; ++row) {
        std::vector<double>& across = crossings[row];
        std::ranges::sort(across);
        for (std::size_t i = 1; i < across.size(); i += 2) {
            const auto first = sides_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
            std::fill(first + static_cast<std::ptrdiff_t>(std::ceil(across[i - 1])),
                      first + static_cast<std::ptrdiff_t>(std::ceil(across[i])), Side::Inside);
        }
    }
    forEachCellNear(0.0, [this](std::size_t cell, std::uint32_t) { sides_[cell] = Side::Both; });
}

template <class Visit>
void BoundaryDistance::forEachCellNear(double reachM, const Visit& visit) const {
    const Point reach{reachM + kSpareM, reachM + kSpareM};
    std::vector<std::uint32_t> visitedBy(columns_ * rows_, static_cast<std::uint32_t>(edges_.size()));
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        const Edge& edge = edges_[e];
        const auto pieces = static_cast<int>(std::ceil(norm(edge.way) / cellM_)) + 1;
        for (int i = 0; i < pieces; ++i) {
            const Point a = edge.from + (static_cast<double>(i) / pieces) * edge.way;
            const Point b = edge.from + (static_cast<double>(i + 1) / pieces) * edge.way;
            const auto [left, below] = cellAt(Point{std::min(a.x, b.x), std::min(a.y, b.y)} - reach);
            const auto [right, above] = cellAt(Point{std::max(a.x, b.x), std::max(a.y, b.y)} + reach);
            for (std::size_t y = below; y <= std::min(above, rows_ - 1); ++y) {
                for (std::size_t x = left; x <= std::min(right, columns_ - 1); ++x) {
                    const std::size_t cell = y * columns_ + x;
                    if (std::exchange(visitedBy[cell], e) != e) {
                        visit(cell, e);
                    }
                }
            }
        }
    }
}

bool BoundaryDistance::isInside(Point point) const {
    const std::optional<std::size_t> cell = cellOf(point);
    if (!cell || sides_[*cell] != Side::Both) {
        return cell && sides_[*cell] == Side::Inside;
    }
    // In large fields, cells are larger than the reach.
    bool inside = false;
    for (const Edge& edge : edges_) {
        inside ^= meetsRay(point, edge.from, edge.from + edge.way);
    }
    return inside;
}

std::pair<std::size_t, std::size_t> BoundaryDistance::cellAt(Point point) const {
    return {static_cast<std::size_t>(std::max(0.0, (point.x - corner_.x) * perCell_)),
            static_cast<std::size_t>(std::max(0.0, (point.y - corner_.y) * perCell_))};
}

std::span<const Point> BoundaryDistance::inwardCorners(double low, double high) const {
    return {std::ranges::lower_bound(inwardCorners_, low, {}, &Point::x),
            std::ranges::upper_bound(inwardCorners_, high, {}, &Point::x)};
}

std::optional<double> BoundaryDistance::insideM(Point point) const {
    // The share along the edge and the squared distance decide. More is needed for the nearest edge only.
    double nearest = std::numeric_limits<double>::infinity();
    double nearestShare = 0.0;
    const Edge* edge = nullptr;
    const std::optional<std::size_t> cell = cellOf(point);
    for (const std::uint32_t e : cell ? part(edgesOf_, firstOf_[2 * *cell], firstOf_[2 * *cell + 1])
                                      : std::span<const std::uint32_t>{}) {
        const Point from = point - edges_[e].from;
        const double share = std::clamp(dot(from, edges_[e].way) * edges_[e].perSquare, 0.0, 1.0);
        const Point away = from - share * edges_[e].way;
        if (const double square = dot(away, away); square < nearest) {
            nearest = square;
            nearestShare = share;
            edge = &edges_[e];
        }
    }
    if (nearest > reachM_ * reachM_) {
        return isInside(point) ? std::nullopt : std::optional{-reachM_};
    }
    const bool isCorner = nearestShare <= 0.0 || nearestShare >= 1.0;
    const Point place = edge->from + nearestShare * edge->way;
    const Point normal = !isCorner             ? Point{-edge->way.y, edge->way.x}
                         : nearestShare <= 0.0 ? edge->fromNormal
                                               : edge->toNormal;
    const auto isHere = [place](Point corner) { return distance(corner, place) < kRoundingM; };
    const double side = isCorner && std::ranges::any_of(meetings_, isHere) ? sideAtMeeting(point, place)
                                                                           : dot(point - place, normal);
    return side < 0.0 ? -std::sqrt(nearest) : std::sqrt(nearest);
}

double BoundaryDistance::crossedM(Point around, const Ring& shape) const {
    double deepest = 0.0;
    double farM = 0.0;
    for (const Point& corner : shape) {
        farM = std::max(farM, distance(around, corner));
    }
    // An edge is not in the shape if the shape only touches its line, for example on a pass flush with it.
    const auto onlyTouches = [&](const Edge& edge) {
        double left = 0.0;
        double right = 0.0;
        for (const Point& corner : shape) {
            const double side = cross(edge.way, corner - edge.from);
            left = std::max(left, side);
            right = std::max(right, -side);
        }
        return std::min(left, right) * std::sqrt(edge.perSquare) < kMeetM;
    };
    std::vector<double> shares;
    for (const std::uint32_t e : edgesNear(around)) {
        const Edge& edge = edges_[e];
        if (onlyTouches(edge) || distanceToSegment(around, edge.from, edge.from + edge.way) > farM) {
            continue;
        }
        shares.assign(1, 0.0);
        Point a = shape.back();
        for (const Point b : shape) {
            const Point side = b - a;
            const double turn = cross(edge.way, side);
            const double onSide = cross(a - edge.from, edge.way) / turn;
            const double share = cross(a - edge.from, side) / turn;
            if (turn != 0.0 && onSide >= 0.0 && onSide <= 1.0 && share > 0.0 && share < 1.0) {
                shares.push_back(share);
            }
            a = b;
        }
        shares.push_back(1.0);
        std::ranges::sort(shares);
        for (std::size_t i = 1; i < shares.size(); ++i) {
            const Point middle = edge.from + 0.5 * (shares[i - 1] + shares[i]) * edge.way;
            deepest = std::max(deepest, -awayFrom(shape, middle));
        }
    }
    return deepest;
}

bool BoundaryDistance::reachInto(Point origin, Point along, const Bounds& rectangle, double touchingM) const {
    const Bounds inner{.min = rectangle.min + Point{touchingM, touchingM},
                       .max = rectangle.max - Point{touchingM, touchingM}};
    if (inner.width() <= 0.0 || inner.height() <= 0.0) {
        return false;
    }
    const auto isIn = [&](const Edge& edge) {
        const Point from{dot(along, edge.from - origin), cross(along, edge.from - origin)};
        const Point way{dot(along, edge.way), cross(along, edge.way)};
        // The stretch of the edge between both pairs of sides (Liang & Barsky 1984,
        // doi 10.1145/357332.357333).
        double begins = 0.0;
        double ends = 1.0;
        const auto clip = [&](double at, double step, double low, double high) {
            if (step == 0.0) {
                ends = at > low && at < high ? ends : -1.0;
                return;
            }
            const double atLow = (low - at) / step;
            const double atHigh = (high - at) / step;
            begins = std::max(begins, std::min(atLow, atHigh));
            ends = std::min(ends, std::max(atLow, atHigh));
        };
        clip(from.x, way.x, inner.min.x, inner.max.x);
        clip(from.y, way.y, inner.min.y, inner.max.y);
        return begins < ends;
    };
    // Places on its middle line from which the whole rectangle is within reach.
    const double halfM = 0.5 * rectangle.height();
    const double apartM = 2.0 * std::sqrt(std::max(0.0, reachM_ * reachM_ - halfM * halfM));
    const auto count = std::max(1, static_cast<int>(std::ceil(rectangle.width() / apartM)));
    const Point across{-along.y, along.x};
    for (int i = 0; i < count; ++i) {
        const double x = rectangle.min.x + (i + 0.5) / count * rectangle.width();
        const Point place = origin + x * along + (rectangle.min.y + halfM) * across;
        if (std::ranges::any_of(edgesNear(place), [&](std::uint32_t e) { return isIn(edges_[e]); })) {
            return true;
        }
    }
    return false;
}

double awayFrom(const Ring& shape, Point point) {
    bool inside = false;
    double nearest = std::numeric_limits<double>::infinity();  // squared
    Point a = shape.back();
    for (const Point b : shape) {
        inside ^= meetsRay(point, a, b);
        const Point away = point - nearestOnSegment(point, a, b);
        nearest = std::min(nearest, dot(away, away));
        a = b;
    }
    return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

}  // namespace furrow
