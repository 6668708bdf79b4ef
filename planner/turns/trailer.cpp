#include "planner/turns/trailer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

// Steps of a hitch, as a share of the trailed length. The track is then within a millimetre.
constexpr double kTrailingStep = 0.05;
// An implement this close behind its hitch swings with it.
constexpr double kLeastTrailingM = 0.1;

Ring outlineOf(const Implement& implement, Length width) {
    const double middle = (implement.offset - implement.hitchOffset).si();
    const double halfLength = 0.5 * implement.length.si();
    const double half = 0.5 * width.si();
    const double aside = implement.lateralOffset.si();
    return {{middle - halfLength, aside - half},
            {middle + halfLength, aside - half},
            {middle + halfLength, aside + half},
            {middle - halfLength, aside + half}};
}

}  // namespace

std::optional<Trailer> Trailer::of(const Machine& machine) {
    const Implement& implement = machine.spec().implement;
    const double trailingM = (implement.hitchOffset - implement.offset).si();
    if (implement.mounting != Mounting::Trailed || trailingM <= kLeastTrailingM) {
        return std::nullopt;
    }
    const Length raised = implement.raisedWidth.value_or(implement.operatingWidth);
    return Trailer{
        .hitchM = implement.hitchOffset.si(),
        .trailingM = trailingM,
        .raised = outlineOf(implement, raised),
        .lowered = outlineOf(implement, implement.operatingWidth),
        .wheels =
            outlineOf(implement, std::min({machine.spec().tractor.width, implement.operatingWidth, raised}))};
}

Pose Trailer::poseOf(const Pose& tractor, Angle heading) const {
    return {.position = tractor.position + hitchM * direction(tractor.heading.si()), .heading = heading};
}

Angle Trailer::headingAfter(Angle heading, const Pose& from, const Pose& to) const {
    const Point way = poseOf(to, heading).position - poseOf(from, heading).position;
    const double movedM = norm(way);
    if (movedM == 0.0) {
        return heading;
    }
    // tan of half the angle between implement and way falls with exp(-way / length): the tractrix.
    const double towardsRad = std::atan2(way.y, way.x);
    const double angle = std::remainder(heading.si() - towardsRad, 2.0 * std::numbers::pi);
    return radians(towardsRad + 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(-movedM / trailingM)));
}

Length Trailer::longestStep() const {
    return metres(kTrailingStep * trailingM);
}

Ring tractorOutline(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const double front = (tractor.length - tractor.rearOverhang).si();
    const double rear = -tractor.rearOverhang.si();
    const double half = 0.5 * tractor.width.si();
    return {{rear, -half}, {front, -half}, {front, half}, {rear, half}};
}

}  // namespace furrow
