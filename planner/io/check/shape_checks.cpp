#include "planner/io/check/shape_checks.h"

#include "planner/core/place_message.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/io/content/geo_ring.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace furrow {

namespace {

constexpr double kStatedAreaShare = 0.005;
// Rounding to whole square metres, and to tenths of an are, counts on small areas.
constexpr double kAreaSlackM2 = 6.0;
constexpr double kFarM = 10'000.0;

GeoRing opened(const GeoRing& ring) {
    GeoRing open = ring;
    if (open.size() > 1 && open.front() == open.back()) {
        open.pop_back();
    }
    return open;
}

GeoPolygon opened(const GeoPolygon& rings) {
    GeoPolygon open{.outer = opened(rings.outer), .holes = {}};
    for (const GeoRing& hole : rings.holes) {
        open.holes.push_back(opened(hole));
    }
    return open;
}

/// Across the antimeridian programs that know no globe see it the other way round.
bool spansGlobe(const GeoRing& ring) {
    const auto [west, east] = std::ranges::minmax(ring, {}, &GeoPoint::lonDeg);
    return east.lonDeg - west.lonDeg > 180.0;
}

}  // namespace

void coordinatesOnEarth(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        std::optional<GeoPoint> wrong;
        forEachPlace(content, [&](GeoPoint point) {
            run.applied = true;
            if (!wrong && !isOnEarth(point)) {
                wrong = point;
            }
        });
        if (wrong) {
            run.report(content.file,
                       message("{}, {} is no longitude and latitude", wrong->lonDeg, wrong->latDeg));
        }
    }
}

/// Far from the bounding boxes of all fields that were meant.
void nearTheFields(CheckRun& run) {
    constexpr double kDegreeM = 111'000.0;
    const auto isNear = [&run](GeoPoint point) {
        return std::ranges::any_of(run.job.fields, [point](const FieldContent& content) {
            return std::ranges::any_of(content.field.parts, [point](const GeoPolygon& part) {
                const GeoPoint first = part.outer.front();
                double eastM = 0.0;
                double northM = 0.0;
                for (const GeoPoint& corner : part.outer) {
                    eastM = std::max(
                        eastM, kDegreeM * std::abs(lonNear(corner.lonDeg, first.lonDeg) - first.lonDeg));
                    northM = std::max(northM, kDegreeM * std::abs(corner.latDeg - first.latDeg));
                }
                return roughDistanceM(point, first) < kFarM + eastM + northM;
            });
        });
    };
    for (const ReceivedContent& content : run.contents) {
        std::optional<GeoPoint> far;
        std::optional<GeoPoint> lastGood;
        forEachPlace(content, [&](GeoPoint point) {
            run.applied = true;
            // Next to one that is near is near enough.
            if (far || !isOnEarth(point) || (lastGood && roughDistanceM(point, *lastGood) < kFarM / 2.0)) {
                return;
            }
            if (isNear(point)) {
                lastGood = point;
            } else {
                far = point;
            }
        });
        if (far) {
            run.report(content.file, message("{} is far from the field", placeMessage(*far)));
        }
    }
}

void ringsClosed(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        const ReceivedArea* wrong = nullptr;
        const ReceivedArea* small = nullptr;
        for (const ReceivedArea& area : content.areas) {
            forEachRing(area, [&](const GeoRing& ring, bool) {
                run.applied = true;
                const bool repeats = ring.size() > 1 && ring.front() == ring.back();
                wrong = wrong == nullptr && repeats != content.repeatsFirst ? &area : wrong;
                small = small == nullptr && opened(ring).size() < 3 ? &area : small;
            });
        }
        if (small != nullptr) {
            run.report(content.file, message("a ring of '{}' has fewer than three corners", small->name));
        } else if (wrong != nullptr) {
            run.report(content.file,
                       content.repeatsFirst
                           ? message("a ring of '{}' does not end where it begins", wrong->name)
                           : message("a ring of '{}' ends with its first point again", wrong->name));
        }
    }
}

void ringsSimple(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedArea& area : content.areas) {
            const GeoPolygon rings = opened(area.rings);
            bool usable = rings.outer.size() >= 3;
            forEachRing({.rings = rings}, [&usable](const GeoRing& ring, bool) {
                usable = usable && ring.size() >= 3 && std::ranges::all_of(ring, isOnEarth);
            });
            const auto frame = usable ? LocalFrame::centredOn(rings.outer.front()) : std::unexpected(Error{});
            if (!frame) {
                continue;  // the other checks say why
            }
            run.applied = true;
            const auto invalid = findInvalidPlace({frame->toLocal(rings)}, {});
            if (!invalid || *invalid) {
                run.report(content.file,
                           message("'{}' crosses itself, or a hole lies outside of it", area.name));
                break;
            }
        }
    }
}

void ringsWound(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        if (content.winding == ReceivedContent::Winding::Any) {
            continue;
        }
        const bool outerLeft = content.winding == ReceivedContent::Winding::OuterLeft;
        const ReceivedArea* wrong = nullptr;
        for (const ReceivedArea& area : content.areas) {
            forEachRing(area, [&](const GeoRing& ring, bool outer) {
                run.applied = true;
                const bool left = isCounterClockwise(opened(ring));
                const bool judged = wrong == nullptr && ring.size() >= 3 && !spansGlobe(ring);
                wrong = judged && left != (outer == outerLeft) ? &area : wrong;
            });
        }
        if (wrong != nullptr) {
            run.report(content.file, message("a ring of '{}' runs the wrong way round", wrong->name));
        }
    }
}

void areasAsStated(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedArea& area : content.areas) {
            const GeoPolygon rings = opened(area.rings);
            if (!area.statedM2 || rings.outer.size() < 3) {
                continue;
            }
            run.applied = true;
            const double most = geodesicArea({.outer = rings.outer, .holes = {}}).si();
            const double own = geodesicArea(rings).si();
            // A field's area is stated with obstacles taken out, which are areas of their own.
            const double least = area.kind == ReceivedArea::Kind::Field ? std::min(own, 0.2 * most) : own;
            if (*area.statedM2 > own + kStatedAreaShare * most + kAreaSlackM2 ||
                *area.statedM2 < least - kStatedAreaShare * most - kAreaSlackM2) {
                run.report(content.file, message("'{}' is said to have {:.0f} m², and has {:.0f} m²",
                                                 area.name, *area.statedM2, own));
                break;
            }
        }
    }
}

}  // namespace furrow
