#include "ui/plan/parameter_model.h"

#include "planner/geometry/wkt.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/used_settings.h"
#include "planner/settings/places.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/unit_text.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

/// An angle that may point anywhere is a direction; others are differences.
bool isDirection(const Parameter& parameter) {
    return parameter.kind == ParameterKind::Angle && parameter.max - parameter.min >= 180.0;
}

/// Between degrees counter-clockwise from east and a line's bearing; the same both ways.
double turnedDeg(double degrees) {
    const double turned = std::fmod(90.0 - degrees, 180.0);
    return turned < 0.0 ? turned + 180.0 : turned;
}

ParameterModel::Kind kindOf(const Parameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::Choice: return ParameterModel::Kind::Choice;
        case ParameterKind::Flag: return ParameterModel::Kind::Flag;
        case ParameterKind::Line:
        case ParameterKind::Lines:
        case ParameterKind::File:
        case ParameterKind::Place:
        case ParameterKind::Places:
        case ParameterKind::Numbers: return ParameterModel::Kind::Text;
        case ParameterKind::Length:
        case ParameterKind::Angle:
        case ParameterKind::Count:
        case ParameterKind::Percent: break;
    }
    return isDirection(parameter) ? ParameterModel::Kind::Direction : ParameterModel::Kind::Number;
}

/// "North gate, 2 places on the map".
QString placesInWords(const std::string& text) {
    QStringList words;
    int points = 0;
    for (const GivenPlace& place : givenPlaces(text).value_or(std::vector<GivenPlace>{})) {
        if (place.point) {
            ++points;
        } else {
            words.append(fromStd(place.name));
        }
    }
    if (points > 0) {
        words.append(ParameterModel::tr("%n place(s) on the map", nullptr, points));
    }
    return words.join(QStringLiteral(", "));
}

/// What a text of lines or places holds, in words.
QString pickedText(ParameterKind kind, const std::string& text) {
    switch (kind) {
        case ParameterKind::Place:
        case ParameterKind::Places: return placesInWords(text);
        case ParameterKind::Line:
        case ParameterKind::Lines: break;
        default: return {};
    }
    const auto lines = linesOfWkt(text);
    if (!lines || lines->empty()) {
        return placesInWords(text);
    }
    return lines->size() == 1
               ? ParameterModel::tr("a line of %n point(s)", nullptr, static_cast<int>(lines->front().size()))
               : ParameterModel::tr("%n line(s)", nullptr, static_cast<int>(lines->size()));
}

int decimalsOf(const Parameter& parameter) {
    if (parameter.kind == ParameterKind::Count) {
        return 0;
    }
    if (parameter.kind == ParameterKind::Length) {
        return parameter.step < 0.1 ? 2 : parameter.step < 1.0 ? 1 : 0;
    }
    if (parameter.kind == ParameterKind::Percent) {
        return parameter.step < 1.0 ? 1 : 0;
    }
    return parameter.min < 0.1 && !isDirection(parameter) ? 2 : 1;
}

QuantityText::Kind quantityOf(const Parameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::Length: return QuantityText::Length;
        case ParameterKind::Angle: return QuantityText::Angle;
        case ParameterKind::Count: return QuantityText::Count;
        case ParameterKind::Percent:
        case ParameterKind::Choice:
        case ParameterKind::Flag:
        case ParameterKind::Line:
        case ParameterKind::Lines:
        case ParameterKind::File:
        case ParameterKind::Place:
        case ParameterKind::Places:
        case ParameterKind::Numbers: break;
    }
    return QuantityText::Number;
}

/// The numbers that a plan filled in for "auto".
std::map<std::string, double, std::less<>> usedNumbers(const std::vector<const Parameter*>& parameters,
                                                       const Plan* plan) {
    std::map<std::string, double, std::less<>> used;
    for (const Parameter* const parameter : parameters) {
        if (const auto number = plan != nullptr ? computedNumber(*plan, *parameter) : std::nullopt) {
            used.emplace(parameter->key, *number);
        }
    }
    return used;
}

