#include "planner/headland/headland_passes.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"
#include "planner/geometry/simplify.h"
#include "planner/headland/closed_rings.h"
#include "planner/headland/edge_strips.h"
#include "planner/headland/inner_passes.h"
#include "planner/headland/mirrored.h"
#include "planner/headland/pass_tracks.h"
#include "planner/headland/smooth_ring.h"
#include "planner/jobs/parallel.h"
#include "planner/turns/trailer.h"
#include "planner/turns/turn_method.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Passes with a smaller difference of inset run along the same line.
constexpr Length kSameInset = metres(0.01);
// Merged corners bring a pass nearer to the edge by less than this share of its width.
constexpr double kMergedShare = 0.1;

// A pass of 16 stretches or more is replaced by one with half as many or fewer: its edge is hard to follow.
constexpr std::size_t kManyStretches = 16;
constexpr std::size_t kTimesFewer = 2;
// Largest deviation of such a pass from its line, as a share of its width.
constexpr double kDrawnShare = 0.02;
// Distance before its many slight corners at which bends begin, as a share of its width: less steering.
constexpr double kGentleShare = 0.5;

CornerMethod cornerMethod(const Settings& settings) {
    const std::string id = settings.choice(kHeadlandCorner);
    return id == kLoopCorner      ? CornerMethod::Loop
           : id == kReverseCorner ? CornerMethod::Reverse
                                  : CornerMethod::Rounded;
}

/// The distances from the edge to the line of every pass, outermost first.
std::vector<Length> insets(int passes, const Machine& machine, Length margin) {
    std::vector<Length> all;
    all.reserve(static_cast<std::size_t>(passes));
    const Length first = margin + 0.5 * machine.workingFootprintWidth();
    for (int i = 0; i < passes; ++i) {
        all.push_back(first + i * machine.operatingWidth());
    }
    return all;
}

/// The distances from the edges to one ring: one for all edges, or one for each strip. Strips without such a
/// pass have none.
struct RingInsets {
    std::vector<Length> different;                    ///< all different
    std::vector<std::optional<std::size_t>> ofStrip;  ///< index into `different`; empty if one holds for all
};

/// For every ring, outermost first.
std::vector<RingInsets> ringsOf(const Headland& headland, const Machine& machine, Length margin) {
    std::vector<RingInsets> rings;
    if (headland.strips.empty()) {
        for (const Length inset : insets(headland.passes, machine, margin)) {
            rings.push_back({.different = {inset}, .ofStrip = {}});
        }
        return rings;
    }
    for (std::size_t i = 0; i < headland.strips.size(); ++i) {
        const std::vector<Length> own = insets(headland.strips[i].passes, machine, margin);
        rings.resize(std::max(rings.size(), own.size()));
        for (std::size_t ring = 0; ring < own.size(); ++ring) {
            RingInsets& all = rings[ring];
            all.ofStrip.resize(headland.strips.size());
            const auto known = std::ranges::find_if(all.different, [&](Length inset) {
                return std::abs((inset - own[ring]).si()) < kSameInset.si();
            });
            all.ofStrip[i] = static_cast<std::size_t>(known - all.different.begin());
            if (known == all.different.end()) {
                all.different.push_back(own[ring]);
            }
        }
    }
    for (RingInsets& ring : rings) {
        const bool isWhole =
            ring.different.size() == 1 &&
            std::ranges::all_of(ring.ofStrip, [](const auto& one) { return one.has_value(); });
        if (isWhole) {
            ring.ofStrip.clear();
        }
    }
    return rings;
}

std::size_t stretchCount(const std::vector<HeadlandPass>& passes) {
    return std::transform_reduce(passes.begin(), passes.end(), std::size_t{0}, std::plus{},
                                 [](const HeadlandPass& pass) { return pass.stretches.size(); });
}

/// The area inside closed lines round a field and its obstacles.
Result<MultiPolygon> insideOf(const std::vector<Curve>& lines, const JobContext& job) {
    MultiPolygon rings;
    for (const Curve& line : lines) {
        Ring ring;
        for (const CurveSample& sample : sampled(line, kArcTolerance)) {
            ring.push_back(sample.pose.position);
        }
        rings.push_back({.outer = std::move(ring), .holes = {}});
    }
    return madeValid(rings, job);
}

