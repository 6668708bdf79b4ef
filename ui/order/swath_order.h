#pragma once

#include "planner/plan/plan.h"
#include "ui/map/shown_plan.h"
#include "ui/project/document.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>

#include <memory>
#include <optional>
#include <vector>

namespace furrow {

/// The swaths of the plan in driving order, and the order as it is changed by hand: in the list, or by
/// pointing at swaths on the map one after the other.
class SwathOrder : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ rowCount NOTIFY orderChanged FINAL)
    /// The order is by hand.
    Q_PROPERTY(bool byHand READ isByHand NOTIFY orderChanged FINAL)
    /// Swaths that are pointed at come after the one before.
    Q_PROPERTY(bool pointing READ isPointing WRITE setPointing NOTIFY pointingChanged FINAL)
    /// The row that the next swath comes after; -1 for none.
    Q_PROPERTY(int current READ current WRITE setCurrent NOTIFY currentChanged FINAL)
    /// How many swaths were pointed at.
    Q_PROPERTY(int pointedCount READ pointedCount NOTIFY currentChanged FINAL)

public:
    enum Role { NumberRole = Qt::UserRole + 1, LengthRole, BearingRole };

    SwathOrder(Document& document, ShownPlan& shown, QObject* parent = nullptr);

    bool isByHand() const;
    bool isPointing() const { return pointing_; }
    void setPointing(bool pointing);
    int current() const { return current_; }
    void setCurrent(int row);
    int pointedCount() const { return static_cast<int>(pointed_.size()); }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// Puts a row to another place, and follows it.
    Q_INVOKABLE void move(int from, int to);
    /// Drives a row the other way.
    Q_INVOKABLE void turn(int row);
    /// A segment of the path was clicked on the map.
    Q_INVOKABLE void point(int segment);
    /// The segment of the path that works on the row's swath; -1 for none.
    Q_INVOKABLE int segmentOf(int row) const;
    /// Those that were pointed at follow each other, and the order of the others is searched.
    Q_INVOKABLE void searchOthers();
    /// Forgets the order by hand.
    Q_INVOKABLE void searchAll();

signals:
    void orderChanged();
    void pointingChanged();
    void currentChanged();

private:
    void show();
    void take(std::vector<RouteStep> steps);
    void change(const LazyText& text, const Settings& settings);
    int rowOf(std::size_t swath) const;

    Document& document_;
    ShownPlan& shown_;
    std::shared_ptr<const Plan> plan_;  ///< whose swaths the steps name
    std::vector<RouteStep> steps_;
    std::vector<std::size_t> pointed_;  ///< swaths
    bool pointing_ = false;
    int current_ = -1;
};

}  // namespace furrow
