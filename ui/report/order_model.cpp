#include "ui/report/order_model.h"

#include "planner/project/project_edits.h"
#include "planner/units/unit_system.h"
#include "ui/pages/order_layout.h"
#include "ui/text/display.h"
#include "ui/text/number_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/unit_text.h"

#include <array>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

constexpr double kSecondsPerHour = 3600.0;

enum class Amount { None, Rate, Area, Hours };

struct Line {
    const char* key;
    const char* name;
    std::string WorkOrder::* text = nullptr;
    Amount amount = Amount::None;
    bool half = false;  ///< of the width
};

constexpr std::array kLines{
    Line{"number", QT_TRANSLATE_NOOP("furrow::OrderModel", "Order number"), &WorkOrder::number, Amount::None,
         true},
    Line{"customer", QT_TRANSLATE_NOOP("furrow::OrderModel", "Customer"), &WorkOrder::customer},
    Line{"address", QT_TRANSLATE_NOOP("furrow::OrderModel", "Field address"), &WorkOrder::address},
    Line{"operator", QT_TRANSLATE_NOOP("furrow::OrderModel", "Operator"), &WorkOrder::operatorName,
         Amount::None, true},
    Line{"time_window", QT_TRANSLATE_NOOP("furrow::OrderModel", "Time"), &WorkOrder::timeWindow, Amount::None,
         true},
    Line{"product", QT_TRANSLATE_NOOP("furrow::OrderModel", "Product"), &WorkOrder::product},
    Line{"rate", QT_TRANSLATE_NOOP("furrow::OrderModel", "Rate"), nullptr, Amount::Rate, true},
    Line{"rate_unit", QT_TRANSLATE_NOOP("furrow::OrderModel", "Unit of the rate"), &WorkOrder::rateUnit,
         Amount::None, true},
    Line{"actual_area", QT_TRANSLATE_NOOP("furrow::OrderModel", "Area worked"), nullptr, Amount::Area, true},
    Line{"actual_time", QT_TRANSLATE_NOOP("furrow::OrderModel", "Hours worked"), nullptr, Amount::Hours,
         true},
    Line{"remark", QT_TRANSLATE_NOOP("furrow::OrderModel", "Remarks"), &WorkOrder::remark}};

/// Rates are for an acre where areas are in acres.
double hectaresOfUnit() {
    return Display::instance().isImperial() ? kAcreM2 / kHectareM2 : 1.0;
}

QString nameOf(const Line& line) {
    QString name = OrderModel::tr(line.name);
    const bool acres = Display::instance().isImperial();
    switch (line.amount) {
        case Amount::Rate:
            return (acres ? OrderModel::tr("%1 per acre") : OrderModel::tr("%1 per hectare")).arg(name);
        case Amount::Area:
            return QStringLiteral("%1 (%2)").arg(name,
                                                 Display::instance().quantities()->unit(QuantityText::Area));
        case Amount::None:
        case Amount::Hours: break;
    }
    return name;
}

QString textOf(const WorkOrder& order, const Line& line) {
    switch (line.amount) {
        case Amount::None: return fromStd(order.*line.text);
        case Amount::Rate:
            return order.ratePerHectare ? shortNumberText(*order.ratePerHectare * hectaresOfUnit(), 3)
                                        : QString{};
        case Amount::Area:
            return order.actualArea
                       ? Display::instance().quantities()->text(order.actualArea->si(), QuantityText::Area, 2)
                       : QString{};
        case Amount::Hours: break;
    }
    return order.actualTime ? shortNumberText(order.actualTime->si() / kSecondsPerHour, 2) : QString{};
}

/// In the unit of the order. Empty where the text is no such amount.
std::optional<double> amountIn(const Line& line, const QString& text) {
    const auto number =
        line.amount == Amount::Area ? QuantityText::parsed(text, QuantityText::Area) : parsedNumber(text);
    if (!number || !std::isfinite(*number) || *number < 0.0) {
        return std::nullopt;
    }
    return *number * (line.amount == Amount::Rate    ? 1.0 / hectaresOfUnit()
                      : line.amount == Amount::Hours ? kSecondsPerHour
                                                     : 1.0);
}

void setAmount(WorkOrder& order, const Line& line, std::optional<double> amount) {
    switch (line.amount) {
        case Amount::None: break;
        case Amount::Rate: order.ratePerHectare = amount; break;
        case Amount::Area:
            order.actualArea = amount.transform([](double si) { return Area::fromSi(si); });
            break;
        case Amount::Hours:
            order.actualTime = amount.transform([](double si) { return Duration::fromSi(si); });
            break;
    }
}

const Line& lineAt(int row) {
    return kLines[static_cast<std::size_t>(row)];
}

}  // namespace

OrderModel::OrderModel(Document& document, QObject* parent)
    : QAbstractListModel{parent}, document_{document}, shown_{order()} {
    connect(&document_, &Document::projectChanged, this, &OrderModel::follow);
    connect(&Display::instance(), &Display::changed, this, [this] {
        emit dataChanged(index(0), index(rowCount() - 1));
        emit changed();
    });
}

void OrderModel::follow() {
    if (order() == shown_) {
        return;
    }
    shown_ = order();
    emit dataChanged(index(0), index(rowCount() - 1), {TextRole});
    emit changed();
}

void OrderModel::change(WorkOrder order, const char* what) {
    // What is typed once more in the same line is one change.
    document_.change([] { return tr("Change the work order"); },
                     withWorkOrder(*document_.project(), std::move(order)),
                     QStringLiteral("workOrder.%1").arg(QLatin1String{what}));
}

void OrderModel::setStatus(int status) {
    if (status == this->status() || status < 0 || status > static_cast<int>(WorkOrderStatus::Done)) {
        return;
    }
    WorkOrder next = order();
    next.status = static_cast<WorkOrderStatus>(status);
    change(std::move(next), "status");
}

QStringList OrderModel::statusNames() const {
    return {statusText(WorkOrderStatus::Draft), statusText(WorkOrderStatus::Issued),
            statusText(WorkOrderStatus::InProgress), statusText(WorkOrderStatus::Done)};
}

int OrderModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(kLines.size());
}

QVariant OrderModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Line& line = lineAt(index.row());
    switch (role) {
        case KeyRole: return QString::fromLatin1(line.key);
        case Qt::DisplayRole:
        case NameRole: return nameOf(line);
        case TextRole: return textOf(shown_, line);
        case HalfRole: return line.half;
        default: return {};
    }
}

QHash<int, QByteArray> OrderModel::roleNames() const {
    return {{KeyRole, "key"}, {NameRole, "name"}, {TextRole, "text"}, {HalfRole, "half"}};
}

bool OrderModel::accepts(int row, const QString& text) const {
    return row < 0 || row >= rowCount() || lineAt(row).amount == Amount::None || text.trimmed().isEmpty() ||
           amountIn(lineAt(row), text).has_value();
}

void OrderModel::setText(int row, const QString& text) {
    if (row < 0 || row >= rowCount() || !accepts(row, text)) {
        return;
    }
    const Line& line = lineAt(row);
    WorkOrder next = order();
    if (line.amount == Amount::None) {
        next.*line.text = text.trimmed().toStdString();
    } else {
        setAmount(next, line, amountIn(line, text));
    }
    if (next != order()) {
        change(std::move(next), line.key);
    }
}

}  // namespace furrow
