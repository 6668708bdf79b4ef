#pragma once

#include "planner/plan/plan.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>

namespace furrow {

/// The figures of a plan, one a row: what it is and how much.
class FiguresModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")

public:
    enum Role { LabelRole = Qt::UserRole + 1, ValueRole, HintRole };

    explicit FiguresModel(QObject* parent = nullptr) : QAbstractListModel{parent} {}

    /// Null for no plan.
    void show(const Plan* plan);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

private:
    struct Figure {
        QString label;
        QString value;
        QString hint;
    };
    std::vector<Figure> figures_;
};

}  // namespace furrow
