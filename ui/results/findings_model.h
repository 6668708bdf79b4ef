#pragma once

#include "planner/plan/plan.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QGeoCoordinate>

#include <optional>
#include <vector>

namespace furrow {

/// What the user should know about a plan, each with its place on the map. Where there are many findings of
/// one kind they share a row, which shows one of them.
class FindingsModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)
    Q_PROPERTY(int toLookAt READ toLookAt NOTIFY countChanged FINAL)
    /// Of those, the ones that are in the way of driving.
    Q_PROPERTY(int blocking READ blocking NOTIFY countChanged FINAL)
    /// Rows of all findings.
    Q_PROPERTY(int rows READ rows NOTIFY countChanged FINAL)
    /// Rows for all findings, or for the first few only: a plan may have hundreds while a value is dragged.
    Q_PROPERTY(bool all READ showsAll WRITE setAll NOTIFY allChanged FINAL)
    Q_PROPERTY(int few READ few CONSTANT FINAL)
    /// What became of the findings since a change was applied; empty without one.
    Q_PROPERTY(QString outcome READ outcome NOTIFY outcomeChanged FINAL)

public:
    enum Role {
        NumberRole = Qt::UserRole + 1,
        FindingRole,      ///< which of all findings the row shows, from 0
        PlaceInKindRole,  ///< of those in the row, from 1
        KindCountRole,    ///< findings in the row
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

    /// So many of one kind share a row.
    static constexpr std::size_t kMany = 4;

    /// Of all findings, shown as rows or not.
    int count() const { return static_cast<int>(findings_.size()); }
    /// Those that are more than information.
    int toLookAt() const;
    int blocking() const;
    bool showsAll() const { return all_; }
    void setAll(bool all);
    int few() const { return 4; }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;
    int rows() const { return static_cast<int>(rows_.size()); }
    /// These count findings, not rows.
    Q_INVOKABLE QGeoCoordinate placeOf(int finding) const;
    /// The row that a finding is in.
    Q_INVOKABLE int rowOf(int finding) const;
    /// Its row shows this one of its kind.
    Q_INVOKABLE void bringForward(int finding);
    /// The next of the same kind, or the one before; around its end. -1 without a finding.
    Q_INVOKABLE int nextOfKind(int finding, int by) const;
    /// Of all findings, shown as rows or not.
    Q_INVOKABLE QStringList texts() const;
    QString outcome() const;
    /// Makes the change that corrects a finding.
    Q_INVOKABLE void apply(int finding);
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
    /// Findings of one kind, and which of them is shown.
    struct Row {
        std::vector<std::size_t> findings;
        std::size_t at = 0;
        bool isOf(const Finding& finding, const std::vector<Finding>& all) const;
    };
    std::vector<Row> rowsOf(const std::vector<Finding>& findings) const;
    int shownCount(std::size_t rows) const;
    const Finding& shownIn(const Row& row) const { return findings_[row.findings[row.at]]; }

    bool all_ = false;
    std::vector<Finding> findings_;
    std::vector<Row> rows_;
    std::optional<Applied> applied_;
    std::vector<QGeoCoordinate> places_;
};

}  // namespace furrow