std::size_t choiceIndex(const Parameter& parameter, const Settings& settings) {
    const auto found = std::ranges::find(parameter.choices, settings.choice(parameter), &Choice::id);
    return found == parameter.choices.end() ? 0 : static_cast<std::size_t>(found - parameter.choices.begin());
}

}  // namespace

ParameterModel::ParameterModel(QObject* parent) : QAbstractListModel{parent} {
    connect(&Display::instance(), &Display::changed, this, &ParameterModel::refresh);
}

void ParameterModel::show(const std::vector<const Parameter*>& parameters, const Settings& settings,
                          const Plan* plan) {
    auto used = usedNumbers(parameters, plan);
    const double widthM = plan != nullptr ? plan->request.machine.operatingWidth().si() : widthM_;
    if (parameters == parameters_ && settings == settings_ && used == used_ && widthM == widthM_) {
        return;
    }
    settings_ = settings;
    used_ = std::move(used);
    widthM_ = widthM;
    showRows(parameters);
    refresh();
}

/// Rows that stay keep their fields, and those the keyboard.
void ParameterModel::showRows(const std::vector<const Parameter*>& parameters) {
    for (int row = rowCount() - 1; row >= 0; --row) {
        if (std::ranges::find(parameters, &at(row)) == parameters.end()) {
            beginRemoveRows({}, row, row);
            parameters_.erase(parameters_.begin() + row);
            endRemoveRows();
        }
    }
    for (int row = 0; row < static_cast<int>(parameters.size()); ++row) {
        const Parameter* const wanted = parameters[static_cast<std::size_t>(row)];
        const auto here = std::ranges::find(parameters_, wanted);
        const auto before = static_cast<int>(here - parameters_.begin());
        if (here == parameters_.end()) {
            beginInsertRows({}, row, row);
            parameters_.insert(parameters_.begin() + row, wanted);
            endInsertRows();
        } else if (before != row) {
            beginMoveRows({}, before, before, {}, row);
            std::rotate(parameters_.begin() + row, here, here + 1);
            endMoveRows();
        }
    }
}

void ParameterModel::refresh() {
    if (!parameters_.empty()) {
        emit dataChanged(index(0), index(rowCount() - 1));
    }
}

int ParameterModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(parameters_.size());
}

QVariant ParameterModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    return value(at(index.row()), role);
}

QVariant ParameterModel::value(const Parameter& parameter, int role) const {
    const SettingValue set = settings_.value(parameter);
    const bool automatic = std::holds_alternative<Auto>(set);
    const auto used = used_.find(parameter.key);
    const bool isNumber = kindOf(parameter) == Kind::Number || kindOf(parameter) == Kind::Direction;
    switch (role) {
        case KeyRole: return fromStd(parameter.key);
        case NameRole: return shown(parameter.name);
        case DescriptionRole: return shown(parameter.description);
        case KindRole: return static_cast<int>(kindOf(parameter));
        case ValueRole: {
            if (!isNumber) {
                return 0.0;
            }
            const double number =
                automatic ? (used == used_.end() ? 0.0 : used->second) : std::get<double>(set);
            return isDirection(parameter) ? turnedDeg(number) : number;
        }
        case AutoTextRole:
            if (!automatic) {
                return QString{};
            }
            return used == used_.end() ? tr("auto")
                                       : tr("auto · %1")
                                             .arg(QuantityText{}.text(used->second, quantityOf(parameter),
                                                                      decimalsOf(parameter)));
        case CanBeAutoRole: return parameter.canBeAuto;
        case QuantityRole: return quantityOf(parameter);
        case FromRole: return isDirection(parameter) ? 0.0 : parameter.min;
        case ToRole: return isDirection(parameter) ? 180.0 : parameter.max;
        case StepRole: return parameter.step;
        case DecimalsRole: return decimalsOf(parameter);
        case SliderToRole: {
            // A width is found by looking at the map; other lengths are known as numbers.
            const bool wide = parameter.kind == ParameterKind::Length && parameter.max >= 100.0;
            return wide ? std::clamp(std::ceil(widthM_ * 8.0 / 10.0) * 10.0, 20.0, parameter.max) : 0.0;
        }
        case ChoicesRole: {
            QStringList names;
            std::ranges::transform(parameter.choices, std::back_inserter(names),
                                   [](const Choice& choice) { return shown(choice.name); });
            return names;
        }
        case ChoiceIndexRole:
            return kindOf(parameter) == Kind::Choice ? static_cast<int>(choiceIndex(parameter, settings_))
                                                     : -1;
        case ChoiceHintRole:
            return kindOf(parameter) == Kind::Choice
                       ? shown(parameter.choices[choiceIndex(parameter, settings_)].description)
                       : QString{};
        case CheckedRole: return kindOf(parameter) == Kind::Flag && settings_.flag(parameter);
        case TextRole: return kindOf(parameter) == Kind::Text ? fromStd(settingText(set)) : QString{};
        case PickedRole:
            return kindOf(parameter) == Kind::Text ? pickedText(parameter.kind, settingText(set)) : QString{};
        case PickRole: return static_cast<int>(pickOf(parameter));
        default: return {};
    }
}

