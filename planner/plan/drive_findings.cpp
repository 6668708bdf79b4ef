#include "planner/plan/drive_findings.h"

#include "planner/path/driven_parts.h"
#include "planner/path/folded_stretches.h"
#include "planner/plan/method_registry.h"

#include <algorithm>
#include <optional>

namespace furrow {

namespace {

// Where no way was found through a neck with no more room beside the machine, it is the neck that is in the
// way.
constexpr Length kNeckSpare = metres(0.5);

/// "The way from swath 3 to swath 4", "Headland pass 1".
Message nameOfWay(const Path& path, std::size_t segment) {
    if (path.segments[segment].implementDown) {
        return nameOf(path.segments[segment]).capitalised();
    }
    const PathSegment* const before = path.workBefore(segment);
    const PathSegment* const after = path.workAfter(segment);
    return message("The way from {} to {}", before == nullptr ? Message{"the start"} : nameOf(*before),
                   after == nullptr ? Message{"the end"} : nameOf(*after));
}

/// Whether a way leaves one part of the field for another.
bool leadsBetweenParts(const DrivenParts& parts, const Path& path, std::size_t segment) {
    const PathSegment* const before = path.workBefore(segment);
    const PathSegment* const after = path.workAfter(segment);
    return !path.segments[segment].implementDown && before != nullptr && after != nullptr &&
           parts.separate(before->samples.back().position, after->samples.front().position);
}

Finding blockedFinding(const Path& path, const BlockedConnection& blocked, const DrivenParts& parts) {
    const Message way = nameOfWay(path, blocked.segment);
    if (leadsBetweenParts(parts, path, blocked.segment)) {
        return {.severity = Severity::Blocking,
                .kind = blocked.obstacle ? FindingKind::Obstacle : FindingKind::Outside,
                .place = blocked.place,
                .text = message(
                    "{} leads from one part of the field to another that this machine cannot drive to.", way),
                .suggestion = "Plan the parts of the field apart, or widen the passage between them."};
    }
    if (blocked.obstacle) {
        return {.severity = Severity::Blocking,
                .kind = FindingKind::Obstacle,
                .place = blocked.place,
                .text = message("{} crosses an obstacle.", way),
                .suggestion = "Plan the sides of the obstacle apart."};
    }
    return {.severity = Severity::Blocking,
            .kind = FindingKind::Outside,
            .place = blocked.place,
            .text = message("{} leaves the field by {:.2f} m.", way, blocked.outside.si())};
}

Message blockedReason(const BlockedConnection& blocked) {
    return blocked.obstacle ? Message{"crosses an obstacle"}
                            : message("leaves the field by {:.2f} m", blocked.outside.si());
}

}  // namespace

Result<std::vector<Finding>> checkWays(Path& path, WayChecks& checks, const AllowedAreas& drivable,
                                       const Machine& machine, const JobContext& job) {
    std::vector<Finding> findings;
    const auto blocked = checks.blocked(path, job);
    if (!blocked) {
        return std::unexpected(blocked.error());
    }
    if (blocked->empty()) {
        return findings;
    }
    const auto parts = DrivenParts::of(drivable, machine, kNeckSpare, job);
    if (!parts) {
        return std::unexpected(parts.error());
    }
    std::optional<BlockedConnection> worst;
    for (const BlockedConnection& connection : *blocked) {
        PathSegment& segment = path.segments[connection.segment];
        segment.drivable = false;
        segment.reason = blockedReason(connection);
        const bool sameWay = worst && !segment.implementDown &&
                             path.workBefore(worst->segment) == path.workBefore(connection.segment);
        if (sameWay && connection.outside <= worst->outside) {
            continue;
        }
        if (sameWay) {
            findings.pop_back();
        }
        worst = connection;
        findings.push_back(blockedFinding(path, connection, *parts));
    }
    return findings;
}

std::vector<Finding> foldedWays(const Path& path) {
    std::vector<Finding> findings;
    for (const FoldedStretch& stretch : foldedStretches(path.segments)) {
        const PathSegment* const before = path.workBefore(stretch.first);
        const PathSegment* const after = path.workAfter(stretch.last);
        findings.push_back({.severity = Severity::Note,
                            .kind = FindingKind::Folded,
                            .place = path.segments[stretch.first].samples.front().position,
                            .text = message("The implement is folded on the way from {} to {}.",
                                            before == nullptr ? Message{"the start"} : nameOf(*before),
                                            after == nullptr ? Message{"the end"} : nameOf(*after))});
    }
    return findings;
}

std::optional<Finding> impossibleTurns(const PlanRequest& request, const Path& path) {
    const bool turnsOnTheSpot = turnMethod(request.settings).traits.isStanding;
    if (!turnsOnTheSpot || request.machine.spec().tractor.canTurnInPlace || path.turnCount() == 0) {
        return std::nullopt;
    }
    return Finding{
        .severity = Severity::Blocking,
        .kind = FindingKind::HeadingJump,
        .place =
            std::ranges::find(path.segments, SegmentKind::Turn, &PathSegment::kind)->samples.front().position,
        .text = "Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.",
        .suggestion = "Take a machine that can."};
}

std::vector<Finding> newFindings(const AuditReport& audit, const std::vector<Finding>& told,
                                 const Path& path) {
    const auto isTold = [&](const AuditFinding& found) {
        const FindingKind kind = found.finding.kind;
        if (found.segment && !path.segments[*found.segment].drivable &&
            (kind == FindingKind::Outside || kind == FindingKind::Obstacle ||
             kind == FindingKind::Undrivable)) {
            return true;
        }
        return kind == FindingKind::HeadingJump && std::ranges::contains(told, kind, &Finding::kind);
    };
    std::vector<Finding> added;
    for (const AuditFinding& found : audit.findings) {
        if (!isTold(found)) {
            added.push_back(found.finding);
        }
    }
    return added;
}

}  // namespace furrow
