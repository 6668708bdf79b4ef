#pragma once

#include "planner/plan/plan.h"

#include <QDateTime>
#include <QString>

#include <memory>

namespace furrow {

/// A finished plan and what tells it from others, for everything that carries it out of the window.
struct PlanTitle {
    std::shared_ptr<const Plan> plan;
    /// Of the plan in its project, with its season; empty where it was given none.
    QString name;
    QDateTime finished;

    explicit operator bool() const { return plan != nullptr; }
    /// "Home Field · Spring drilling"
    QString heading() const;
    /// The machine, its width, how long the work takes and when it was planned.
    QString details() const;
    /// Both in one line.
    QString whole() const;

    friend bool operator==(const PlanTitle&, const PlanTitle&) = default;
};

}  // namespace furrow
