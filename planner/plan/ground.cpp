#include "planner/plan/ground.h"

#include "planner/field/drivable_area.h"
#include "planner/field/overhung_land.h"
#include "planner/geometry/convex_hull.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/plan/general_parameters.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

/// How long the machine is where it is as wide as its tractor. A trailed implement may stand at an angle.
Length rigidLength(const Machine& machine) {
    if (machine.spec().implement.mounting == Mounting::Trailed) {
        return machine.spec().tractor.length;
    }
    const Ring outline = machine.turningFootprint();
    const auto [rear, front] = std::ranges::minmax(outline, {}, &Point::x);
    return metres(front.x - rear.x);
}

/// Whether some straight line of this length may be in it: for convex parts that is so, for others perhaps.
bool mayHoldLine(const MultiPolygon& polygons, Length length) {
    return std::ranges::any_of(polygons, [length](const Polygon& polygon) {
        const Bounds box = bounds(polygon);
        // Of large ones the box says enough.
        return std::max(box.width(), box.height()) >= length.si() ||
               diameter(convexHull(polygon.outer)) >= length;
    });
}

/// No machine fits where not even what is within its outline does: the middle of it, as wide as the tractor,
/// with round ends. It stands where its middle line stays clear of the edge by half its width.
Result<void> checkThatItFits(const Field& field, const Machine& machine, Length margin,
                             const JobContext& job) {
    const Length width = machine.spec().tractor.width;
    const Length length = rigidLength(machine);
    const auto room = eroded(field.drivable(), 0.5 * std::min(width, length) + margin, metres(0.05), job);
    if (!room) {
        return std::unexpected(room.error());
    }
    const Message withMargin =
        margin > metres(0.0) ? message(" and twice {:.2f} m of margin", margin.si()) : Message{};
    Message what;
    if (room->empty()) {
        what = message("the field is nowhere as wide as the machine ({:.2f} m{})",
                       std::min(width, length).si(), withMargin);
    } else if (!mayHoldLine(*room, std::max(width, length) - std::min(width, length))) {
        what = message("the machine ({:.2f} m wide, {:.2f} m long{}) fits nowhere into the field", width.si(),
                       length.si(), withMargin);
    } else {
        return {};
    }
    return std::unexpected(
        Error{.code = ErrorCode::InputRefused,
              .what = std::move(what),
              .where = field.source().origin.empty() ? field.name() : field.source().origin,
              .remedy = margin > Length{}
                            ? message("choose a smaller machine or a smaller margin ({})", kMargin.key)
                            : Message{"choose a smaller machine or check the boundary's coordinate system"},
              .place = middleOf(field.source().parts)});
}

}  // namespace

Result<Ground> groundOf(const PlanRequest& request, const JobContext& job) {
    const Field& field = *request.field;
    const Length margin = request.settings.length(kMargin).value_or(field.source().boundaryAccuracy);
    if (auto fits = checkThatItFits(field, request.machine, margin, job); !fits) {
        return std::unexpected(fits.error());
    }
    auto overhung = overhungLand(field, request.settings.length(kOverhang).value_or(Length{}), job);
    if (!overhung) {
        return std::unexpected(overhung.error());
    }
    return allowedAreas(field, *overhung, margin, job).transform([&](AllowedAreas&& drivable) {
        return Ground{margin, std::move(drivable), *std::move(overhung)};
    });
}

}  // namespace furrow
