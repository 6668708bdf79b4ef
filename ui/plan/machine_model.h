#pragma once

#include "planner/machine/machine.h"
#include "ui/plan/own_machines.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QStringList>
#include <QVariantList>

#include <vector>

namespace furrow {

struct MachineKey;

/// The machine of a plan: one of the library, and the numbers of it that a user is likely to change.
class MachineModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(QStringList library READ library NOTIFY machineChanged FINAL)
    Q_PROPERTY(int libraryIndex READ libraryIndex WRITE setLibraryIndex NOTIFY machineChanged FINAL)
    /// The numbers differ from those of the library.
    Q_PROPERTY(bool changed READ isChanged NOTIFY machineChanged FINAL)
    Q_PROPERTY(QString name READ name NOTIFY machineChanged FINAL)
    /// It is one that the user keeps.
    Q_PROPERTY(bool own READ isOwn NOTIFY machineChanged FINAL)
    Q_PROPERTY(QString problem READ problem NOTIFY problemChanged FINAL)

public:
    enum Role {
        KeyRole = Qt::UserRole + 1,
        NameRole,
        DescriptionRole,
        ValueRole,
        AutoTextRole,
        QuantityRole,
        FromRole,
        ToRole,
        StepRole,
        DecimalsRole,
    };

    explicit MachineModel(QObject* parent = nullptr);

    const Machine& machine() const { return machine_; }
    void show(const Machine& machine);
    QStringList library() const;
    /// Of the machine that this one was made from; -1 for one that is not from the library.
    int libraryIndex() const;
    void setLibraryIndex(int index);
    bool isChanged() const;
    bool isOwn() const { return own_.holds(machine_.id()); }
    /// The user's machines are in this folder.
    void keepIn(const QString& folder);
    QString name() const;
    QString problem() const { return sentence(problem_); }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// Every machine of the library and every number of one, for a search by name: name, keywords, key; of a
    /// machine its index.
    Q_INVOKABLE QVariantList searchable() const;
    /// In SI units. A value that no machine can have is refused and `problem` says why.
    Q_INVOKABLE void setNumber(int row, double value);
    /// Back to the machine of the library.
    Q_INVOKABLE void reset();
    /// Asks for the name to keep this machine under.
    Q_INVOKABLE void askForName() { emit nameRequested(); }
    /// This machine is kept, and becomes the machine of the plan.
    Q_INVOKABLE void keepAs(const QString& name);
    /// It is kept no longer; plans that have it go on having it.
    Q_INVOKABLE void forget();

signals:
    void machineChanged();
    void problemChanged();
    void nameRequested();
    /// The user wants this machine.
    void changeRequested(const furrow::Machine& machine);

private:
    void setProblem(const Message& problem);
    /// Those of the library, then the user's own.
    std::vector<Machine> all() const;

    OwnMachines own_;
    std::vector<const MachineKey*> keys_;
    Machine machine_;
    Message problem_;
};

}  // namespace furrow
