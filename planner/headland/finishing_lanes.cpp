#include "planner/headland/finishing_lanes.h"

#include "planner/geometry/box_tree.h"
#include "planner/geometry/convex_hull.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/strip_area.h"
#include "planner/geometry/tolerances.h"
#include "planner/turns/connection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// Least gain worth lowering the implement for: in a small field a share of the land that may stay, but within
// these shares of the square of the width.
constexpr double kLeastGainOfStay = 0.1;
constexpr double kSmallestGainShare = 0.005;
constexpr double kLeastGainShare = 0.02;
constexpr double kLaneLookM = 0.15;
// Distance kept from an edge, so that the machine can leave it again.
constexpr double kBesideEdgeM = 0.02;
// Shorter edges, as a share of the width, give no direction for a pass.
constexpr double kShortestEdgeShare = 0.3;
// A pass goes no farther than 4 widths beyond the edge it lies beside.
constexpr double kBeyondWidths = 4.0;
// Edges within this distance lie beside a piece.
constexpr double kBesidePieceM = 0.5;
// Passes whose ends are closer than this share of the width are equal.
constexpr double kSamePassShare = 0.15;
// Distances of a pass from its flush position beside an edge, as shares of the width.
constexpr std::array kAside{0.0, 0.04, 0.1, 0.2, 0.4};
// Passes over a piece: number of headings, and distance between neighbours as a share of the width. Twice as
// fine where what is left blocks the plan.
constexpr int kHeadings = 24;
constexpr double kStepShare = 0.125;
// A hundred times what large fields take.
constexpr std::size_t kMostPointsClipped = 200'000'000;

/// A line for passes, as long as the edge, chord or side it comes from.
struct Guide {
    Point on;
    Point along;  ///< unit vector
    double lengthM = 0.0;
};

/// Edges of the field next to a piece, chords over its bends, and sides of the piece's own hull.
std::vector<Guide> guidesFor(const Polygon& piece, const MultiPolygon& workable, double widthM) {
    std::vector<Guide> guides;
    const auto add = [&](Point from, Point to) {
        const Point way = to - from;
        const double lengthM = norm(way);
        if (lengthM >= kShortestEdgeShare * widthM) {
            guides.push_back({.on = from, .along = (1.0 / lengthM) * way, .lengthM = lengthM});
        }
    };
    const Bounds box = bounds(piece);
    const auto isNear = [&](Point a, Point b) {
        return std::min(a.x, b.x) < box.max.x + kBesidePieceM &&
               std::max(a.x, b.x) > box.min.x - kBesidePieceM &&
               std::min(a.y, b.y) < box.max.y + kBesidePieceM &&
               std::max(a.y, b.y) > box.min.y - kBesidePieceM;
    };
    const auto addRing = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            // The edge itself, and the chord over enough edges to be long enough.
            std::size_t next = i + 1;
            while (next < i + ring.size() && distance(ring[i], ring[next % ring.size()]) < widthM) {
                ++next;
            }
            for (std::size_t end = i + 1;; end = next) {
                if (isNear(ring[i], ring[end % ring.size()])) {
                    add(ring[i], ring[end % ring.size()]);
                }
                if (end == next) {
                    break;
                }
            }
        }
    };
    for (const Polygon& polygon : workable) {
        addRing(polygon.outer);
        std::ranges::for_each(polygon.holes, addRing);
    }
    const Ring hull = convexHull(piece.outer);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        add(hull[i], hull[(i + 1) % hull.size()]);
    }
    return guides;
}

Strip stripAlong(const FinishingPass& pass, double widthM) {
    const Point way = pass.to - pass.from;
    const double lengthM = norm(way);
    return {
        .from = pass.from, .along = (1.0 / lengthM) * way, .lengthM = lengthM, .halfWidthM = 0.5 * widthM};
}

}  // namespace

Ring stripOf(const FinishingPass& pass, double widthM) {
    const Point way = pass.to - pass.from;
    const Point side = (0.5 * widthM / norm(way)) * Point{-way.y, way.x};
    return {pass.from - side, pass.to - side, pass.to + side, pass.from + side};
}

Curve lineOf(const FinishingPass& pass, const Machine& machine) {
    const Point way = pass.to - pass.from;
    return {
        .type = {},
        .start = vehicleAt({.position = pass.from, .heading = radians(std::atan2(way.y, way.x))}, machine),
        .pieces = {{.length = metres(norm(way)), .curvature = {}}}};
}

LeftLand::LeftLand(const MultiPolygon& all) {
    for (const Polygon& piece : all) {
        pieces_.push_back({piece, bounds(piece), furrow::area(piece)});
        inAll_ += pieces_.back().area;
        largest_ = std::max(largest_, pieces_.back().area);
    }
}

