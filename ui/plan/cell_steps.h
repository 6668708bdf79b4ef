#pragma once

#include "planner/plan/plan.h"
#include "ui/map/cell_drawing.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>

#include <memory>

namespace furrow {

/// How the cells of a plan came about, step by step: as cut, then one join after the other.
class CellSteps : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// Of the plan; 0 where it was not cut.
    Q_PROPERTY(int count READ count NOTIFY planChanged FINAL)
    /// "Cut: 9 cells, 14 min → joined: 4 cells, 11 min".
    Q_PROPERTY(QString summary READ summary NOTIFY textsChanged FINAL)
    /// Why there is nothing to go through; empty where there is.
    Q_PROPERTY(QString remark READ remark NOTIFY textsChanged FINAL)
    /// That is shown, from 0; -1 for none.
    Q_PROPERTY(int current READ current WRITE setCurrent NOTIFY currentChanged FINAL)
    /// "Step 3 of 6: 7 cells, 12 min".
    Q_PROPERTY(QString currentText READ currentText NOTIFY textsChanged FINAL)
    /// What the join did.
    Q_PROPERTY(QString joinText READ joinText NOTIFY textsChanged FINAL)
    Q_PROPERTY(furrow::CellDrawing drawing READ drawing NOTIFY currentChanged FINAL)

public:
    explicit CellSteps(QObject* parent = nullptr);

    /// Null for no plan. Leaves the steps of another one.
    void show(const std::shared_ptr<const Plan>& plan);

    int count() const { return static_cast<int>(steps().size()); }
    QString summary() const;
    QString remark() const;
    int current() const { return current_; }
    /// -1 shows the plan again; beyond the last one is the last one.
    void setCurrent(int step);
    QString currentText() const;
    QString joinText() const;
    const CellDrawing& drawing() const { return drawing_; }

signals:
    void planChanged();
    void textsChanged();
    void currentChanged();

private:
    const std::vector<DecompositionStep>& steps() const;

    std::shared_ptr<const Plan> plan_;
    int current_ = -1;
    CellDrawing drawing_;
};

}  // namespace furrow
