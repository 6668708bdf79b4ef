#include "planner/plan/plan.h"

#include "planner/field/outline_steps.h"
#include "planner/jobs/shared_progress.h"
#include "planner/path/blocking.h"
#include "planner/plan/audit_input.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/order_stage.h"
#include "planner/plan/plan_course.h"
#include "planner/plan/quicker_choice.h"
#include "planner/plan/reasons.h"
#include "planner/plan/stopwatch.h"

#include <algorithm>

namespace furrow {

namespace {

// Of the progress: the rest is the proof.
constexpr double kChosen = 0.95;

/// The notes of all stages, as findings behind what was found.
void addNotes(Plan& plan) {
    const Field& field = plan.field();
    const Point middle = field.frame().toLocal(middleOf(field.source().parts));
    const auto add = [&](const std::vector<Note>& notes, FindingKind kind) {
        for (const Note& note : notes) {
            plan.findings.push_back(
                {.severity = Severity::Note,
                 .kind = kind,
                 .place = note.place ? field.frame().toLocal(*note.place) : middle,
                 .text = message("{}.", note.text.capitalised()),
                 .suggestion = "",
                 .setting = kind == FindingKind::Setting ? note.where.text() : std::string{}});
        }
    };
    add(plan.notes, FindingKind::Instead);
    add(plan.headland.notes, FindingKind::Setting);
    add(plan.swaths.notes, FindingKind::Setting);
    if (const auto steps = stepsOf(field.source())) {
        plan.findings.push_back(
            {.severity = Severity::Note,
             .kind = FindingKind::Repair,
             .place = middle,
             .text = message("The outline has {} steps of about {:.1f} m, like the pixels of an image.",
                             steps->count, steps->height.si()),
             .suggestion = "Make them straight: \"Field\" menu, or furrow-cli convert --straighten-steps."});
    }
    for (const Note& repair : field.repairs()) {
        plan.findings.push_back({.severity = Severity::Note,
                                 .kind = FindingKind::Repair,
                                 .place = repair.place ? field.frame().toLocal(*repair.place) : middle,
                                 .text = message("Repaired in {}: {}.", repair.where, repair.text),
                                 .suggestion = ""});
    }
    std::ranges::stable_sort(plan.findings, {}, weightOf);
}

/// The plan of all stages, put together.
std::shared_ptr<Plan> planOf(const PlanRequest& request, const PlannedStages& stages) {
    const LaidSwaths& laid = *stages.laidOut.laid;
    auto plan = std::make_shared<Plan>(Plan{.request = request,
                                            .margin = stages.ground->margin,
                                            .overhung = stages.ground->overhung,
                                            .headland = *stages.laidOut.headland,
                                            .leftOnPurpose = stages.driven->leftOnPurpose,
                                            .swaths = laid.swaths,
                                            .cells = stages.ordered->cells,
                                            .route = stages.ordered->route,
                                            .proof = {},
                                            .path = stages.driven->path,
                                            .refill = stages.driven->refill,
                                            .audit = stages.driven->audit,
                                            .findings = stages.driven->findings,
                                            .instead = {},
                                            .notes = {},
                                            .choices = {},
                                            .timings = {}});
    Headland& headland = plan->headland;
    std::ranges::copy(stages.driven->finishing, std::back_inserter(headland.drivenPasses));
    if (!laid.swaths.goneRound.empty()) {
        headland.mainland = laid.mainland;
        headland.mainlandRatio = area(laid.mainland) / area(request.field->workable());
    }
    return plan;
}

std::shared_ptr<Plan> planOf(const PlanRequest& request, const BestSoFar& choice) {
    std::shared_ptr<Plan> plan = planOf(request, choice.plan);
    plan->instead = choice.instead;
    plan->notes = choice.notes;
    plan->swaths.candidates = choice.headings;
    return plan;
}

/// The plan as asked, told as soon as it is there.
ChoosingCourse choosingCourse(const PlanRequest& request, const StageRunner& runner, const Stopwatch& watch,
                              const PlanCourse& course) {
    ChoosingCourse told{.asked = {}, .compared = course.compared};
    if (course.firstPlan) {
        told.asked = [&](const PlannedStages& stages) {
            const std::shared_ptr<Plan> plan = planOf(request, stages);
            addReasons(*plan);
            addNotes(*plan);
            plan->timings = runner.timings();
            plan->timings.total = Stopwatch{watch}.lap();
            plan->request.draft = true;
            course.firstPlan(plan);
        };
    }
    return told;
}

}  // namespace

std::ptrdiff_t Plan::blockingCount() const {
    return furrow::blockingCount(findings);
}

bool Plan::drivable() const {
    return blockingCount() == 0;
}

AuditInput auditInput(const Plan& plan) {
    return auditInput({.request = plan.request,
                       .margin = plan.margin,
                       .overhung = plan.overhung,
                       .headland = plan.headland,
                       .finishing = {},
                       .mainland = plan.headland.mainland,
                       .swaths = plan.swaths,
                       .route = plan.route,
                       .path = plan.path,
                       .leftOnPurpose = plan.leftOnPurpose,
                       .refill = plan.refill ? &*plan.refill : nullptr});
}

Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job,
                                             StageCache* cache) {
    return makePlan(request, job, cache, {});
}

Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job,
                                             StageCache* cache, const PlanCourse& course) {
    Stopwatch watch;
    StageCache ownCache;
    StageCache& stageCache = cache != nullptr ? *cache : ownCache;
    StageRunner runner{stageCache};
    // What is tried beside may tell of itself what its step has told before.
    SharedProgress rising{1, job};
    const JobContext part = rising.piece(0);
    const bool isWhole = !request.draft;
    const auto choice =
        quickestChoice(request, runner, part.part(0.0, isWhole ? kChosen : 1.0),
                       isWhole ? choosingCourse(request, runner, watch, course) : ChoosingCourse{});
    if (!choice) {
        return std::unexpected(choice.error());
    }
    std::shared_ptr<Plan> plan = planOf(request, *choice);
    const PlannedStages& stages = choice->plan;
    // The bound knows no trips to refill points.
    const bool isBounded = routeMethod(request.settings).traits.isByTime && plan->path.refillCount() == 0;
    Stopwatch proving;
    if (!request.draft && isBounded && !plan->route.steps.empty()) {
        const auto proof = proofStage({.request = stages.request,
                                       .ground = stages.ground,
                                       .laid = *stages.laidOut.laid,
                                       .rooms = stageCache.rooms},
                                      *stages.ordered, part.part(kChosen, 1.0));
        if (!proof) {
            return std::unexpected(proof.error());
        }
        plan->proof = *proof;
    }
    const Duration proved = proving.lap();
    addReasons(*plan);
    addNotes(*plan);
    plan->timings = runner.timings();
    plan->timings.proof = proved;
    plan->timings.total = watch.lap();
    part.report(1.0);
    return plan;
}

}  // namespace furrow