/// The passes of a ring inside the outermost one, which run along the edges with their corners kept sharp.
/// Edges that jut back and forth within less than a turn, for example traced from an image, would cut them
/// into many stretches. They then run beside the outermost pass, which goes round such edges smoothly.
/// @param along      those along the edges
/// @param outermost  its lines; empty if they could not be made
Result<std::vector<HeadlandPass>> besideOutermost(std::vector<HeadlandPass> along, const PassTask& task,
                                                  const std::vector<Curve>& outermost, Length fromOutermost,
                                                  int ring, const JobContext& job) {
    if (outermost.empty() || stretchCount(along) < kManyStretches) {
        return along;
    }
    const auto region = insideOf(outermost, job).and_then([&](const MultiPolygon& inside) {
        return eroded(inside, fromOutermost, kArcTolerance, job);
    });
    if (!region) {
        return std::unexpected(region.error());
    }
    // An offset of arcs drawn as chords has more bends than a driver can follow.
    const Length drawn = kDrawnShare * task.machine.operatingWidth();
    MultiPolygon plain;
    for (const Polygon& polygon : *region) {
        plain.push_back({.outer = simplifiedRing(polygon.outer, drawn), .holes = {}});
        for (const Ring& hole : polygon.holes) {
            plain.back().holes.push_back(simplifiedRing(hole, drawn));
        }
    }
    std::vector<HeadlandPass> beside =
        passesOn(plain, task, ring, kGentleShare * task.machine.operatingWidth());
    return kTimesFewer * stretchCount(beside) <= stretchCount(along) ? std::move(beside) : std::move(along);
}

/// A rounded line that is not inside everywhere is driven in the parts that are inside.
std::vector<HeadlandPass> cutWhereOutside(std::vector<HeadlandPass> passes, const PassTask& task,
                                          const JobContext& job) {
    for (HeadlandPass& pass : passes) {
        // Corners that are driven into were checked with their manoeuvres.
        if (!pass.closed || pass.stretches.size() != 1) {
            continue;
        }
        std::vector<Curve> parts = partsInside(pass.stretches.front().line, task.drivable, task.machine, job);
        const bool isWhole = parts.size() == 1 && parts.front() == pass.stretches.front().line;
        if (!isWhole) {
            pass.closed = false;
            pass.stretches.clear();
            for (Curve& part : parts) {
                pass.stretches.push_back({.line = std::move(part)});
            }
        }
    }
    std::erase_if(passes, [](const HeadlandPass& pass) { return pass.stretches.empty(); });
    return passes;
}

/// The passes of a ring that does not go all round, or has different distances from the edge.
Result<std::vector<HeadlandPass>> partsOfRing(const Headland& headland, const EdgeStrips& strips,
                                              const RingInsets& insets, int ring, const PassTask& task,
                                              const JobContext& job) {
    const BoundaryDistance mainland{headland.mainland, task.machine.operatingWidth()};
    std::vector<HeadlandPass> passes;
    for (std::size_t k = 0; k < insets.different.size(); ++k) {
        const auto distanceM = [&](Point place, std::size_t strip) {
            return distanceToSegment(place, strips.all()[strip].from, strips.all()[strip].to);
        };
        // Nearer to the edge it is an extended pass along another edge.
        const double leastM = (insets.different[k] - kMergedShare * task.machine.operatingWidth()).si();
        const auto belongs = [&](Point place) {
            const std::size_t nearest = strips.nearest(place);
            return insets.ofStrip[nearest] == k && distanceM(place, nearest) > leastM;
        };
        const auto isLeft = [&](Point place) {
            const std::size_t nearest = strips.nearest(place);
            const bool isOther = insets.ofStrip[nearest] != k;
            const bool hasPasses = isOther && distanceM(place, nearest) < strips.all()[nearest].width.si();
            return !hasPasses && mainland.insideM(place).value_or(-1.0) < 0.0;
        };
        const auto whole = innerPasses(task, insets.different[k], ring, job);
        if (!whole) {
            return std::unexpected(whole.error());
        }
        std::ranges::move(partsOf(*whole, belongs, isLeft, task), std::back_inserter(passes));
    }
    return passes;
}

/// The area that a rounded outermost pass leaves, for the user.
void addUncut(const ClosedRing& outermost, const Machine& machine, Headland& headland) {
    headland.uncutStrip += outermost.movedIn;
    for (const RoundedCorner& corner : outermost.rounded) {
        headland.uncutCorners += uncutCorner(corner, machine.operatingWidth());
    }
}

/// What is known of a ring without the others.
struct RingAlone {
    std::vector<HeadlandPass> parts;   ///< where it does not go all round, and along strips
    std::optional<ClosedRing> closed;  ///< else
    std::vector<HeadlandPass> along;   ///< else: along the edges
};

/// Empty for no strips with their own headlands.
using OwnStrips = std::optional<EdgeStrips>;

