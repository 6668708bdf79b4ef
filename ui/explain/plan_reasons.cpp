#include "ui/explain/plan_reasons.h"

#include "planner/plan/method_registry.h"
#include "ui/project/document.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <utility>

namespace furrow {

PlanReasons::PlanReasons(Document& document, ShownPlan& shown, QObject* parent)
    : QObject{parent}, document_{document}, shown_{shown}, headings_{document} {
    connect(&document_, &Document::projectChanged, this, &PlanReasons::changedStepsChanged);
    connect(&shown_, &ShownPlan::planChanged, this, &PlanReasons::follow);
    connect(&Display::instance(), &Display::changed, this, &PlanReasons::changed);
}

QVariantMap PlanReasons::texts() const {
    QVariantMap texts;
    for (const Explanation& reason : reasons_) {
        texts.insert(fromStd(reason.step), sentence(reason.text));
    }
    return texts;
}

QStringList PlanReasons::changedSteps() const {
    QStringList ids;
    if (plan_ == nullptr) {
        return ids;
    }
    const Settings& settings = document_.project()->plan().settings;
    for (const StageInfo& stage : stages()) {
        if (settings.choice(*stage.method) != plan_->request.settings.choice(*stage.method)) {
            ids << fromStd(stage.id);
        }
    }
    return ids;
}

void PlanReasons::follow() {
    const auto& plan = shown_.plan();
    if (plan == nullptr) {
        runner_.cancel();
        asked_.reset();
        show(nullptr, {}, std::nullopt);
        return;
    }
    if (plan->request.draft || plan == asked_) {
        return;
    }
    asked_ = plan;
    runner_.submit([this, plan](const JobContext& job) -> JobRunner::Delivery {
        auto curve = headingCurve(*plan, job);
        // Without figures of other headings there is still much to say.
        auto reasons = explanations(*plan, curve.value_or(std::nullopt), job);
        return [this, plan, curve = curve.value_or(std::nullopt), reasons = std::move(reasons)]() mutable {
            if (plan == asked_ && reasons) {
                show(plan, *std::move(reasons), std::move(curve));
            }
        };
    });
}

void PlanReasons::show(std::shared_ptr<const Plan> plan, std::vector<Explanation> reasons,
                       std::optional<HeadingCurve> curve) {
    plan_ = std::move(plan);
    reasons_ = std::move(reasons);
    headings_.show(plan_, std::move(curve));
    emit changed();
    emit changedStepsChanged();
}

}  // namespace furrow
