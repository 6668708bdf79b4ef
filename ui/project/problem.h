#pragma once

#include "planner/core/error.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoCoordinate>
#include <QObject>

#include <optional>

namespace furrow {

/// What went wrong last, in the user's language: what, where the trouble is, and what helps.
class Problem : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// Empty for none.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(QString where READ where NOTIFY changed FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY changed FINAL)
    Q_PROPERTY(QGeoCoordinate place READ place NOTIFY changed FINAL)

public:
    explicit Problem(QObject* parent = nullptr);

    bool isThere() const { return error_.has_value(); }
    QString text() const;
    QString where() const;
    QString remedy() const;
    QGeoCoordinate place() const;

    /// What was merely cancelled is no problem.
    void show(const Error& error);
    void clear();
    /// The message is read.
    Q_INVOKABLE void dismiss();

signals:
    void changed();
    void dismissed();

private:
    std::optional<Error> error_;
};

}  // namespace furrow
