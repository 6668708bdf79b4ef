#include "planner/io/content/plan_content.h"

#include "planner/geometry/simplify.h"
#include "planner/io/content/guidance_lines.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <cmath>
#include <format>
#include <utility>

namespace furrow {

namespace {

constexpr Length kChordError = metres(0.01);
// Stretches that are shorter are driven, but nothing can be steered along them.
constexpr Length kShortestLine = metres(1.0);

/// A and a direction as they were given, where the swaths were made from them.
std::vector<GuidanceLine> aPlusLine(const Plan& plan) {
    const Settings& settings = plan.request.settings;
    const std::vector<GeoPoint> given = settings.line(kLine);
    if (!swathMethod(settings).traits.isFromPoint || given.empty()) {
        return {};
    }
    const double bearingDeg = std::fmod(810.0 - inDegrees(*settings.angle(kAngle)), 360.0);
    return {{.kind = GuidanceKind::APlus,
             .name = std::format("A+ {:.1f}", bearingDeg),
             .points = {given.front()},
             .bearing = degrees(bearingDeg),
             .width = plan.request.machine.operatingWidth()}};
}

void addHeadlandLines(const Plan& plan, std::vector<GuidanceLine>& lines) {
    for (const PathSegment& segment : plan.path.segments) {
        if (segment.kind != SegmentKind::HeadlandPass || !segment.implementDown) {
            continue;
        }
        Polyline line;
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
        if (segment.length() < kShortestLine) {
            continue;
        }
        lines.push_back({.kind = GuidanceKind::Curve,
                         .name = std::format("Headland {}", segment.number),
                         .points = plan.field().frame().toGeo(simplified(line, kChordError)),
                         .width = plan.request.machine.operatingWidth(),
                         .repeats = false});
    }
}

}  // namespace

FieldContent contentOf(const Plan& plan, const ExportOptions& options) {
    FieldContent content{.field = plan.field().source(), .area = plan.field().area()};
    if (plan.headland.width > metres(0.0)) {
        for (const Polygon& polygon : plan.headland.mainland) {
            content.mainland.push_back(plan.field().frame().toGeo(polygon));
        }
    }
    content.lines = aPlusLine(plan);
    // A+ stands for the lines that a terminal lays beside it, not for those that are driven once.
    const bool hasAPlus = !content.lines.empty();
    for (GuidanceLine& line : guidanceLines(plan)) {
        if (!hasAPlus || !line.repeats) {
            content.lines.push_back(std::move(line));
        }
    }
    if (options.headlandLines) {
        addHeadlandLines(plan, content.lines);
    }
    return content;
}

}  // namespace furrow
