#pragma once

#include <QtQml/qqmlregistration.h>
#include <QObject>

/// How the plan stands to what the panels show. The one state that the chip, the steps, the figures and every
/// way out of the window go by.
namespace furrow::plan_state {

Q_NAMESPACE
QML_NAMED_ELEMENT(PlanState)

enum class State {
    Empty,      ///< there is no field
    Reading,    ///< a file is being read
    Choosing,   ///< the user picks fields of a file
    Planning,   ///< the plan of what the panels show is being made; what is drawn is older, or a draft
    Ready,      ///< the plan belongs to exactly what the panels show, and nothing in it blocks
    Problems,   ///< as Ready, but findings of it block
    OutOfDate,  ///< planning was stopped: what is drawn is the plan before the change, a draft, or nothing
    Failed,     ///< what the panels show cannot be planned
};
Q_ENUM_NS(State)

}  // namespace furrow::plan_state

namespace furrow {

using PlanState = plan_state::State;

/// The plan is whole and belongs to what the panels show: only then may it leave the window.
constexpr bool isFinished(PlanState state) {
    return state == PlanState::Ready || state == PlanState::Problems;
}

}  // namespace furrow
