#include "planner/audit/audit.h"

#include "planner/audit/audited_land.h"
#include "planner/audit/findings.h"
#include "planner/jobs/parallel.h"
#include "planner/jobs/shared_progress.h"

#include <algorithm>

namespace furrow {

namespace {

void addAreas(AuditReport& report, const SweptArea& swept) {
    report.covered = swept.covered;
    report.coveredShare = report.workable > squareMetres(0.0) ? swept.covered / report.workable : 0.0;
    report.coveredOfReachable = swept.coveredOfReachable;
    report.missed = swept.missedArea;
    report.leftOnPurpose = swept.leftOnPurpose;
    report.missedAreas = swept.missed;
    report.leftAreas = swept.dropped;
    report.left = swept.droppedArea;
    report.overlap = swept.overlap;
    report.overlapAreas = swept.overlapAreas;
    report.overlapHeadland = swept.overlapHeadland;
}

void addKinematics(AuditReport& report, const Kinematics& kinematics, bool isMotionStated) {
    if (isMotionStated) {
        report.maxCurvature = Curvature::fromSi(kinematics.maxCurvature1pm);
        report.maxCurvatureMismatch = Curvature::fromSi(kinematics.maxMismatch1pm);
        report.maxCurvatureRate = CurvatureRate::fromSi(kinematics.maxRate1pm2);
        report.maxHeadingJump = radians(kinematics.maxHeadingJumpRad);
    }
    report.maxPositionJump = metres(kinematics.maxPositionJumpM);
    report.reversed = metres(kinematics.reversedM);
}

void addTraffic(AuditReport& report, const Traffic& traffic) {
    report.drivenOnWorked = metres(traffic.onWorkedM);
    report.drivenOnUnworked = metres(traffic.onUnworkedM);
    report.mostWheelPasses = traffic.mostWheelPasses;
    report.oftenDriven = traffic.oftenSquares;
    report.oftenDrivenShare = traffic.oftenDriven;
    report.wheelSquare = metres(traffic.squareM);
}

}  // namespace

Result<AuditReport> audit(const AuditInput& input, const JobContext& job) {
    return auditedLand(input, job).and_then([&](const AuditedLand& land) { return audit(input, land, job); });
}

Result<AuditReport> audit(const AuditInput& input, const AuditedLand& land, const JobContext& job) {
    const MachineShape shape = shapeOf(input);
    const auto motions = followPath(input, shape, job.part(0.0, 0.1));
    if (!motions) {
        return std::unexpected(motions.error());
    }
    // Areas and clearance follow from the motions, and not from each other.
    std::optional<Result<SweptArea>> swept;
    std::optional<Result<ClearanceReport>> clearance;
    const std::size_t measures = input.machine ? 2 : 1;
    SharedProgress progress{measures, job.part(0.1, 0.9)};
    const auto measured = parallelFor(
        measures,
        [&](std::size_t i) {
            if (i == 0) {
                swept = measureSweptArea(input, land, shape, *motions, progress.piece(i));
            } else {
                clearance = measureClearance(input, *land.clearance, *motions, progress.piece(i));
            }
            progress.finish(i);
        },
        job.withoutProgress());
    if (!measured) {
        return std::unexpected(measured.error());
    }
    if (!*swept) {
        return std::unexpected(swept->error());
    }
    if (clearance && !*clearance) {
        return std::unexpected(clearance->error());
    }
    const Kinematics kinematics = measureKinematics(input);
    const auto traffic = measureTraffic(input, *motions, (*swept)->pieces, mainDirection(*motions), job);
    if (!traffic) {
        return std::unexpected(traffic.error());
    }

    AuditReport report{.workable = area(input.workable)};
    addAreas(report, **swept);
    if (clearance) {
        report.outside = (*clearance)->outside;
        report.minClearance = (*clearance)->smallest;
        report.overhangArea = (*clearance)->overhangArea;
        report.overhang = (*clearance)->overhang;
    }
    addKinematics(report, kinematics, input.statedMotion);
    if (shape.trailingM) {
        double angle = 0.0;
        for (const SegmentMotion& motion : *motions) {
            angle = std::max(angle, motion.largestHitchAngleRad);
        }
        report.maxHitchAngle = radians(angle);
    }
    addTraffic(report, *traffic);
    report.areaError = (*swept)->error;
    report.distanceError = metres(kChordErrorM) + input.positionRounding;
    report.findings = findingsOf(input, {.motions = *motions,
                                         .shape = shape,
                                         .area = **swept,
                                         .clearance = clearance ? &**clearance : nullptr,
                                         .kinematics = kinematics,
                                         .traffic = *traffic,
                                         .tank = measureTank(input)});
    job.report(1.0);
    return report;
}

}  // namespace furrow
