#include "planner/io/content/finite_numbers.h"

#include "planner/io/content/field_content.h"
#include "planner/plan/plan.h"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace furrow {

namespace {

/// Looks at numbers until one is none.
class NumberCheck {
public:
    explicit NumberCheck(std::string field) : field_{std::move(field)} {}

    void look(double number, const auto& what) {
        if (!std::isfinite(number) && !error_) {
            error_ = Error{.code = ErrorCode::InputRefused,
                           .what = message("{} is no number ({}), and nothing is written", what(), number),
                           .where = field_,
                           .remedy =
                               "this is a mistake of Furrow, please report it with the field, the "
                               "machine and the settings"};
        }
    }
    void look(const GeoRing& points, const auto& what) {
        for (const GeoPoint& point : points) {
            look(point.lonDeg, what);
            look(point.latDeg, what);
        }
    }
    void look(const GeoPolygon& polygon, const auto& what) {
        look(polygon.outer, what);
        for (const GeoRing& hole : polygon.holes) {
            look(hole, what);
        }
    }
    void look(Point point, const auto& what) {
        look(point.x, what);
        look(point.y, what);
    }

    Result<void> result() const { return error_ ? Result<void>{std::unexpected(*error_)} : Result<void>{}; }

private:
    std::string field_;
    std::optional<Error> error_;
};

auto named(std::string_view what) {
    return [what] { return Message{std::string{what}}; };
}

void lookAt(const FieldContent& content, NumberCheck& check) {
    for (const GeoPolygon& part : content.field.parts) {
        check.look(part, named("a place of the boundary"));
    }
    for (const Obstacle& obstacle : content.field.obstacles) {
        check.look(obstacle.outline, named("a place of an obstacle"));
        check.look(obstacle.buffer.si(), named("the buffer of an obstacle"));
        check.look(obstacle.overhang.si(), named("the overhang of an obstacle"));
    }
    for (const Gate& gate : content.field.gates) {
        check.look(GeoRing{gate.position}, named("the place of a gate"));
        check.look(gate.width.si(), named("the width of a gate"));
    }
    for (const GeoPolygon& part : content.mainland) {
        check.look(part, named("a place of the mainland"));
    }
    for (const GuidanceLine& line : content.lines) {
        check.look(line.points, named("a place of a guidance line"));
        check.look(line.bearing.value_or(Angle{}).si(), named("the bearing of a guidance line"));
        check.look(line.radius.value_or(Length{}).si(), named("the radius of a guidance line"));
        check.look(line.width.value_or(Length{}).si(), named("the width of a guidance line"));
    }
    check.look(content.area.value_or(Area{}).si(), named("the area of the field"));
}

void lookAt(const Plan& plan, NumberCheck& check) {
    for (const PathSegment& segment : plan.path.segments) {
        const auto of = [&](std::string_view what) {
            return [&segment, what] { return message("{} on {}", what, nameOf(segment)); };
        };
        for (const PathSample& sample : segment.samples) {
            check.look(sample.position, of("a place"));
            check.look(sample.sM, of("the way driven"));
            check.look(sample.tS, of("the time"));
            check.look(sample.headingRad, of("the heading"));
            check.look(sample.curvature1pm, of("the curvature"));
            check.look(sample.speedMps, of("the speed"));
        }
    }
    for (const Swath& swath : plan.swaths.swaths) {
        const auto place = [&] { return message("a place of swath {}", swath.number); };
        check.look(swath.start, place);
        check.look(swath.end, place);
    }
    check.look(plan.swaths.coverage, named("the coverage of the swaths"));
    check.look(plan.swaths.overlap.si(), named("the overlap of the swaths"));
    check.look(plan.headland.width.si(), named("the width of the headland"));
    check.look(plan.headland.mainlandRatio, named("the share of the mainland"));
    for (const Finding& finding : plan.findings) {
        check.look(finding.place, named("the place of a finding"));
    }
}

}  // namespace

Result<void> checkNumbers(const ExportJob& job) {
    for (const FieldContent& content : job.fields) {
        NumberCheck check{content.field.name};
        lookAt(content, check);
        if (job.plan != nullptr) {
            lookAt(*job.plan, check);
        }
        if (auto checked = check.result(); !checked) {
            return checked;
        }
    }
    return {};
}

}  // namespace furrow
