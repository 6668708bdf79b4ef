#pragma once

#include "planner/plan/choice_table.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>

#include <vector>

namespace furrow {

/// What each choice of the best plan is worth: first what was taken, then the alternatives that came near,
/// the nearest first.
class ChoiceTableModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a search")
    /// Alternatives without a row, since they are slower than those with one.
    Q_PROPERTY(int behind READ behind NOTIFY tableChanged FINAL)
    Q_PROPERTY(int count READ rowCount NOTIFY tableChanged FINAL)

public:
    enum Role { ChoiceRole = Qt::UserRole + 1, TextRole, WorthRole, TakenRole, ShareRole };

    explicit ChoiceTableModel(QObject* parent = nullptr) : QAbstractListModel{parent} {}

    void show(const ChoiceTable& table);

    int behind() const { return behind_; }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

signals:
    void tableChanged();

private:
    std::vector<TriedChoice> rows_;
    Duration most_;  ///< of the differences
    int behind_ = 0;
};

}  // namespace furrow
