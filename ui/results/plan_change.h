#pragma once

#include "planner/plan/plan.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>

#include <memory>
#include <string>

namespace furrow {

/// What became of the figures with the last change, in one line.
class PlanChange : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// Empty for the first plan of a field.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)

public:
    explicit PlanChange(QObject* parent = nullptr);

    /// A plan that is whole; null for none. Plans of different fields are not compared.
    void show(const std::string& field, const std::shared_ptr<const Plan>& plan);

    QString text() const;

signals:
    void changed();

private:
    std::string field_;
    std::shared_ptr<const Plan> before_;
    std::shared_ptr<const Plan> plan_;
};

}  // namespace furrow
