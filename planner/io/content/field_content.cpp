#include "planner/io/content/field_content.h"

#include "planner/geodesy/local_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

constexpr double kChordErrorM = 0.01;

/// A circle, or the arc from the start to the end around the centre, in the way it turns.
GeoRing arcOf(const GuidanceLine& line, const LocalFrame& frame) {
    const Ring local = frame.toLocal(line.points);
    const bool isArc = local.size() >= 3;
    const double radiusM = line.radius ? line.radius->si() : isArc ? distance(local[0], local[1]) : 0.0;
    if (!(radiusM > 0.0) || !std::isfinite(radiusM)) {
        return {};
    }
    const auto angleTo = [&local](std::size_t i) {
        return std::atan2(local[i].y - local[0].y, local[i].x - local[0].x);
    };
    const double from = isArc ? angleTo(1) : 0.0;
    double sweep = 2.0 * std::numbers::pi;
    if (isArc) {
        sweep = std::fmod(angleTo(2) - from + 4.0 * std::numbers::pi, 2.0 * std::numbers::pi);
        sweep = line.clockwise ? sweep - 2.0 * std::numbers::pi : sweep;
    }
    // The sagitta of a chord over an angle a is r (1 - cos a/2).
    const double step = 2.0 * std::acos(std::max(0.0, 1.0 - kChordErrorM / radiusM));
    const auto chords = std::clamp(std::ceil(std::abs(sweep) / step), 8.0, 20'000.0);
    Ring points;
    for (double i = 0.0; i <= chords; ++i) {
        const double angle = from + sweep * i / chords;
        points.push_back({local[0].x + radiusM * std::cos(angle), local[0].y + radiusM * std::sin(angle)});
    }
    return frame.toGeo(points);
}

}  // namespace

std::string_view guidanceKindId(GuidanceKind kind) {
    switch (kind) {
        case GuidanceKind::AbLine: return "ab-line";
        case GuidanceKind::APlus: return "a-plus";
        case GuidanceKind::Curve: return "curve";
        case GuidanceKind::Pivot: return "pivot";
    }
    return "";
}

Area FieldContent::statedArea() const {
    Area sum;
    for (const GeoPolygon& part : field.parts) {
        sum += geodesicArea(part);
    }
    return area.value_or(sum);
}

GeoRing drawn(const GuidanceLine& line, Length reach) {
    if (line.kind == GuidanceKind::AbLine || line.kind == GuidanceKind::Curve || line.points.empty()) {
        return line.points;
    }
    const auto frame = LocalFrame::centredOn(line.points.front());
    if (!frame) {
        return {};
    }
    if (line.kind == GuidanceKind::Pivot) {
        return arcOf(line, *frame);
    }
    const double bearing = line.bearing.value_or(Angle{}).si();
    const Point a = frame->toLocal(line.points.front());
    const Point b{a.x + reach.si() * std::sin(bearing), a.y + reach.si() * std::cos(bearing)};
    return {line.points.front(), frame->toGeo(b)};
}

}  // namespace furrow
