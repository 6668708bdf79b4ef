#include "ui/project/last_machine.h"

#include "planner/machine/machine_file.h"
#include "planner/settings/operation.h"

#include <QCoreApplication>
#include <QSettings>

#include <string>

namespace furrow {

namespace {

const QString kMachine = QStringLiteral("plan/machine");
const QString kOperation = QStringLiteral("plan/operation");

}  // namespace

void rememberMachine(const Machine& machine, const Settings& settings) {
    // Without an application of its own there is no place to remember it.
    if (QCoreApplication::organizationName().isEmpty()) {
        return;
    }
    QSettings stored;
    stored.setValue(kMachine, QString::fromStdString(machineJson(machine.spec())));
    stored.setValue(kOperation, QString::fromStdString(std::string{settings.choice(kOperationKind)}));
}

Project freshProject() {
    Project project = Project::empty();
    if (QCoreApplication::organizationName().isEmpty()) {
        return project;
    }
    const QSettings stored;
    if (auto machine = parseMachine(stored.value(kMachine).toString().toStdString(), "machine")) {
        project.standard.machine = *std::move(machine);
        const std::string operation = stored.value(kOperation).toString().toStdString();
        // One that a newer program wrote is not known here: the default stays.
        if (!operation.empty()) {
            (void)project.standard.settings.setText(kOperationKind, operation);
        }
    }
    return project;
}

}  // namespace furrow
