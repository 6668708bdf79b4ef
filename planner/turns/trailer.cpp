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
// The sine of a smaller angle is the angle to the last bit.
constexpr double kFlat = 1e-9;

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

// The hitch moves on a circle. Let d be the angle from the implement to the hitch's way, k the curvature of
// that way, L the trailed length and s the way. Then d' = k - sin(d) / L, a Riccati equation in tan(d / 2).
// With tan(d / 2) = u / v it is linear, u' = (k v - u / L) / 2 and v' = (v / L - k u) / 2, and the square of
// its matrix is (1 / L^2 - k^2) / 4 times one.
Angle Trailer::headingAfter(Angle heading, Angle from, Curvature curvature, Length way) const {
    const double bend = curvature.si() * hitchM;
    const double stretch = std::sqrt(1.0 + bend * bend);  // way of the hitch for each metre of the tractor's
    const double hitchWay = from.si() + std::atan(bend);
    const double k = curvature.si() / stretch;
    const double s = way.si() * stretch;
    const double half = 0.5 * (hitchWay - heading.si());
    const double u = std::sin(half);
    const double v = std::cos(half);
    const double square = 0.25 * (1.0 / (trailingM * trailingM) - k * k);
    const double rate = std::sqrt(std::abs(square));
    const double turned = rate * std::abs(s);
    double same = 1.0;
    double other = 0.5 * s;
    if (square > 0.0 && turned > kFlat) {
        // Hyperbolic sine and cosine, both by their common factor smaller: only u / v matters.
        const double fallen = std::exp(-2.0 * turned);
        same = 0.5 * (1.0 + fallen);
        other = std::copysign(0.25 * (1.0 - fallen) / rate, s);
    } else if (square < 0.0 && turned > kFlat) {
        same = std::cos(turned);
        other = std::copysign(0.5 * std::sin(turned) / rate, s);
    }
    const double after = 2.0 * std::atan2(same * u + other * (k * v - u / trailingM),
                                          same * v + other * (v / trailingM - k * u));
    return radians(hitchWay + curvature.si() * way.si() - after);
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
