#pragma once

#include "planner/plan/plan.h"
#include "ui/map/plan_drawing.h"

#include <QtQml/qqmlregistration.h>
#include <QDateTime>
#include <QObject>

#include <memory>

namespace furrow {

/// The plan on the map, how it is drawn, and whether that is of the field as it is now.
class ShownPlan : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(furrow::PlanDrawing drawing READ drawing NOTIFY drawingChanged FINAL)
    Q_PROPERTY(bool hasPlan READ hasPlan NOTIFY planChanged FINAL)
    /// It was planned in haste, as while something is dragged; the whole plan follows.
    Q_PROPERTY(bool draft READ isDraft NOTIFY planChanged FINAL)
    /// The drawing is of outlines that have changed since: a plan of the field as it is now follows.
    Q_PROPERTY(bool behind READ isBehind NOTIFY behindChanged FINAL)

public:
    using Source = std::shared_ptr<const FieldSource>;

    explicit ShownPlan(QObject* parent = nullptr) : QObject{parent} {}

    const PlanDrawing& drawing() const { return drawing_; }
    bool hasPlan() const { return plan_ != nullptr; }
    bool isDraft() const { return plan_ != nullptr && plan_->request.draft; }
    bool isBehind() const { return drawnSource_ != source_; }
    /// Null where there is none.
    const std::shared_ptr<const Plan>& plan() const { return plan_; }
    /// When the plan was made.
    const QDateTime& finished() const { return finished_; }
    /// The field as it is now; null for none.
    const Source& source() const { return source_; }

    /// Another field, or none: its outline is there at once, a plan may take seconds.
    void begin(Source source);
    /// The same field, changed or not.
    void follow(Source source);
    /// What was planned, of the field as `drawn` has it; a null plan for one that failed.
    void show(std::shared_ptr<const Plan> plan, PlanDrawing drawing, Source drawn);

signals:
    void drawingChanged();
    void planChanged();
    void behindChanged();

private:
    Source source_;
    std::shared_ptr<const Plan> plan_;
    QDateTime finished_;
    PlanDrawing drawing_;
    Source drawnSource_;
};

}  // namespace furrow
