#include "ui/plan/cell_steps.h"

#include "planner/decomposition/decomposition.h"
#include "planner/decomposition/history.h"
#include "planner/plan/method_registry.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <algorithm>

namespace furrow {

namespace {

/// "4 cells, 11 min"
QString figures(const DecompositionStep& step) {
    return CellSteps::tr("%n block(s), %1", nullptr, static_cast<int>(step.cells))
        .arg(durationText(step.cost));
}

bool joinsCells(const Plan& plan) {
    return decompositionMethod(plan.request.settings).traits.joinsCells;
}

}  // namespace

CellSteps::CellSteps(QObject* parent) : QObject{parent} {
    connect(&Display::instance(), &Display::changed, this, &CellSteps::textsChanged);
}

const std::vector<DecompositionStep>& CellSteps::steps() const {
    static const std::vector<DecompositionStep> none;
    // One piece has nothing to show.
    return plan_ && plan_->cells.history.pieces.size() > 1 ? plan_->cells.history.steps : none;
}

void CellSteps::show(const std::shared_ptr<const Plan>& plan) {
    if (plan == plan_) {
        return;
    }
    setCurrent(-1);
    plan_ = plan;
    emit planChanged();
    emit textsChanged();
}

QString CellSteps::summary() const {
    if (steps().empty()) {
        return {};
    }
    return steps().size() == 1
               ? tr("Cut: %1").arg(figures(steps().front()))
               : tr("Cut: %1 → joined: %2").arg(figures(steps().front()), figures(steps().back()));
}

QString CellSteps::remark() const {
    return steps().size() == 1 && joinsCells(*plan_) ? tr("Joining any two of them would save nothing.")
                                                     : QString{};
}

void CellSteps::setCurrent(int step) {
    step = std::clamp(step, -1, count() - 1);
    if (step == current_) {
        return;
    }
    current_ = step;
    drawing_ = {};
    if (step >= 0) {
        const DecompositionHistory& history = plan_->cells.history;
        const auto cells = outlinesAt(history, static_cast<std::size_t>(step), {});
        const auto joined = joinedAt(history, static_cast<std::size_t>(step), {});
        if (cells && joined) {
            drawing_ = CellDrawing{cellGeometry(plan_->field().frame(), *cells, *joined)};
        }
    }
    emit currentChanged();
    emit textsChanged();
}

QString CellSteps::currentText() const {
    if (current_ < 0) {
        return {};
    }
    return tr("Step %1 of %2: %3")
        .arg(current_ + 1)
        .arg(count())
        .arg(figures(steps()[static_cast<std::size_t>(current_)]));
}

QString CellSteps::joinText() const {
    if (current_ < 0) {
        return {};
    }
    if (current_ == 0) {
        return tr("As cut.");
    }
    const DecompositionStep& step = steps()[static_cast<std::size_t>(current_)];
    const Duration saved = steps()[static_cast<std::size_t>(current_) - 1].cost - step.cost;
    return saved.si() > 0.0 ? tr("The two marked blocks become one: that saves %1.").arg(durationText(saved))
                            : tr("Blocks in which no swath lies go to their neighbours.");
}

}  // namespace furrow
