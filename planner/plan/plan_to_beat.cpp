#include "planner/plan/plan_to_beat.h"

#include "planner/path/blocking.h"

#include <algorithm>

namespace furrow {

namespace {

constexpr double kNear = 1.01;
constexpr std::ptrdiff_t kMostBlocked = 25;
// Corners that are worked before need far fewer passes for as much land.
constexpr double kSurely = 0.25;
// With the same corners in another order, or along another heading, they rarely cost less.
constexpr double kSurelyIfAlike = 0.8;

}  // namespace

Duration timeForAll(const Machine& machine, const Path& path, const AuditReport& audit) {
    const double missedM = audit.missed.value_or(Area{}).si() / machine.operatingWidth().si();
    return path.duration() + seconds(missedM / machine.spec().tractor.workingSpeed.si());
}

FinishingCost finishingCost(const Driven& driven) {
    return {.added = driven.finishingCost, .left = driven.leftBeforeFinishing};
}

PlanToBeat planToBeat(const Machine& machine, const Driven& driven) {
    return {.blocking = blockingCount(driven.findings),
            .time = timeForAll(machine, driven.path, driven.audit),
            .finishing = finishingCost(driven),
            .meanwhile = nullptr};
}

Error noBetter(const Field& field) {
    return {.code = ErrorCode::InputRefused, .what = {}, .where = field.name()};
}

bool isLasting(const Finding& finding) {
    return isBlocking(finding) && finding.kind != FindingKind::Missed;
}

std::ptrdiff_t lastingCount(std::span<const Finding> findings) {
    return std::ranges::count_if(findings, isLasting);
}

bool isBeyondMending(std::span<const Finding> findings) {
    return lastingCount(findings) > kMostBlocked;
}

std::pair<std::ptrdiff_t, std::ptrdiff_t> problems(std::span<const Finding> findings) {
    return {blockingCount(findings), lastingCount(findings)};
}

bool mayBeat(const PlanToBeat& other, const Machine& machine, const Driven& driven) {
    const std::ptrdiff_t lasting = lastingCount(driven.findings);
    return lasting < other.blocking ||
           (lasting == other.blocking && timeForAll(machine, driven.path, driven.audit) <= other.time);
}

bool mayBeatFinished(const PlanToBeat& other, const Machine& machine, const Driven& unfinished) {
    const FinishingCost& known = other.finishing;
    const double share = known.left > Area{} ? unfinished.audit.left / known.left : 0.0;
    const Duration least = (other.finishesAlike ? kSurelyIfAlike : kSurely) * share * known.added;
    return lastingCount(unfinished.findings) < other.blocking ||
           timeForAll(machine, unfinished.path, unfinished.audit) + least <= kNear * other.time;
}

}  // namespace furrow
