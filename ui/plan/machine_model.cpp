#include "ui/plan/machine_model.h"

#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"
#include "planner/units/unit_system.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <array>

namespace furrow {

namespace {

/// What decides a plan and what people know of their machine.
constexpr std::array<std::string_view, 8> kShownKeys{
    "operating_width_m", "vehicle_width_m", "min_turning_radius_m", "raised_width_m",
    "transport_width_m", "time_to_fold_s",  "working_speed_mps",    "turning_speed_mps"};

QuantityText::Kind quantityOf(const MachineKey& key) {
    return key.unit == "m/s" ? QuantityText::Speed
           : key.unit == "m" ? QuantityText::Length
           : key.unit == "s" ? QuantityText::Duration
                             : QuantityText::Number;
}

/// Half a km/h, five seconds, a decimetre.
double stepOf(const MachineKey& key) {
    return key.unit == "m/s" ? 0.5 * kKilometrePerHourMps : key.unit == "s" ? 5.0 : 0.1;
}

int decimalsOf(const MachineKey& key) {
    return key.unit == "m/s" ? 1 : key.unit == "s" ? 0 : 2;
}

/// What stands for a number that is not given.
std::optional<double> impliedNumber(const MachineKey& key, const Machine& machine) {
    if (key.key == "min_turning_radius_m") {
        return machine.minTurningRadius().si();
    }
    if (key.key == "raised_width_m") {
        return machine.operatingWidth().si();
    }
    if (key.key == "transport_width_m") {
        const Implement& implement = machine.spec().implement;
        return implement.raisedWidth.value_or(implement.operatingWidth).si();
    }
    return std::nullopt;
}

}  // namespace

MachineModel::MachineModel(QObject* parent) : QAbstractListModel{parent}, machine_{machineLibrary().front()} {
    for (const std::string_view name : kShownKeys) {
        const auto key = std::ranges::find(machineKeys(), name, &MachineKey::key);
        if (key != machineKeys().end()) {
            keys_.push_back(&*key);
        }
    }
    connect(&Display::instance(), &Display::changed, this, [this] {
        emit dataChanged(index(0), index(rowCount() - 1));
        emit machineChanged();
        emit problemChanged();
    });
}

std::vector<Machine> MachineModel::all() const {
    const auto library = machineLibrary();
    std::vector<Machine> machines{library.begin(), library.end()};
    machines.insert(machines.end(), own_.machines().begin(), own_.machines().end());
    return machines;
}

QStringList MachineModel::library() const {
    QStringList names;
    for (const Machine& machine : all()) {
        names << shown(machine.name());
    }
    return names;
}

void MachineModel::setLibraryIndex(int index) {
    const std::vector<Machine> machines = all();
    if (index < 0 || index >= static_cast<int>(machines.size())) {
        return;
    }
    emit changeRequested(machines[static_cast<std::size_t>(index)]);
}

int MachineModel::libraryIndex() const {
    const std::vector<Machine> machines = all();
    const auto same = std::ranges::find(machines, machine_.id(), &Machine::id);
    return same == machines.end() ? -1 : static_cast<int>(same - machines.begin());
}

bool MachineModel::isChanged() const {
    const int index = libraryIndex();
    return index >= 0 && machine_ != all()[static_cast<std::size_t>(index)];
}

void MachineModel::keepIn(const QString& folder) {
    own_.keepIn(folder);
    emit machineChanged();
}

void MachineModel::keepAs(const QString& name) {
    const auto kept = own_.keep(machine_, name);
    if (!kept) {
        setProblem(kept.error().what);
        return;
    }
    setProblem({});
    emit changeRequested(*kept);
    emit machineChanged();
}

void MachineModel::forget() {
    own_.forget(machine_.id());
    emit machineChanged();
}

QString MachineModel::name() const {
    return shown(machine_.name());
}

QVariantList MachineModel::searchable() const {
    QVariantList found;
    const auto entry = [](const QString& name, const QString& keywords, const QString& field) {
        return QVariantMap{{QStringLiteral("name"), name},
                           {QStringLiteral("group"), tr("Machine")},
                           {QStringLiteral("keywords"), keywords},
                           {QStringLiteral("stepId"), QStringLiteral("machine")},
                           {QStringLiteral("key"), QStringLiteral("machine.") + field}};
    };
    const QStringList machines = library();
    for (qsizetype i = 0; i < machines.size(); ++i) {
        QVariantMap machine = entry(machines[i], tr("machine"), QStringLiteral("library"));
        machine.insert(QStringLiteral("machine"), i);
        found << machine;
    }
    for (const MachineKey* const key : keys_) {
        found << entry(shown(key->name), shown(key->description), fromStd(key->key));
    }
    return found;
}

void MachineModel::reset() {
    setLibraryIndex(libraryIndex());
}

int MachineModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(keys_.size());
}

QVariant MachineModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const MachineKey& key = *keys_[static_cast<std::size_t>(index.row())];
    const MachineValue given = key.get(machine_.spec());
    const auto* number = std::get_if<double>(&given);
    const double held = number != nullptr ? *number : impliedNumber(key, machine_).value_or(0.0);
    switch (role) {
        case KeyRole: return fromStd(key.key);
        case Qt::DisplayRole:
        case NameRole: return shown(key.name);
        case DescriptionRole: return shown(key.description);
        case ValueRole: return held;
        case AutoTextRole:
            return number != nullptr ? QString{}
                                     : tr("auto · %1").arg(QuantityText{}.text(held, quantityOf(key), 1));
        case QuantityRole: return quantityOf(key);
        case FromRole: return key.min;
        case ToRole: return key.max;
        case StepRole: return stepOf(key);
        case DecimalsRole: return decimalsOf(key);
        default: return {};
    }
}

QHash<int, QByteArray> MachineModel::roleNames() const {
    return {{KeyRole, "key"},
            {NameRole, "name"},
            {DescriptionRole, "description"},
            {ValueRole, "value"},
            {AutoTextRole, "autoText"},
            {QuantityRole, "quantity"},
            {FromRole, "from"},
            {ToRole, "to"},
            {StepRole, "step"},
            {DecimalsRole, "decimals"}};
}

void MachineModel::setNumber(int row, double value) {
    if (row < 0 || row >= rowCount()) {
        return;
    }
    const MachineKey& key = *keys_[static_cast<std::size_t>(row)];
    MachineSpec spec = machine_.spec();
    key.set(spec, MachineValue{value});
    const Result<Machine> made = Machine::create(spec);
    setProblem(made ? Message{} : made.error().what);
    if (made) {
        emit changeRequested(*made);
    }
}

void MachineModel::setProblem(const Message& problem) {
    if (problem != problem_) {
        problem_ = problem;
        emit problemChanged();
    }
}

void MachineModel::show(const Machine& machine) {
    if (machine == machine_) {
        return;
    }
    // It was about another one.
    setProblem({});
    machine_ = machine;
    emit dataChanged(index(0), index(rowCount() - 1));
    emit machineChanged();
}

}  // namespace furrow
