#include "planner/headland/finishing_passes.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/convex_hull.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/turns/connection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kMostPasses = 32;
// A pass that gains less, as a share of the square of its width, is not worth lowering the implement for.
constexpr double kLeastGainShare = 0.05;
constexpr double kLookM = 0.15;
constexpr double kTouchingM = 1e-3;
// Beside an edge it keeps a finger's breadth, to get away from there again.
constexpr double kBesideEdgeM = 0.02;
// Edges that are shorter, as a share of the width, say nothing about where a pass could run.
constexpr double kShortestEdgeShare = 0.3;
constexpr std::size_t kMostGuides = 240;
// Lines as close to each other as this, the distance as a share of the width, are one.
constexpr double kSameDirectionRad = 0.03;
constexpr double kSameLineShare = 0.02;
// Edges no farther from a piece than this lie beside it.
constexpr double kNearM = 0.5;
// Passes that begin and end closer to each other than this share of the width are one.
constexpr double kSamePassShare = 0.15;
// How much farther in than flush with an edge a pass may lie, as shares of the width.
constexpr std::array kAside{0.0, 0.04, 0.1, 0.2, 0.4};

/// A pass of the implement: its middle goes from `from` to `to`.
struct Candidate {
    Point from;
    Point to;
    double gainM2 = 0.0;
};

Ring stripOf(const Candidate& candidate, double widthM) {
    const Point way = candidate.to - candidate.from;
    const Point side = (0.5 * widthM / norm(way)) * Point{-way.y, way.x};
    return {candidate.from - side, candidate.to - side, candidate.to + side, candidate.from + side};
}

/// Of the vehicle's reference point.
Turn lineOf(const Candidate& candidate, const Machine& machine) {
    const Point way = candidate.to - candidate.from;
    return {.type = {},
            .start = vehicleAt({.position = candidate.from, .heading = radians(std::atan2(way.y, way.x))}, machine),
            .pieces = {{.length = metres(norm(way)), .curvature = {}}}};
}

/// What of a ring lies on the left of a line (Sutherland & Hodgman 1974, doi 10.1145/360767.360802). Parts that come
/// apart stay joined by edges without area between them.
Ring leftOf(const Ring& ring, Point on, Point along) {
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point from = ring[i];
        const Point to = ring[(i + 1) % ring.size()];
        const double fromLeft = cross(along, from - on);
        const double toLeft = cross(along, to - on);
        if (fromLeft >= 0.0) {
            kept.push_back(from);
        }
        if ((fromLeft >= 0.0) != (toLeft >= 0.0)) {
            kept.push_back(from + (fromLeft / (fromLeft - toLeft)) * (to - from));
        }
    }
    return kept;
}

/// A line that a pass might follow, with the field on its left or right, and how far beside it.
struct Guide {
    Point on;
    Point along;  ///< unit vector
};

