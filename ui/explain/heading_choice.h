#pragma once

#include "planner/plan/heading_curve.h"
#include "ui/map/shown_plan.h"
#include "ui/project/document.h"

#include <QtQml/qqmlregistration.h>
#include <QList>
#include <QObject>
#include <QPointF>

#include <memory>
#include <optional>

namespace furrow {

/// The headings of a field as points of a chart, one of which may be taken. Upwards is slower, from the
/// least time at 0 to the most at 1; to the right is the bearing, or what else is worse.
class HeadingChoice : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to the reasons of a plan")
    Q_PROPERTY(bool available READ isAvailable NOTIFY changed FINAL)
    Q_PROPERTY(Across across READ across WRITE setAcross NOTIFY changed FINAL)
    /// By rising bearing, each in [0, 1] x [0, 1].
    Q_PROPERTY(QList<QPointF> points READ points NOTIFY changed FINAL)
    /// Those that no other heading beats in time, overlap and missed area.
    Q_PROPERTY(QList<int> tradeOffs READ tradeOffs NOTIFY changed FINAL)
    /// Of the plan; -1 for none.
    Q_PROPERTY(int chosen READ chosen NOTIFY changed FINAL)
    Q_PROPERTY(int longestEdge READ longestEdge NOTIFY changed FINAL)
    Q_PROPERTY(QString leastTime READ leastTime NOTIFY changed FINAL)
    Q_PROPERTY(QString mostTime READ mostTime NOTIFY changed FINAL)
    Q_PROPERTY(QString leastAcross READ leastAcross NOTIFY changed FINAL)
    Q_PROPERTY(QString mostAcross READ mostAcross NOTIFY changed FINAL)
    /// The heading was given, not searched.
    Q_PROPERTY(bool byHand READ isByHand NOTIFY changed FINAL)

public:
    enum Across { Bearing, Overlap, Missed, Turning };
    Q_ENUM(Across)

    HeadingChoice(Document& document, QObject* parent = nullptr);

    /// Empty where there is nothing to choose from.
    void show(std::shared_ptr<const Plan> plan, std::optional<HeadingCurve> curve);

    bool isAvailable() const { return curve_.has_value(); }
    Across across() const { return across_; }
    void setAcross(Across across);
    QList<QPointF> points() const;
    QList<int> tradeOffs() const;
    int chosen() const { return curve_ ? static_cast<int>(curve_->chosen) : -1; }
    int longestEdge() const {
        return curve_ && curve_->longestEdge ? static_cast<int>(*curve_->longestEdge) : -1;
    }
    QString leastTime() const;
    QString mostTime() const;
    QString leastAcross() const;
    QString mostAcross() const;
    bool isByHand() const;

    /// The point that is meant by a place in the chart; -1 for none.
    Q_INVOKABLE int nearest(double x, double y) const;
    /// "100° · 36 swaths": short, for a mark.
    Q_INVOKABLE QString bearingOf(int point) const;
    /// All figures of a heading.
    Q_INVOKABLE QString describe(int point) const;
    /// Swaths run along this heading from now on.
    Q_INVOKABLE void take(int point);
    /// The heading is searched again.
    Q_INVOKABLE void search();

signals:
    void changed();

private:
    double valueOf(const HeadingTrial& trial) const;
    QString acrossText(double value) const;
    const HeadingTrial* trial(int point) const;
    void change(const LazyText& text, const Settings& settings);

    Document& document_;
    std::shared_ptr<const Plan> plan_;
    std::optional<HeadingCurve> curve_;
    Across across_ = Bearing;
    double leastS_ = 0.0;
    double mostS_ = 0.0;
};

}  // namespace furrow