Result<RingAlone> ringAlone(const Headland& headland, const OwnStrips& strips, const RingInsets& insets,
                            int ring, const PassTask& task, const JobContext& job) {
    const Machine& machine = task.machine;
    const CornerMethod method = cornerMethod(task.settings);
    RingAlone made;
    if (!insets.ofStrip.empty()) {
        return partsOfRing(headland, *strips, insets, ring, task, job)
            .transform([&](std::vector<HeadlandPass>&& parts) {
                made.parts = std::move(parts);
                return std::move(made);
            });
    }
    const Length inset = insets.different.front();
    if (ring > 0) {
        auto narrow = passesAlongStrips(task, inset - 0.5 * machine.operatingWidth(), ring, job);
        if (!narrow) {
            return std::unexpected(narrow.error());
        }
        made.parts = *std::move(narrow);
    }
    // A machine that cannot reverse would not get out of a corner again.
    if (ring == 0 || method != CornerMethod::Rounded || !canReverse(machine)) {
        // A trailed boom comes to the edge on its own track.
        const Length beside = Trailer::of(machine) ? kBesideEdge : Length{};
        auto closed = closedRing(task, inset + beside, ring, method, job);
        if (!closed) {
            return std::unexpected(closed.error());
        }
        if (closed->complete) {
            if (!closed->inside) {
                closed->passes = cutWhereOutside(std::move(closed->passes), task, job);
            }
            made.closed = *std::move(closed);
            return made;
        }
    }
    return innerPasses(task, inset, ring, job).transform([&](std::vector<HeadlandPass>&& along) {
        made.along = std::move(along);
        return std::move(made);
    });
}

/// Adds the passes of all rings, counter-clockwise.
Result<void> addRings(Headland& headland, const PassTask& task, const JobContext& job) {
    const Machine& machine = task.machine;
    headland.uncutStrip = uncutEdge(machine);
    const std::vector<RingInsets> all = ringsOf(headland, machine, task.margin);
    const OwnStrips strips =
        headland.strips.empty() ? std::nullopt : std::optional<EdgeStrips>{headland.strips};
    auto rings = parallelMap<Result<RingAlone>>(
        all.size(),
        [&](std::size_t i) {
            return ringAlone(headland, strips, all[i], static_cast<int>(i), task, job.withoutProgress());
        },
        job.withoutProgress());
    if (!rings) {
        return std::unexpected(rings.error());
    }
    const auto keep = [&](std::vector<HeadlandPass> passes) {
        std::ranges::move(passes, std::back_inserter(headland.drivenPasses));
    };
    std::vector<Curve> outermost;
    for (std::size_t i = 0; i < all.size(); ++i) {
        auto& ring = (*rings)[i];
        if (!ring) {
            return std::unexpected(ring.error());
        }
        keep(std::move(ring->parts));
        if (ring->closed) {
            if (i == 0) {
                outermost = std::move(ring->closed->lines);
                addUncut(*ring->closed, machine, headland);
            }
            keep(std::move(ring->closed->passes));
        }
        const Length fromOutermost = all[i].different.front() - all.front().different.front();
        auto stretches =
            besideOutermost(std::move(ring->along), task, outermost, fromOutermost, static_cast<int>(i), job);
        if (!stretches) {
            return std::unexpected(stretches.error());
        }
        keep(*std::move(stretches));
    }
    return {};
}

/// The clockwise passes: counter-clockwise passes in a mirror.
Result<void> addRingsClockwise(Headland& headland, const PassTask& task, const JobContext& job) {
    const MultiPolygon workable = mirrored(task.workable);
    const AllowedAreas drivable = mirrored(task.drivable);
    const Machine machine = mirrored(task.machine);
    Headland seen = headland;
    seen.mainland = mirrored(headland.mainland);
    seen.strips = mirrored(headland.strips);
    auto added = addRings(seen,
                          {.workable = workable,
                           .drivable = drivable,
                           .machine = machine,
                           .settings = task.settings,
                           .margin = task.margin},
                          job);
    if (added) {
        headland.drivenPasses = mirrored(seen.drivenPasses);
        headland.uncutStrip = seen.uncutStrip;
        headland.uncutCorners = seen.uncutCorners;
    }
    return added;
}

}  // namespace

Length uncutEdge(const Machine& machine) {
    return 0.5 * (machine.workingFootprintWidth() - machine.operatingWidth());
}

Result<void> addPasses(Headland& headland, const HeadlandTask& task, const JobContext& job) {
    if (!task.settings.flag(kHeadlandDriven) || headland.passes == 0) {
        return {};
    }
    const bool clockwise = task.settings.choice(kHeadlandDirection) == "clockwise";
    return (clockwise ? addRingsClockwise : addRings)(headland,
                                                      {.workable = task.workable(),
                                                       .drivable = task.drivable,
                                                       .machine = task.machine,
                                                       .settings = task.settings,
                                                       .margin = task.margin},
                                                      job);
}

}  // namespace furrow