/// Edges of the field next to a piece, chords over its bends, and sides of the piece's own hull.
std::vector<Guide> guidesFor(const Polygon& piece, const MultiPolygon& workable, double widthM) {
    std::vector<Guide> guides;
    const auto add = [&](Point from, Point to) {
        const Point way = to - from;
        const double lengthM = norm(way);
        if (lengthM < kShortestEdgeShare * widthM) {
            return;
        }
        const Guide guide{.on = from, .along = (1.0 / lengthM) * way};
        const bool known = std::ranges::any_of(guides, [&](const Guide& other) {
            return dot(other.along, guide.along) > std::cos(kSameDirectionRad) &&
                   std::abs(cross(other.along, guide.on - other.on)) < kSameLineShare * widthM;
        });
        if (!known && guides.size() < kMostGuides) {
            guides.push_back(guide);
        }
    };
    const Bounds box = bounds({piece});
    const auto isNear = [&](Point a, Point b) {
        return std::min(a.x, b.x) < box.max.x + kNearM && std::max(a.x, b.x) > box.min.x - kNearM &&
               std::min(a.y, b.y) < box.max.y + kNearM && std::max(a.y, b.y) > box.min.y - kNearM;
    };
    const auto addRing = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            // The edge itself, or the chord over as many edges as make one long enough.
            std::size_t next = i + 1;
            while (next < i + ring.size() && distance(ring[i], ring[next % ring.size()]) < widthM) {
                ++next;
            }
            for (const std::size_t end : {i + 1, next}) {
                if (isNear(ring[i], ring[end % ring.size()])) {
                    add(ring[i], ring[end % ring.size()]);
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

class Chooser {
public:
    explicit Chooser(const FinishingTask& task)
        : task_{task},
          widthM_{task.lowered.machine().operatingWidth().si()},
          flushM_{0.5 * std::max(widthM_, task.lowered.machine().workingFootprintWidth().si()) + kBesideEdgeM},
          runInM_{task.lowered.machine().runIn().si()} {}

    /// The pass that works most of a piece; nothing where none is worth it.
    std::optional<Candidate> best(const Polygon& piece) const {
        std::optional<Candidate> best;
        for (const Guide& guide : guidesFor(piece, task_.workable, widthM_)) {
            for (const double sign : {1.0, -1.0}) {
                const Point along = sign * guide.along;
                // Rings have the field on their left: beside an edge, and farther in where that bends inwards.
                for (const double share : kAside) {
                    const double asideM = sign * (flushM_ + share * widthM_);
                    consider(piece, guide.on + asideM * Point{-along.y, along.x}, along, best);
                }
            }
        }
        return best;
    }

private:
    bool isRefused(const Candidate& candidate) const {
        const Turn line = lineOf(candidate, task_.lowered.machine());
        const auto isClose = [&](const Pose& a, const Pose& b) {
            return distance(a.position, b.position) < kSamePassShare * widthM_;
        };
        return std::ranges::any_of(task_.refused, [&](const PassStretch& stretch) {
            return isClose(stretch.line.start, line.start) && isClose(stretch.line.end(), line.end());
        });
    }

    double gainM2(const Polygon& piece, const Candidate& candidate) const {
        const Ring strip = stripOf(candidate, widthM_);
        const auto inStrip = [&](Ring ring) {
            for (std::size_t i = 0; i < strip.size() && !ring.empty(); ++i) {
                ring = leftOf(ring, strip[i], strip[(i + 1) % strip.size()] - strip[i]);
            }
            return ring.empty() ? 0.0 : signedAreaM2(ring);
        };
        double sum = inStrip(piece.outer);
        for (const Ring& hole : piece.holes) {
            sum += inStrip(hole);
        }
        return sum;
    }

    /// Along a line as far as the piece lies beside it: each stretch on which the machine has room.
    void consider(const Polygon& piece, Point on, Point along, std::optional<Candidate>& best) const {
        const Point side = (0.5 * widthM_) * Point{-along.y, along.x};
        const Ring inLane = leftOf(leftOf(piece.outer, on - side, along), on + side, -1.0 * along);
        if (inLane.size() < 3) {
            return;
        }
        const auto [first, last] = std::ranges::minmax(inLane, {}, [&](Point point) { return dot(along, point - on); });
        const double fromM = dot(along, first - on);
        const double toM = dot(along, last - on);
        const double leastM2 = best ? best->gainM2 : kLeastGainShare * widthM_ * widthM_;
        if (std::abs(signedAreaM2(inLane)) <= leastM2) {
            return;
        }
        const Angle heading = radians(std::atan2(along.y, along.x));
        const auto isFree = [&](double m) {
            const Pose pose = vehicleAt({.position = on + m * along, .heading = heading}, task_.lowered.machine());
            return task_.lowered.outsideM(Rig::inLine(pose)) <= kTouchingM;
        };
        const double stepM = std::max(kLookM, (toM - fromM) / 400.0);
        std::optional<double> begun;
        // With the run-in before it.
        for (double m = fromM - runInM_;; m += stepM) {
            const double here = std::min(m, toM);
            const bool free = isFree(here);
            if (free && !begun) {
                begun = here;
            }
            if (begun && (!free || here == toM)) {
                const double start = std::max(fromM, *begun + runInM_);
                const double end = free ? here : here - stepM;
                begun.reset();
                if (end - start > 2.0 * kLookM) {
                    Candidate candidate{.from = on + start * along, .to = on + end * along};
                    candidate.gainM2 = gainM2(piece, candidate);
                    if (candidate.gainM2 > (best ? best->gainM2 : leastM2) && !isRefused(candidate)) {
                        best = candidate;
                    }
                }
            }
            if (here == toM) {
                return;
            }
        }
    }

    const FinishingTask& task_;
    double widthM_;
    double flushM_;  ///< from an edge to the middle of a pass along it
    double runInM_;
};

}  // namespace

Result<std::vector<HeadlandPass>> finishingPasses(const FinishingTask& task, const JobContext& job) {
    const double widthM = task.lowered.machine().operatingWidth().si();
    const BoundaryDistance edges{task.workable, metres(1e4)};
    const Chooser chooser{task};
    MultiPolygon open = task.left;
    Area given;  // in pieces where nothing helps
    std::vector<HeadlandPass> passes;
    while (!open.empty() && passes.size() < kMostPasses) {
        const auto largest = std::ranges::max_element(open, {}, [](const Polygon& piece) { return area(piece); });
        const bool isEnough = area(open) + given <= task.mayStay && area(*largest) <= task.mayStayInOnePiece;
        if (isEnough || area(*largest).si() < kLeastGainShare * widthM * widthM) {
            break;
        }
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const std::optional<Candidate> found = chooser.best(*largest);
        if (!found) {
            given += area(*largest);
            open.erase(largest);
            continue;
        }
        const double fromEdgeM = edges.insideM(0.5 * (found->from + found->to)).value_or(0.0);
        passes.push_back({.ring = static_cast<int>(fromEdgeM / widthM),
                          .width = task.lowered.machine().operatingWidth(),
                          .closed = false,
                          .stretches = {{.line = lineOf(*found, task.lowered.machine())}}});
        auto rest = difference(open, {{.outer = stripOf(*found, widthM), .holes = {}}}, job);
        if (!rest) {
            return std::unexpected(rest.error());
        }
        open = std::move(*rest);
    }
    return passes;
}

const Parameter kHeadlandFinish{.key = "headland.finish",
                                .name = "Finish corners",
                                .description = "Short passes where corners would leave more than 1 % of the field.",
                                .kind = ParameterKind::Flag,
                                .standard = 1.0,
                                .choices = {}};

}  // namespace furrow
