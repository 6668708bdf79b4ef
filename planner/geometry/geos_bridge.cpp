#include "planner/geometry/geos_bridge.h"

#include "planner/geometry/geos_shapes.h"
#include "planner/geometry/thin_tips.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>

namespace furrow {

using namespace geos;

namespace {

// A boundary with more vertices is thinned before it is moved inwards.
constexpr std::size_t kDenseVertices = 20'000;
constexpr double kLeastSlackM = 0.01;
constexpr double kMostSlackM = 0.05;
// A polygon of more sharp corners is moved inwards in steps, each twice as long as the one before. Offsets of
// spikes that stand closer than the distance would cross each other with the square of their number; a step
// rounds off those that are narrower than itself, and few are left to cross in the next one. Points on a bend
// do no harm.
constexpr std::size_t kManyCorners = 2'000;
const double kSharpCosine = std::cos(std::numbers::pi / 6.0);
// Of the tips of spikes that are cut off before: at this share of the distance, and width, by a millimetre
// too far.
constexpr double kThinTipM = 0.2;
constexpr double kThinTipShare = 0.05;
// Distance by which the outline after a step may be thinned, as a share of the step.
constexpr double kStepSlackShare = 0.05;
constexpr double kLeastStepSlackM = 1e-3;
// Of the tolerance for chords, in each step: they add up.
constexpr double kStepToleranceShare = 0.25;

/// The number of segments in a quarter circle with which the arc's chords stay within the tolerance.
int quarterSegments(double radiusM, double toleranceM) {
    if (radiusM <= toleranceM) {
        return 2;
    }
    const double step = 2.0 * std::acos(1.0 - toleranceM / radiusM);
    return std::clamp(static_cast<int>(std::ceil(std::numbers::pi / 2.0 / step)), 2, 64);
}

/// For polygons or lines.
template <class Shapes>
Result<MultiPolygon> buffered(const Shapes& shapes, double distanceM, double toleranceM,
                              const JobContext& job) {
    if (shapes.empty()) {
        return MultiPolygon{};
    }
    const Geometry input = toGeos(shapes);
    return run(job,
               [&] {
                   return GEOSBuffer_r(handle(), input.get(), distanceM,
                                       quarterSegments(std::abs(distanceM), toleranceM));
               })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

bool isJagged(const Polygon& polygon) {
    if (vertexCount({polygon}) <= kManyCorners) {
        return false;
    }
    std::size_t corners = 0;
    const auto count = [&](const Ring& ring) {
        Point in = ring.front() - ring.back();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point out = ring[(i + 1) % ring.size()] - ring[i];
            corners += dot(in, out) < kSharpCosine * norm(in) * norm(out) ? 1 : 0;
            in = out;
        }
    };
    count(polygon.outer);
    std::ranges::for_each(polygon.holes, count);
    return corners > kManyCorners;
}

/// A line within the slack of the boundary. It may cross itself where that is narrower.
Result<MultiPolygon> thinned(const MultiPolygon& polygons, double slackM, const JobContext& job) {
    const Geometry input = toGeos(polygons);
    return run(job, [&] { return GEOSSimplify_r(handle(), input.get(), slackM); })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

/// Without tips that no disc of the distance gets into.
MultiPolygon blunted(const MultiPolygon& polygons, double distanceM) {
    MultiPolygon blunt = polygons;
    for (Polygon& polygon : blunt) {
        if (isJagged(polygon)) {
            polygon = withoutThinTips(polygon, metres(std::min(kThinTipM, kThinTipShare * distanceM)));
        }
    }
    return blunt;
}

/// Moved inwards until few vertices are left, then all the rest of the way. What thinning may add is taken
/// off again: the result lies within that of one step.
Result<MultiPolygon> erodedInSteps(const Polygon& polygon, double distanceM, double toleranceM,
                                   const JobContext& job) {
    MultiPolygon left{polygon};
    // As far as the vertices are apart if all lie around the polygon.
    const Bounds box = bounds(left);
    double stepM = (box.width() + box.height()) / static_cast<double>(vertexCount(left));
    while (vertexCount(left) > kManyCorners && stepM < distanceM) {
        const double slackM = std::clamp(kStepSlackShare * stepM, kLeastStepSlackM, kLeastSlackM);
        auto moved = buffered(left, -stepM, kStepToleranceShare * toleranceM, job)
                         .and_then([&](const MultiPolygon& inner) { return thinned(inner, slackM, job); });
        if (!moved) {
            return moved;
        }
        left = *std::move(moved);
        distanceM -= stepM - slackM;
        stepM *= 2.0;
    }
    return buffered(left, -distanceM, toleranceM, job);
}

/// Each polygon as suits its number of vertices. They are apart, so that none matters to another.
Result<MultiPolygon> erodedEach(const MultiPolygon& polygons, double distanceM, double toleranceM,
                                const JobContext& job) {
    if (std::ranges::none_of(polygons, isJagged)) {
        return buffered(polygons, -distanceM, toleranceM, job);
    }
    MultiPolygon few;
    std::ranges::remove_copy_if(polygons, std::back_inserter(few), isJagged);
    auto all = buffered(few, -distanceM, toleranceM, job);
    for (const Polygon& polygon : polygons) {
        if (all && isJagged(polygon)) {
            auto one = erodedInSteps(polygon, distanceM, toleranceM, job);
            if (!one) {
                return one;
            }
            std::ranges::move(*one, std::back_inserter(*all));
        }
    }
    if (all) {
        std::ranges::stable_sort(*all, std::greater{}, [](const Polygon& each) { return area(each).si(); });
    }
    return all;
}

/// Polygons with the same enclosed area as these rings, even-odd.
Result<Geometry> validOf(const Geometry& shapes, const JobContext& job) {
    return run(job, [&] { return GEOSMakeValid_r(handle(), shapes.get()); });
}

using Overlay = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*);
using GridOverlay = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*, double);

/// Uses a grid if it has a size. GEOS's overlays on a grid cannot replace those without: 0 skips their
/// fallbacks against failures, -1 is a grid of a metre.
Result<MultiPolygon> combined(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                              Length grid, Overlay plain, GridOverlay snapping) {
    const auto overlaid = [&](const Geometry& first, const Geometry& second) {
        return run(job, [&] {
            return grid > metres(0.0) ? snapping(handle(), first.get(), second.get(), grid.si())
                                      : plain(handle(), first.get(), second.get());
        });
    };
    const Geometry first = toGeos(a);
    const Geometry second = toGeos(b);
    return overlaid(first, second)
        .or_else([&](const Error& error) -> Result<Geometry> {
            if (error.code == ErrorCode::Cancelled) {
                return std::unexpected(error);
            }
            // Rounding made one of them touch or cross itself.
            return validOf(first, job).and_then([&](const Geometry& one) {
                return validOf(second, job).and_then([&](const Geometry& other) {
                    return overlaid(one, other);
                });
            });
        })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

}  // namespace

Result<MultiPolygon> erodedSharp(const MultiPolygon& polygons, Length distance, const JobContext& job) {
    constexpr double kMitreLimit = 2.0;
    if (polygons.empty()) {
        return MultiPolygon{};
    }
    if (vertexCount(polygons) > kDenseVertices || std::ranges::any_of(polygons, isJagged)) {
        return eroded(polygons, distance, kArcTolerance, job);
    }
    const Geometry input = toGeos(polygons);
    return run(job,
               [&] {
                   return GEOSBufferWithStyle_r(handle(), input.get(), -distance.si(), 8, GEOSBUF_CAP_ROUND,
                                                GEOSBUF_JOIN_MITRE, kMitreLimit);
               })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

Result<MultiPolygon> eroded(const MultiPolygon& given, Length distance, Length tolerance,
                            const JobContext& job) {
    const MultiPolygon polygons = blunted(given, distance.si());
    if (vertexCount(polygons) <= kDenseVertices) {
        return erodedEach(polygons, distance.si(), tolerance.si(), job);
    }
    // If points are closer than the offset by orders of magnitude, their offsets cross each other a hundred
    // million times. A line within `slack` of the boundary, moved in by that much more, is a safe
    // replacement.
    double slackM = std::clamp(distance.si() / 200.0, kLeastSlackM, kMostSlackM);
    while (true) {
        const auto simple = thinned(polygons, slackM, job);
        if (!simple) {
            return std::unexpected(simple.error());
        }
        // Points that scatter by more than the slack stay.
        if (vertexCount(*simple) <= kDenseVertices || slackM == kMostSlackM) {
            return erodedEach(*simple, distance.si() + slackM, tolerance.si(), job);
        }
        slackM = std::min(2.0 * slackM, kMostSlackM);
    }
}

Result<MultiPolygon> dilated(const MultiPolygon& polygons, Length distance, Length tolerance,
                             const JobContext& job) {
    return buffered(polygons, distance.si(), tolerance.si(), job);
}

Result<MultiPolygon> aroundLines(const std::vector<Polyline>& lines, Length distance, Length tolerance,
                                 const JobContext& job) {
    return buffered(lines, distance.si(), tolerance.si(), job);
}

Result<MultiPolygon> difference(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                Length grid) {
    return combined(a, b, job, grid, GEOSDifference_r, GEOSDifferencePrec_r);
}

Result<MultiPolygon> intersection(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                  Length grid) {
    return combined(a, b, job, grid, GEOSIntersection_r, GEOSIntersectionPrec_r);
}

Result<MultiPolygon> unionOf(const MultiPolygon& polygons, const JobContext& job, Length grid) {
    const auto together = [&](const MultiPolygon& parts) {
        const Geometry input = toGeos(parts);
        return run(job,
                   [&] {
                       return grid > metres(0.0) ? GEOSUnaryUnionPrec_r(handle(), input.get(), grid.si())
                                                 : GEOSUnaryUnion_r(handle(), input.get());
                   })
            .transform([](const Geometry& result) { return fromGeos(result.get()); });
    };
    return together(polygons).or_else([&](const Error& error) -> Result<MultiPolygon> {
        if (error.code == ErrorCode::Cancelled) {
            return std::unexpected(error);
        }
        // One of them crosses itself. Each is repaired alone, since the area shared by two belongs to the
        // union.
        MultiPolygon sound;
        for (const Polygon& polygon : polygons) {
            const auto mended = validOf(toGeos(MultiPolygon{polygon}), job);
            if (!mended) {
                return std::unexpected(mended.error());
            }
            std::ranges::move(fromGeos(mended->get()), std::back_inserter(sound));
        }
        return together(sound);
    });
}

Result<MultiPolygon> cutAlong(const MultiPolygon& polygons, const std::vector<Polyline>& lines,
                              const JobContext& job) {
    const Geometry area = toGeos(polygons);
    const Geometry cuts = toGeos(lines);
    const auto edges = run(job, [&] { return GEOSBoundary_r(handle(), area.get()); });
    if (!edges) {
        return std::unexpected(edges.error());
    }
    const auto noded = run(job, [&] { return GEOSUnion_r(handle(), edges->get(), cuts.get()); });
    if (!noded) {
        return std::unexpected(noded.error());
    }
    const auto faces = run(job, [&] {
        const GEOSGeometry* const all[] = {noded->get()};
        return GEOSPolygonize_r(handle(), all, 1);
    });
    if (!faces) {
        return std::unexpected(faces.error());
    }
    // Faces of holes, and faces that the lines enclose outside, are not pieces.
    const GEOSPreparedGeometry* const prepared = GEOSPrepare_r(handle(), area.get());
    MultiPolygon pieces;
    for (Polygon& face : fromGeos(faces->get())) {
        const Geometry one = toGeos(face);
        const Geometry inner{GEOSPointOnSurface_r(handle(), one.get())};
        if (inner && GEOSPreparedContains_r(handle(), prepared, inner.get()) == 1) {
            pieces.push_back(std::move(face));
        }
    }
    GEOSPreparedGeom_destroy_r(handle(), prepared);
    return pieces;
}

Result<Length> breadthOf(const MultiPolygon& polygons, const JobContext& job) {
    if (polygons.empty()) {
        return Length{};
    }
    const Geometry input = toGeos(polygons);
    const double tolerance = std::max(0.01, 0.005 * std::sqrt(std::abs(area(polygons).si())));
    return run(job, [&] { return GEOSMaximumInscribedCircle_r(handle(), input.get(), tolerance); })
        .transform([](const Geometry& radius) {
            double length = 0.0;
            GEOSGeomGetLength_r(handle(), radius.get(), &length);
            return metres(2.0 * length);
        });
}

Result<std::optional<InvalidPlace>> findInvalidPlace(const MultiPolygon& polygons, const JobContext& job) {
    const Geometry input = toGeos(polygons);
    std::optional<InvalidPlace> problem;
    const Result<Geometry> checked = run(job, [&]() -> GEOSGeometry* {
        char* reason = nullptr;
        GEOSGeometry* place = nullptr;
        const char valid = GEOSisValidDetail_r(handle(), input.get(), 0, &reason, &place);
        if (valid == 0 && place != nullptr) {
            InvalidPlace found{.reason = reason, .place = {}};
            GEOSGeomGetX_r(handle(), place, &found.place.x);
            GEOSGeomGetY_r(handle(), place, &found.place.y);
            problem = found;
        }
        GEOSFree_r(handle(), reason);
        GEOSGeom_destroy_r(handle(), place);
        // Any geometry means that the check finished. None means that it was interrupted.
        return valid == 2 ? nullptr : GEOSGeom_createEmptyPoint_r(handle());
    });
    if (!checked) {
        return std::unexpected(checked.error());
    }
    return problem;
}

Result<MultiPolygon> madeValid(const MultiPolygon& polygons, const JobContext& job) {
    return validOf(toGeos(polygons), job).transform([](const Geometry& result) {
        return fromGeos(result.get());
    });
}

}  // namespace furrow
