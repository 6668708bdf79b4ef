#include "ui/plan/own_machines.h"

#include "planner/machine/machine_file.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>

#include <algorithm>

namespace furrow {

namespace {

const std::string kPrefix = "own-";

}  // namespace

void OwnMachines::keepIn(const QString& folder) {
    folder_ = folder;
    machines_.clear();
    const QDir place{folder_};
    for (const QString& name : place.entryList({QStringLiteral("own-*.json")}, QDir::Files)) {
        if (auto machine = readMachineFile(place.filePath(name).toStdString());
            machine && machine->id() == name.chopped(5).toStdString()) {
            machines_.push_back(*std::move(machine));
        }
    }
    sort();
}

bool OwnMachines::holds(const std::string& id) const {
    return std::ranges::contains(machines_, id, &Machine::id);
}

QString OwnMachines::fileOf(const std::string& id) const {
    return QDir{folder_}.filePath(QString::fromStdString(id) + QStringLiteral(".json"));
}

void OwnMachines::sort() {
    std::ranges::sort(machines_, {}, [](const Machine& machine) {
        return QString::fromStdString(std::string{machine.name()}).toCaseFolded();
    });
}

Result<Machine> OwnMachines::keep(const Machine& machine, const QString& name) {
    MachineSpec spec = machine.spec();
    spec.name = name.trimmed().toStdString();
    const auto same = std::ranges::find(machines_, spec.name, &Machine::name);
    if (same != machines_.end()) {
        spec.id = same->id();
    } else {
        int number = 1;
        while (holds(kPrefix + std::to_string(number)) ||
               QFile::exists(fileOf(kPrefix + std::to_string(number)))) {
            ++number;
        }
        spec.id = kPrefix + std::to_string(number);
    }
    auto kept = Machine::create(spec);
    if (!kept) {
        return kept;
    }
    QDir{}.mkpath(folder_);
    QSaveFile file{fileOf(spec.id)};
    const QByteArray text = QByteArray::fromStdString(machineJson(spec));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        // The system's own reason, in the user's language.
        const std::string reason = file.errorString().toStdString();
        return std::unexpected(Error{
            .code = ErrorCode::WriteFailed, .what = Message{reason}, .where = {}, .remedy = {}, .place = {}});
    }
    std::erase_if(machines_, [&](const Machine& each) { return each.id() == spec.id; });
    machines_.push_back(*kept);
    sort();
    return kept;
}

void OwnMachines::forget(const std::string& id) {
    if (holds(id)) {
        QFile::remove(fileOf(id));
        std::erase_if(machines_, [&](const Machine& each) { return each.id() == id; });
    }
}

}  // namespace furrow
