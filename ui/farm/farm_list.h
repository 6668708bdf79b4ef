#pragma once

#include "ui/farm/farm_plans.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QGeoCoordinate>
#include <QGeoRectangle>
#include <QList>
#include <QPointF>

#include <memory>
#include <set>
#include <vector>

namespace furrow {

/// Every field of the farm, one a row, with what its plan comes to: sorted, filtered, selected.
class FarmList : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ count NOTIFY rowsChanged FINAL)
    /// Only fields, plans, seasons and machines with these words.
    Q_PROPERTY(QString filter READ filter WRITE setFilter NOTIFY rowsChanged FINAL)
    /// By a column, not as in the project.
    Q_PROPERTY(bool sorted READ isSorted NOTIFY rowsChanged FINAL)
    Q_PROPERTY(Column sortedBy READ sortedBy NOTIFY rowsChanged FINAL)
    Q_PROPERTY(bool descending READ isDescending NOTIFY rowsChanged FINAL)
    Q_PROPERTY(int selectedCount READ selectedCount NOTIFY totalsChanged FINAL)
    /// Of the chosen fields: the selected ones, where none is selected those in the list.
    Q_PROPERTY(QString totals READ totals NOTIFY totalsChanged FINAL)
    /// Chosen fields that have no plan of their present inputs.
    Q_PROPERTY(int toPlan READ toPlan NOTIFY totalsChanged FINAL)

public:
    enum Column { Name, Machine, Area, Time, Way, State };
    Q_ENUM(Column)
    enum PlanState { NoPlan, OutOfDate, Waiting, Planning, Drivable, Problems, Failed };
    Q_ENUM(PlanState)
    /// What a click does to the selection.
    enum Pick { Only, Toggle, UpTo };
    Q_ENUM(Pick)
    enum Role {
        NameRole = Qt::UserRole + 1,
        PlanRole,
        MachineRole,
        AreaRole,
        TimeRole,
        WayRole,
        StateRole,
        StateTextRole,
        HintRole,
        OutlineRole,
        SelectedRole,
        CurrentRole,
        BoundsRole
    };

    FarmList(Document& document, FarmPlans& plans, QObject* parent = nullptr);

    int count() const { return static_cast<int>(order_.size()); }
    QString filter() const { return filter_; }
    void setFilter(const QString& filter);
    bool isSorted() const { return !inProjectOrder_; }
    Column sortedBy() const { return column_; }
    bool isDescending() const { return descending_; }
    int selectedCount() const { return static_cast<int>(selected_.size()); }
    QString totals() const;
    int toPlan() const;

    /// By this column; once more for the other way round.
    Q_INVOKABLE void sortBy(furrow::FarmList::Column column);
    Q_INVOKABLE void pick(int row, furrow::FarmList::Pick how);
    Q_INVOKABLE void selectAll();
    Q_INVOKABLE void selectNone();
    /// Works on the field of a row.
    Q_INVOKABLE void open(int row);
    Q_INVOKABLE int rowOfCurrent() const;
    /// Plans the chosen fields.
    Q_INVOKABLE void planSelected();
    /// The machine and the settings of the current plan for the chosen fields.
    Q_INVOKABLE void planLikeCurrent();
    Q_INVOKABLE void addPlans(const QString& name, const QString& season);
    /// Around all fields; not valid without one.
    Q_INVOKABLE QGeoRectangle bounds() const;
    /// The field at a place on the map; -1 for none.
    Q_INVOKABLE int rowAt(const QGeoCoordinate& place) const;

    /// The ids of the chosen fields.
    Q_INVOKABLE QStringList chosenIds() const;
    /// The selected fields; where none is selected, those that the filter leaves. By index in the project,
    /// in its order.
    std::vector<std::size_t> chosen() const;
    /// Of a row.
    const ProjectField& field(int row) const;
    bool isSelected(int row) const;
    PlanState stateOf(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

signals:
    void rowsChanged();
    void totalsChanged();

private:
    /// A field and what it costs to find out about it.
    struct Entry {
        std::shared_ptr<const ProjectField> field;
        std::size_t plan = 0;
        std::string key;
        furrow::Area area;
        QGeoRectangle bounds;
    };
    const Entry& entry(int row) const { return entries_[order_[static_cast<std::size_t>(row)]]; }
    const FieldPlan& planOf(const Entry& entry) const { return entry.field->plans[entry.plan]; }
    PlanState stateOf(const Entry& entry) const;
    QString stateText(const Entry& entry) const;
    QString hint(const Entry& entry) const;
    bool matches(const Entry& entry) const;
    bool comesBefore(std::size_t a, std::size_t b) const;
    void follow();
    void arrange();
    void refresh();

    Document& document_;
    FarmPlans& plans_;
    std::vector<Entry> entries_;      ///< as in the project
    std::vector<std::size_t> order_;  ///< of the rows, in entries_
    std::set<std::string> selected_;  ///< ids of fields
    std::string anchor_;
    QString filter_;
    Column column_ = Name;
    bool descending_ = false;
    bool inProjectOrder_ = true;
};

}  // namespace furrow
