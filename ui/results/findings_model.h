#pragma once

#include "planner/plan/plan.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QGeoCoordinate>

#include <optional>
#include <vector>

namespace furrow {

/// What the user should know about a plan, each with its place on the map.
class FindingsModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)
    Q_PROPERTY(int toLookAt READ toLookAt NOTIFY countChanged FINAL)
    /// Rows for all findings, or for the first few only: a plan may have hundreds while a value is dragged.
    Q_PROPERTY(bool all READ showsAll WRITE setAll NOTIFY allChanged FINAL)
    Q_PROPERTY(int few READ few CONSTANT FINAL)
    /// What became of the findings since a change was applied; empty without one.
    Q_PROPERTY(QString outcome READ outcome NOTIFY outcomeChanged FINAL)

public:
    enum Role {
        NumberRole = Qt::UserRole + 1,
        TextRole,
        SuggestionRole,
        WeightRole,
        BeginsInformationRole,
        PlaceRole,
        ChangeRole
    };

    /// Of `WeightRole`: as furrow::Weight.
    enum Kind { Blocks, Look, Information };
    Q_ENUM(Kind)

    explicit FindingsModel(QObject* parent = nullptr);

    /// `places` are those of the findings, in their order.
    void show(const std::vector<Finding>& findings, const std::vector<QGeoCoordinate>& places);

    /// Of all findings, shown as rows or not.
    int count() const { return static_cast<int>(findings_.size()); }
    /// Those that are more than information.
    int toLookAt() const;
    bool showsAll() const { return all_; }
    void setAll(bool all);
    int few() const { return 4; }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;
    Q_INVOKABLE QGeoCoordinate placeOf(int row) const;
    /// Of all findings, shown as rows or not.
    Q_INVOKABLE QStringList texts() const;
    QString outcome() const;
    /// Makes the change that corrects a finding.
    Q_INVOKABLE void apply(int row);
    Q_INVOKABLE void forgetOutcome();

signals:
    void countChanged();
    void allChanged();
    void outcomeChanged();
    void changeRequested(const furrow::SettingChange& change);

private:
    /// A change that was applied, with the number of blocking findings before it and after it.
    struct Applied {
        SettingChange change;
        std::ptrdiff_t before = 0;
        std::optional<std::ptrdiff_t> after;
    };
    int shownCount(std::size_t findings) const;

    bool all_ = false;
    std::vector<Finding> findings_;
    std::optional<Applied> applied_;
    std::vector<QGeoCoordinate> places_;
};

}  // namespace furrow
