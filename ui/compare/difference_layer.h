#pragma once

#include "ui/compare/plan_comparison.h"
#include "ui/map/map_layer.h"

#include <QColor>
#include <QPointer>

namespace furrow {

/// Draws the swaths, headland passes and turns that only one of two plans has: full lines for the plan that
/// is shown, dashes for the other one.
class DifferenceLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::PlanComparison* comparison READ comparison WRITE setComparison NOTIFY comparisonChanged
                   REQUIRED FINAL)
    Q_PROPERTY(QColor firstColor MEMBER firstColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor secondColor MEMBER secondColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    /// Those that only the one plan has; those that only the other one has.
    Q_PROPERTY(bool showFirst MEMBER showFirst_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(bool showSecond MEMBER showSecond_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor_ NOTIFY styleChanged FINAL)

public:
    explicit DifferenceLayer(QQuickItem* parent = nullptr);

    PlanComparison* comparison() const { return comparison_; }
    void setComparison(PlanComparison* comparison);

signals:
    void comparisonChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    QPointer<PlanComparison> comparison_;
    /// The swaths that differ have changed.
    bool stale_ = true;
    QColor firstColor_;
    QColor secondColor_;
    QColor casingColor_;
    bool showFirst_ = true;
    bool showSecond_ = true;
    double lineFactor_ = 1.0;
};

}  // namespace furrow
