#pragma once

#include "ui/project/document.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QStringList>

namespace furrow {

/// The fields of the project and the plans of the current one: which are there, which is worked on, and what
/// can be done to them as a whole.
class FarmModel : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// Names, each with its area.
    Q_PROPERTY(QStringList fields READ fields NOTIFY changed FINAL)
    Q_PROPERTY(int currentField READ currentField WRITE setCurrentField NOTIFY changed FINAL)
    /// A field is worked on.
    Q_PROPERTY(bool hasField READ hasField NOTIFY changed FINAL)
    Q_PROPERTY(QString fieldName READ fieldName NOTIFY changed FINAL)
    /// Names of the current field's plans; one without a name is called by its machine.
    Q_PROPERTY(QStringList plans READ plans NOTIFY changed FINAL)
    Q_PROPERTY(int currentPlan READ currentPlan WRITE setCurrentPlan NOTIFY changed FINAL)
    Q_PROPERTY(QString planName READ planName NOTIFY changed FINAL)
    Q_PROPERTY(QString season READ season NOTIFY changed FINAL)

public:
    explicit FarmModel(Document& document, QObject* parent = nullptr);

    QStringList fields() const { return fields_; }
    int currentField() const;
    void setCurrentField(int index);
    bool hasField() const { return document_.project()->field() != nullptr; }
    QString fieldName() const;
    QStringList plans() const;
    int currentPlan() const;
    void setCurrentPlan(int index);
    QString planName() const;
    QString season() const;
    /// Name and season of the current plan as the user gave them; empty where neither was given.
    QString ownName() const;

    Q_INVOKABLE void renameField(const QString& name);
    Q_INVOKABLE void removeField();
    /// A copy of the current plan, to be changed.
    Q_INVOKABLE void addPlan(const QString& name);
    Q_INVOKABLE void renamePlan(const QString& name, const QString& season);
    Q_INVOKABLE void removePlan();

signals:
    void changed();

private:
    void follow();

    Document& document_;
    /// Of the fields, as they were shown last: areas take time, and a menu of them even more.
    QStringList fields_;
};

}  // namespace furrow