Result<LeftLand::Cut> LeftLand::cutBy(const MultiPolygon& worked, const JobContext& job) const {
    const Bounds box = bounds(worked);
    Cut made{.cut = {}, .rest = {}, .inAll = inAll_, .largest = {}};
    MultiPolygon near;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (meet(pieces_[i].box, box)) {
            made.cut.push_back(i);
            made.inAll = made.inAll - pieces_[i].area;
            near.push_back(pieces_[i].outline);
        } else {
            made.largest = std::max(made.largest, pieces_[i].area);
        }
    }
    return difference(near, worked, job).transform([&](const MultiPolygon& rest) {
        const LeftLand left{rest};
        made.rest = left.pieces_;
        made.inAll += left.inAll_;
        made.largest = std::max(made.largest, left.largest_);
        return std::move(made);
    });
}

void LeftLand::take(Cut cut) {
    for (const std::size_t gone : cut.cut | std::views::reverse) {
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    std::ranges::move(cut.rest, std::back_inserter(pieces_));
    inAll_ = cut.inAll;
    largest_ = cut.largest;
}

void LeftLand::sortLargestFirst() {
    std::ranges::stable_sort(pieces_, std::ranges::greater{}, &Piece::area);
}

FinishingLanes::FinishingLanes(const FinishingTask& task)
    : task_{task},
      widthM_{task.lowered.machine().operatingWidth().si()},
      flushM_{0.5 * std::max(widthM_, task.lowered.machine().workingFootprintWidth().si()) + kBesideEdgeM},
      runInM_{task.lowered.machine().runIn().si()} {}

const Ring& FinishingLanes::clippedBy(const Ring& strip, const Ring& ring) const {
    pointsClipped_ += ring.size();
    return clipping_.clipped(ring, strip);
}

bool FinishingLanes::isSpent() const {
    return pointsClipped_ > kMostPointsClipped;
}

double FinishingLanes::leastGainM2() const {
    return task_.untilTheLeast ? kSmallestGainShare * widthM_ * widthM_ : leastGainOfBendM2();
}

double FinishingLanes::leastGainOfBendM2() const {
    return std::clamp(kLeastGainOfStay * task_.mayStay.si(), kSmallestGainShare * widthM_ * widthM_,
                      kLeastGainShare * widthM_ * widthM_);
}

bool FinishingLanes::isRefused(const Curve& line) const {
    const auto isClose = [&](const Pose& a, const Pose& b) {
        return distance(a.position, b.position) < kSamePassShare * widthM_;
    };
    return std::ranges::any_of(task_.refused, [&](const PassStretch& stretch) {
        return isClose(stretch.line.start, line.start) && isClose(stretch.line.end(), line.end());
    });
}

std::vector<FinishingLane> FinishingLanes::beside(const Polygon& piece) const {
    std::vector<FinishingLane> lanes;
    for (const Guide& guide : guidesFor(piece, task_.workable, widthM_)) {
        if (isSpent()) {
            break;
        }
        for (const double sign : {1.0, -1.0}) {
            const Point along = sign * guide.along;
            const Point begin = sign > 0.0 ? guide.on : guide.on + guide.lengthM * guide.along;
            // Rings have the field on their left. Lanes lie beside an edge, and farther in for edges that
            // bend inwards.
            for (const double share : kAside) {
                const double asideM = sign * (flushM_ + share * widthM_);
                addLane(piece, begin + asideM * Point{-along.y, along.x}, along, guide.lengthM, lanes);
            }
        }
    }
    return lanes;
}

std::vector<FinishingLane> FinishingLanes::across(const Polygon& piece) const {
    std::vector<FinishingLane> lanes;
    const int headings = task_.untilTheLeast ? 2 * kHeadings : kHeadings;
    const double stepM = (task_.untilTheLeast ? 0.5 : 1.0) * kStepShare * widthM_;
    for (int i = 0; i < headings && !isSpent(); ++i) {
        const Point along = direction(2.0 * std::numbers::pi * i / headings);
        const Point side{-along.y, along.x};
        const auto [right, left] = std::ranges::minmax(piece.outer | std::views::transform([&](Point point) {
                                                           return dot(side, point - piece.outer.front());
                                                       }));
        for (double asideM = right - 0.5 * widthM_ + stepM; asideM < left + 0.5 * widthM_; asideM += stepM) {
            addLane(piece, piece.outer.front() + asideM * side, along, 0.0, lanes);
        }
    }
    return lanes;
}

double FinishingLanes::landBesideM2(const FinishingLane& lane, const LeftLand& left) const {
    const FinishingPass pass{.from = lane.on + (lane.fromM + runInM_) * lane.along,
                             .to = lane.on + lane.toM * lane.along};
    const Strip strip = stripAlong(pass, widthM_);
    const Bounds box = bounds(stripOf(pass, widthM_));
    double sumM2 = 0.0;
    for (const LeftLand::Piece& piece : left.pieces()) {
        if (meet(piece.box, box)) {
            pointsClipped_ += piece.outline.outer.size();
            sumM2 += areaInM2(piece.outline, strip);
        }
    }
    return sumM2;
}

std::optional<FinishingPass> FinishingLanes::passAlong(const FinishingLane& lane,
                                                       const LeftLand& left) const {
    // The run-in works nothing.
    const Point from = lane.on + (lane.fromM + runInM_) * lane.along;
    const Point to = lane.on + lane.toM * lane.along;
    const Ring strip = stripOf({.from = from, .to = to}, widthM_);
    const Bounds box = bounds(strip);
    FinishingPass candidate;
    double beginsM = lane.toM;
    double endsM = lane.fromM;
    for (const LeftLand::Piece& piece : left.pieces()) {
        if (!meet(piece.box, box)) {
            continue;
        }
        const Ring& inStrip = clippedBy(strip, piece.outline.outer);
        candidate.gainM2 += signedAreaM2(inStrip);
        for (const Point& point : inStrip) {
            const double m = dot(lane.along, point - lane.on);
            beginsM = std::min(beginsM, m);
            endsM = std::max(endsM, m);
        }
        for (const Ring& hole : piece.outline.holes) {
            candidate.gainM2 += signedAreaM2(clippedBy(strip, hole));
        }
    }
    if (candidate.gainM2 < leastGainM2() || endsM - beginsM <= 2.0 * kLaneLookM) {
        return std::nullopt;
    }
    candidate.from = lane.on + beginsM * lane.along;
    candidate.to = lane.on + endsM * lane.along;
    const Curve line = lineOf(candidate, task_.lowered.machine());
    return isRefused(line) || worksOnPurposeLeft(candidate) || !isClear(line) ? std::nullopt
                                                                              : std::optional{candidate};
}

std::optional<Curve> FinishingLanes::otherWay(const FinishingPass& pass) const {
    Curve line = lineOf({.from = pass.to, .to = pass.from}, task_.lowered.machine());
    return isRefused(line) || !isClear(line) ? std::nullopt : std::optional{std::move(line)};
}

std::vector<FinishingLane> FinishingLanes::free(const FinishingLane& lane) const {
    std::vector<FinishingLane> free;
    const Angle heading = radians(std::atan2(lane.along.y, lane.along.x));
    const auto roomM = [&](double m) {
        const Pose pose =
            vehicleAt({.position = lane.on + m * lane.along, .heading = heading}, task_.lowered.machine());
        return task_.lowered.roomM(Rig::inLine(pose));
    };
    std::optional<double> begun;
    bool isFree = false;
    double knownToM = -std::numeric_limits<double>::infinity();
    for (double m = lane.fromM;; m += kLaneLookM) {
        const double here = std::min(m, lane.toM);
        // A place that is inside or outside by a distance stays so for the same distance along the lane.
        if (here >= knownToM) {
            const double room = roomM(here);
            isFree = room >= -kContactM;
            knownToM = here + std::abs(room) - kContactM;
        }
        if (isFree && !begun) {
            begun = here;
        }
        if (begun && (!isFree || here == lane.toM)) {
            const double end = isFree ? here : here - kLaneLookM;
            if (end - *begun > runInM_ + 2.0 * kLaneLookM) {
                free.push_back(lane);
                free.back().fromM = *begun;
                free.back().toM = end;
                free.back().isFree = true;
            }
            begun.reset();
        }
        if (here == lane.toM) {
            return free;
        }
    }
}

/// Whether a pass would work land that is left on purpose, by more than rounding.
bool FinishingLanes::worksOnPurposeLeft(const FinishingPass& candidate) const {
    const Strip strip = stripAlong(candidate, widthM_);
    return std::ranges::any_of(task_.leftOnPurpose, [&](const Polygon& polygon) {
        return areaInM2(polygon, strip) > leastGainM2();
    });
}

/// Also checks between the sampled places.
bool FinishingLanes::isClear(const Curve& line) const {
    return task_.lowered.driven(Rig::inLine(line.start), line).has_value();
}

/// Adds the lane along a line as far as the piece lies beside it, not far beyond the guide, with the
/// run-in before it.
void FinishingLanes::addLane(const Polygon& piece, Point on, Point along, double lengthM,
                             std::vector<FinishingLane>& lanes) const {
    const Point side = (0.5 * widthM_) * Point{-along.y, along.x};
    const double beyondM = kBeyondWidths * widthM_;
    const Ring strip = {on - beyondM * along - side, on + (lengthM + beyondM) * along - side,
                        on + (lengthM + beyondM) * along + side, on - beyondM * along + side};
    const Ring& beside = clippedBy(strip, piece.outer);
    const double gainM2 = std::abs(signedAreaM2(beside));
    if (beside.empty() || gainM2 < leastGainM2()) {
        return;
    }
    const auto [first, last] =
        std::ranges::minmax(beside, {}, [&](Point point) { return dot(along, point - on); });
    lanes.push_back({.on = on,
                     .along = along,
                     .fromM = dot(along, first - on) - runInM_,
                     .toM = dot(along, last - on),
                     .gainM2 = gainM2});
}

}  // namespace furrow
