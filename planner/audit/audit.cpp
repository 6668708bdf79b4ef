#include "planner/audit/audit.h"

#include "planner/audit/findings.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

bool isInside(const Polygon& polygon, Point point) {
    bool inside = false;
    forEachEdge({polygon}, [&](Point a, Point b) {
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    });
    return inside;
}

/// Way of the reference point, implement up, over what earlier segments have worked.
Length wayOnWorked(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                   const std::vector<MultiPolygon>& passes) {
    struct Worked {
        const Polygon* polygon;
        Bounds box;
    };
    std::vector<Worked> worked;
    double way = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (input.segments[i].implementDown) {
            for (const Polygon& polygon : passes[i]) {
                worked.push_back({&polygon, bounds({polygon})});
            }
            continue;
        }
        const auto& states = motions[i].states;
        for (std::size_t k = 1; k < states.size(); ++k) {
            const Point middle = 0.5 * (states[k - 1].position + states[k].position);
            if (std::ranges::any_of(worked, [&](const Worked& each) {
                    return middle.x > each.box.min.x && middle.x < each.box.max.x &&
                           middle.y > each.box.min.y && middle.y < each.box.max.y &&
                           isInside(*each.polygon, middle);
                })) {
                way += distance(states[k - 1].position, states[k].position);
            }
        }
    }
    return metres(way);
}

}  // namespace

Result<AuditReport> audit(const AuditInput& input, const JobContext& job) {
    const MachineShape shape = shapeOf(input);
    const auto motions = followPath(input, shape, job.part(0.0, 0.1));
    if (!motions) {
        return std::unexpected(motions.error());
    }
    const auto swept = measureSweptArea(input, shape, *motions, job.part(0.1, 0.6));
    if (!swept) {
        return std::unexpected(swept.error());
    }
    std::optional<ClearanceReport> clearance;
    if (input.machine) {
        auto measured = measureClearance(input, *motions, job.part(0.6, 0.9));
        if (!measured) {
            return std::unexpected(measured.error());
        }
        clearance = std::move(*measured);
    }
    const Kinematics kinematics = measureKinematics(input);
    auto findings = findingsOf(input,
                               {.motions = *motions,
                                .shape = shape,
                                .area = *swept,
                                .clearance = clearance ? &*clearance : nullptr,
                                .kinematics = kinematics},
                               job);
    if (!findings) {
        return std::unexpected(findings.error());
    }

    AuditReport report{.workable = area(input.workable)};
    report.covered = swept->covered;
    report.coveredShare =
        report.workable > squareMetres(0.0) ? swept->covered / report.workable : 0.0;
    report.coveredOfReachable = swept->coveredOfReachable;
    report.missed = swept->missedArea;
    report.missedAreas = swept->missed;
    report.overlap = swept->overlap;
    report.overlapHeadland = swept->overlapHeadland;
    if (clearance) {
        report.outside = clearance->outside;
        report.minClearance = clearance->smallest;
    }
    if (input.statedMotion) {
        report.maxCurvature = Curvature::fromSi(kinematics.maxCurvature1pm);
        report.maxCurvatureMismatch = Curvature::fromSi(kinematics.maxMismatch1pm);
        report.maxCurvatureRate = CurvatureRate::fromSi(kinematics.maxRate1pm2);
        report.maxHeadingJump = radians(kinematics.maxHeadingJumpRad);
    }
    report.maxPositionJump = metres(kinematics.maxPositionJumpM);
    report.reversed = metres(kinematics.reversedM);
    if (shape.trailingM) {
        double angle = 0.0;
        for (const SegmentMotion& motion : *motions) {
            angle = std::max(angle, motion.largestHitchAngleRad);
        }
        report.maxHitchAngle = radians(angle);
    }
    report.drivenOnWorked = wayOnWorked(input, *motions, swept->passes);
    report.areaError = swept->error;
    report.distanceError = metres(kChordErrorM) + input.positionRounding;
    report.findings = std::move(*findings);
    job.report(1.0);
    return report;
}

}  // namespace furrow