QHash<int, QByteArray> ParameterModel::roleNames() const {
    return {{KeyRole, "key"},
            {NameRole, "name"},
            {DescriptionRole, "description"},
            {KindRole, "kind"},
            {PickRole, "picking"},
            {PickedRole, "picked"},
            {ValueRole, "value"},
            {AutoTextRole, "autoText"},
            {CanBeAutoRole, "canBeAuto"},
            {QuantityRole, "quantity"},
            {FromRole, "from"},
            {ToRole, "to"},
            {StepRole, "step"},
            {DecimalsRole, "decimals"},
            {SliderToRole, "sliderTo"},
            {ChoicesRole, "choices"},
            {ChoiceIndexRole, "choiceIndex"},
            {ChoiceHintRole, "choiceHint"},
            {CheckedRole, "checked"},
            {TextRole, "text"}};
}

void ParameterModel::setNumber(int row, double value, bool live) {
    if (row >= 0 && row < rowCount()) {
        emit changeRequested(&at(row), SettingValue{isDirection(at(row)) ? turnedDeg(value) : value}, live);
    }
}

void ParameterModel::setAuto(int row) {
    if (row >= 0 && row < rowCount()) {
        emit changeRequested(&at(row), at(row).canBeAuto ? SettingValue{Auto{}} : at(row).defaultValue(),
                             false);
    }
}

void ParameterModel::setChoice(int row, int choice) {
    if (row >= 0 && row < rowCount() && choice >= 0 && choice < static_cast<int>(at(row).choices.size())) {
        emit changeRequested(
            &at(row), SettingValue{std::string{at(row).choices[static_cast<std::size_t>(choice)].id}}, false);
    }
}

bool ParameterModel::accepts(int row, const QString& text) const {
    Settings trial;
    return row >= 0 && row < rowCount() && trial.setText(at(row), text.trimmed().toStdString()).has_value();
}

void ParameterModel::setText(int row, const QString& text) {
    if (accepts(row, text)) {
        emit changeRequested(&at(row), SettingValue{text.trimmed().toStdString()}, false);
    }
}

void ParameterModel::setFlag(int row, bool on) {
    if (row >= 0 && row < rowCount()) {
        emit changeRequested(&at(row), SettingValue{on}, false);
    }
}

ParameterModel::Pick ParameterModel::pickOf(const Parameter& parameter) const {
    switch (parameter.kind) {
        case ParameterKind::Place: return Pick::Place;
        case ParameterKind::Places: return Pick::Places;
        case ParameterKind::Lines: return Pick::Split;
        case ParameterKind::File: return Pick::File;
        case ParameterKind::Line: {
            // Of a pivot the centre is wanted, of A+ its point.
            const auto method = findParameter("swaths.method");
            const std::string chosen = method ? settings_.choice(**method) : std::string{};
            return chosen == "pivot" || chosen == "a-plus" ? Pick::Place : Pick::Line;
        }
        default: return Pick::None;
    }
}

void ParameterModel::pick(int row) {
    if (row >= 0 && row < rowCount()) {
        emit pickRequested(fromStd(at(row).key), static_cast<int>(pickOf(at(row))));
    }
}

}  // namespace furrow
