#pragma once

#include "planner/plan/best_plan.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>

#include <string_view>
#include <vector>

namespace furrow {

/// The choices of a plan, and whether the search for the best plan may change them. What was set by hand
/// stays until the user says otherwise.
class ChoiceListModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a search")

public:
    enum Role { NameRole = Qt::UserRole + 1, FreeRole, GivenRole };

    explicit ChoiceListModel(QObject* parent = nullptr);

    /// As these settings have it.
    void begin(const Settings& settings);
    /// Ids of the choices that stay.
    std::vector<std::string_view> kept() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;
    Q_INVOKABLE void setFree(int row, bool free);

private:
    struct Row {
        PlanChoice choice;
        bool given = false;
        bool free = true;
    };
    std::vector<Row> rows_;
};

}  // namespace furrow
