#include "planner/geometry/simplify.h"
#include "planner/io/export_job.h"
#include "planner/io/file_error.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <numbers>

namespace furrow {

namespace {

// Lines whose directions differ by less than this (1 cm over 100 m) are one direction to a terminal.
constexpr double kSameDirectionRad = 1e-4;

constexpr Length kChordError = metres(0.01);

double directionRad(const Swath& swath) {
    const Point along = swath.end - swath.start;
    return normalisedSwathHeading(radians(std::atan2(along.y, along.x))).si();
}

/// For each direction the longest swath of its first track, in the order in which directions first come.
std::vector<const Swath*> guidanceSwaths(const SwathSet& set) {
    std::vector<const Swath*> chosen;
    for (const Swath& swath : set.swaths) {
        const double direction = directionRad(swath);
        const auto same = std::ranges::find_if(chosen, [direction](const Swath* other) {
            return std::abs(std::remainder(directionRad(*other) - direction, std::numbers::pi)) <
                   kSameDirectionRad;
        });
        if (same == chosen.end()) {
            chosen.push_back(&swath);
        } else if (swath.track == (*same)->track && swath.length() > (*same)->length()) {
            *same = &swath;
        }
    }
    return chosen;
}

GuidanceLine abLine(const Swath& swath, const Plan& plan) {
    const Point along = swath.end - swath.start;
    const double eastDeg = inDegrees(radians(std::atan2(along.y, along.x)));
    // From A to B, so in the full circle; what is rounded up to 360 is north again.
    const double bearingDeg = std::fmod(std::round((450.0 - eastDeg) * 1e4) / 1e4, 360.0);
    const LocalFrame& frame = plan.field().frame();
    return {.kind = GuidanceKind::AbLine,
            .name = std::format("AB {:.1f}", bearingDeg),
            .points = {frame.toGeo(swath.start), frame.toGeo(swath.end)},
            .bearing = degrees(bearingDeg),
            .width = plan.request.machine.operatingWidth()};
}

/// A and a direction as they were given, where the swaths were made from them.
std::vector<GuidanceLine> aPlusLine(const Plan& plan) {
    const Settings& settings = plan.request.settings;
    const std::vector<GeoPoint> given = settings.line(kLine);
    if (swathMethod(settings) != kAPlusMethod.run || given.empty()) {
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
    if (content.lines.empty()) {
        for (const Swath* swath : guidanceSwaths(plan.swaths)) {
            content.lines.push_back(abLine(*swath, plan));
        }
    }
    if (options.headlandLines) {
        addHeadlandLines(plan, content.lines);
    }
    return content;
}

Error needsPlan(std::string_view format) {
    return inputRefused(std::string{format}, "this format holds the path of a plan, and there is only a field",
                        "plan the field first: furrow-cli plan FIELD --out plan");
}

}  // namespace furrow
