#include "ui/pages/order_layout.h"

#include "planner/plan/shown_value.h"
#include "planner/settings/operation.h"
#include "planner/units/unit_system.h"
#include "ui/pages/order_lists.h"
#include "ui/pages/qr_code.h"
#include "ui/pages/sheet_map.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/unit_text.h"

#include <QLocale>

#include <algorithm>
#include <array>

namespace furrow {

namespace {

const TextLook kValue{.points = 9.0, .weight = QFont::Medium, .colour = ink::kText};

constexpr double kQr = 24.0;

QString operationName(const std::string& id) {
    const auto choice = std::ranges::find(kOperationKind.choices, id, &Choice::id);
    return choice == kOperationKind.choices.end() ? fromStd(id) : shown(choice->name);
}

/// Of a stage's setting that picks its method, the method.
QString settingValue(const SheetSetting& setting) {
    if (setting.parameter->kind == ParameterKind::Angle) {
        if (const auto* degrees = std::get_if<double>(&setting.value)) {
            return OrderWords::tr("%1°").arg(numberText(*degrees, 1));
        }
    }
    // Names of gates can be read, coordinates cannot.
    const bool isDrawn = setting.parameter->kind == ParameterKind::Places
                             ? settingText(setting.value).contains('(')
                             : setting.parameter->kind == ParameterKind::Line ||
                                   setting.parameter->kind == ParameterKind::Lines;
    if (isDrawn) {
        return OrderWords::tr("as drawn");
    }
    return sentence(shownValue(*setting.parameter, setting.value));
}

QString percentOrDash(const std::optional<double>& share, int decimals) {
    return share ? percentText(*share, decimals) : QStringLiteral("–");
}

/// To be filled in by hand.
void drawBlank(Canvas& canvas, double x, double base, double width) {
    canvas.line({x, base + 0.6}, {x + width, base + 0.6}, ink::kQuiet, 0.2);
}

/// A label with what was said, or a line to write on.
void drawField(Canvas& canvas, const QRectF& box, const QString& label, const QString& value) {
    canvas.text({box.left(), box.top() + 2.8}, label, kLabel);
    if (value.isEmpty()) {
        drawBlank(canvas, box.left(), box.top() + 8.0, box.width());
        return;
    }
    double base = box.top() + 6.9;
    QStringList lines = wrappedLines(value, box.width(), kValue);
    const auto most = static_cast<qsizetype>((box.height() - 3.5) / lineHeightMm(kValue));
    if (lines.size() > most) {
        lines = lines.mid(0, most);
        lines.last() = elided(lines.last() + QStringLiteral(" …"), box.width(), kValue);
    }
    for (const QString& line : std::as_const(lines)) {
        canvas.text({box.left(), base}, line, kValue);
        base += lineHeightMm(kValue);
    }
}

}  // namespace

QString statusText(WorkOrderStatus status) {
    switch (status) {
        case WorkOrderStatus::Draft: return OrderWords::tr("Draft", "work order");
        case WorkOrderStatus::Issued: return OrderWords::tr("Issued", "work order");
        case WorkOrderStatus::InProgress: return OrderWords::tr("In progress", "work order");
        case WorkOrderStatus::Done: break;
    }
    return OrderWords::tr("Done", "work order");
}

QString problemText(const OrderSheet& sheet) {
    const auto problems = static_cast<int>(sheet.blockingCount());
    return problems == 0 ? QString{} : OrderWords::tr("Not drivable: %n problem(s)", nullptr, problems);
}

OrderLayout::OrderLayout(const OrderedPlan& plan, const QString& farm, PageFlow& flow)
    : plan_{plan}, sheet_{*plan.sheet}, farm_{farm}, flow_{flow} {}

void OrderLayout::lay() {
    flow_.newPage();
    layHead();
    layOrder();
    layBanner();
    layMap();
    layFigures();
    flow_.newPage();
    layFacts();
    layRecord();
    OrderLists{plan_, flow_}.lay();
    layHash();
}

void OrderLayout::layHead() {
    const QRectF box = flow_.take(19.0);
    const double textWidth = flow_.width() - kQr - 4.0;
    const QString title = plan_.order.number.empty()
                              ? OrderWords::tr("Work order")
                              : OrderWords::tr("Work order %1").arg(fromStd(plan_.order.number));
    QStringList under;
    for (const QString& part :
         {plan_.planName, plan_.season, operationName(sheet_.operation), shown(sheet_.machine.name()),
          shortLengthText(sheet_.machine.operatingWidth()), farm_}) {
        if (!part.isEmpty()) {
            under << part;
        }
    }
    const QString status = statusText(plan_.order.status);
    flow_.draw([=, field = fromStd(sheet_.fieldName), joined = inOneLine(under)](Canvas& canvas) {
        const TextLook small{.points = 10.0, .weight = QFont::DemiBold, .colour = ink::kAccent};
        const TextLook pill{.points = 8.0, .weight = QFont::DemiBold, .colour = ink::kAccent};
        const double pillWidth = textWidthMm(status, pill) + 5.0;
        const QString head = elided(title, textWidth - pillWidth - 4.0, small);
        canvas.text(box.topLeft() + QPointF{0.0, 3.6}, head, small);
        const double x = box.left() + textWidthMm(head, small) + 4.0;
        canvas.rectangle({x, box.top() - 0.2, pillWidth, 5.0}, Qt::white, ink::kAccent, 0.25, 2.5);
        canvas.text({x + 0.5 * pillWidth, box.top() + 3.25}, status, pill, Qt::AlignHCenter);
        canvas.text(box.topLeft() + QPointF{0.0, 11.8}, elided(field, textWidth, kTitle), kTitle);
        const TextLook line{.points = 10.0, .weight = QFont::Normal, .colour = ink::kQuiet};
        canvas.text(box.topLeft() + QPointF{0.0, 17.4}, elided(joined, textWidth, line), line);
    });
}

QString OrderLayout::rateText() const {
    if (!plan_.order.ratePerHectare) {
        return {};
    }
    const bool acres = Display::instance().isImperial();
    const double rate = *plan_.order.ratePerHectare * (acres ? kAcreM2 / kHectareM2 : 1.0);
    const QString amount =
        QStringLiteral("%1 %2").arg(shortNumberText(rate, 2), fromStd(plan_.order.rateUnit));
    return (acres ? OrderWords::tr("%1/ac") : OrderWords::tr("%1/ha")).arg(amount.trimmed());
}

QString OrderLayout::totalText() const {
    const auto total =
        sheet_.figures.covered ? totalAmount(plan_.order, *sheet_.figures.covered) : std::nullopt;
    return total ? QStringLiteral("%1 %2")
                       .arg(numberText(*total, *total < 100.0 ? 1 : 0), fromStd(plan_.order.rateUnit))
                       .trimmed()
                 : QString{};
}

void OrderLayout::layOrder() {
    // Customer and address are long.
    constexpr double kFirstRow = 16.5;
    constexpr double kSecondRow = 13.0;
    const QRectF box = flow_.take(kFirstRow + kSecondRow + 2.0);
    const double textWidth = flow_.width() - kQr - 8.0;
    const double column = textWidth / 3.0;
    const QString rate = rateText();
    const QString total = totalText();
    const std::array<Row, 6> fields{
        Row{OrderWords::tr("Customer"), fromStd(plan_.order.customer)},
        Row{OrderWords::tr("Field address"), fromStd(plan_.order.address)},
        Row{OrderWords::tr("Operator"), fromStd(plan_.order.operatorName)},
        Row{OrderWords::tr("Time"), fromStd(plan_.order.timeWindow)},
        Row{OrderWords::tr("Product"), fromStd(plan_.order.product)},
        Row{OrderWords::tr("Rate and total"),
            total.isEmpty() ? rate : OrderWords::tr("%1 = %2", "rate and total").arg(rate, total)}};
    flow_.draw([=](Canvas& canvas) {
        canvas.line(box.topLeft() + QPointF{0.0, 0.4}, box.topLeft() + QPointF{textWidth + 4.0, 0.4},
                    ink::kLine);
        for (std::size_t i = 0; i < fields.size(); ++i) {
            const bool first = i < 3;
            const QRectF cell{box.left() + static_cast<double>(i % 3) * column,
                              box.top() + 1.2 + (first ? 0.0 : kFirstRow), column - 4.0,
                              first ? kFirstRow : kSecondRow};
            drawField(canvas, cell, fields[i].name, fields[i].value);
        }
    });
    const GeoPoint meeting = meetingPlace(sheet_);
    const QString geo =
        QStringLiteral("geo:%1,%2").arg(meeting.latDeg, 0, 'f', 6).arg(meeting.lonDeg, 0, 'f', 6);
    const QString caption =
        sheet_.gates.empty() ? OrderWords::tr("Where the work starts") : OrderWords::tr("Gate");
    const QRectF code{flow_.left() + flow_.width() - kQr, PageFlow::kMargin, kQr, kQr};
    flow_.draw([=, place = placeText(meeting)](Canvas& canvas) {
        drawQrCode(canvas, code, geo);
        const TextLook small{.points = 6.5, .weight = QFont::Normal, .colour = ink::kText};
        const TextLook quiet{.points = 6.5, .weight = QFont::Normal, .colour = ink::kQuiet};
        double base = code.bottom() + 3.2;
        for (const QString& line : wrappedLines(caption, kQr, quiet)) {
            canvas.text({code.right(), base}, line, quiet, Qt::AlignRight);
            base += 2.9;
        }
        const QStringList numbers = place.split(QStringLiteral(", "));
        canvas.text({code.right(), base}, numbers[0] + QLatin1Char(','), small, Qt::AlignRight);
        canvas.text({code.right(), base + 2.9}, numbers[1], small, Qt::AlignRight);
    });
}

void OrderLayout::layBanner() {
    const QString problem = problemText(sheet_);
    if (problem.isEmpty()) {
        return;
    }
    const QRectF box = flow_.take(10.0);
    flow_.draw([=](Canvas& canvas) {
        canvas.rectangle(box.adjusted(0.0, 0.0, 0.0, -2.0), ink::kFailureGround, ink::kFailure, 0.4);
        canvas.text(box.topLeft() + QPointF{4.0, 5.4}, problem,
                    {.points = 11.0, .weight = QFont::DemiBold, .colour = ink::kFailure});
    });
}

void OrderLayout::layMap() {
    constexpr double kFiguresBelow = 25.0;
    const QRectF box = flow_.take(flow_.rest() - kFiguresBelow);
    const auto map = std::make_shared<const SheetMap>(sheet_, plan_.comments, box);
    flow_.draw([map](Canvas& canvas) { map->draw(canvas); });
}

std::vector<OrderLayout::Row> OrderLayout::figureRows() const {
    const SheetFigures& figures = sheet_.figures;
    const double working = figures.path.si() > 0.0 ? figures.working / figures.path : 0.0;
    const QString dash = QStringLiteral("–");
    return {
        {OrderWords::tr("Area"), areaText(figures.field)},
        {OrderWords::tr("Time"), durationText(figures.time)},
        {OrderWords::tr("Driven"), lengthText(figures.path)},
        {OrderWords::tr("Working"), inOneLine({lengthText(figures.working), percentText(working)})},
        {OrderWords::tr("Turning"),
         inOneLine({lengthText(figures.path - figures.working), percentText(1.0 - working)})},
        {OrderWords::tr("Covered"), percentOrDash(figures.coveredShare, 1)},
        {OrderWords::tr("Worked twice"), percentOrDash(figures.overlapShare, 1)},
        {OrderWords::tr("Outside the field"), figures.outside ? squareMetresText(*figures.outside, 0) : dash},
        {OrderWords::tr("Fuel"),
         figures.fuelLitres ? OrderWords::tr("%1 l").arg(numberText(*figures.fuelLitres, 0)) : dash},
        {OrderWords::tr("Above the best order"), percentOrDash(figures.gap, 1)},
    };
}

void OrderLayout::layFigures() {
    flow_.skip(2.5);
    const QRectF box = flow_.take(22.5);
    flow_.draw([box, rows = figureRows()](Canvas& canvas) {
        constexpr std::size_t kColumns = 5;
        const double width = box.width() / kColumns;
        const double height = 11.0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::size_t column = i % kColumns;
            const std::size_t row = i / kColumns;
            const QPointF at{box.left() + static_cast<double>(column) * width,
                             box.top() + static_cast<double>(row) * height};
            canvas.text(at + QPointF{0.0, 3.0}, elided(rows[i].name, width - 2.0, kLabel), kLabel);
            const TextLook figure{.points = 10.5, .weight = QFont::DemiBold, .colour = ink::kText};
            canvas.text(at + QPointF{0.0, 7.9}, elided(rows[i].value, width - 1.0, figure), figure);
        }
    });
}

std::vector<OrderLayout::Row> OrderLayout::machineRows() const {
    const Machine& machine = sheet_.machine;
    const MachineSpec& spec = machine.spec();
    std::vector<Row> rows{{OrderWords::tr("Machine"), shown(machine.name())},
                          {OrderWords::tr("Working width"), shortLengthText(machine.operatingWidth())},
                          {OrderWords::tr("Width in turns"), shortLengthText(machine.turningWidth())},
                          {OrderWords::tr("Turning radius"), metresText(machine.minTurningRadius(), 1)},
                          {OrderWords::tr("Speed at work"), speedText(spec.tractor.workingSpeed)},
                          {OrderWords::tr("Speed in turns"), speedText(spec.tractor.turningSpeed)},
                          {OrderWords::tr("Implement"), spec.implement.mounting == Mounting::Trailed
                                                            ? OrderWords::tr("trailed")
                                                            : OrderWords::tr("mounted")}};
    if (spec.tank) {
        // Its unit is the user's own: litres, kilograms, seeds. What it is enough for needs none.
        const QString land = spec.tank->ratePerM2 > 0.0
                                 ? areaText(squareMetres(spec.tank->capacity / spec.tank->ratePerM2))
                                 : QString{};
        rows.push_back({OrderWords::tr("Tank"), land.isEmpty() ? numberText(spec.tank->capacity, 0)
                                                : operationOf(sheet_.operation).tank == TankUse::Fills
                                                    ? OrderWords::tr("full after %1").arg(land)
                                                    : OrderWords::tr("enough for %1").arg(land)});
    }
    return rows;
}

std::vector<OrderLayout::Row> OrderLayout::planRows() const {
    const SheetFigures& figures = sheet_.figures;
    const QString headland = figures.headlandPasses > 0
                                 ? inOneLine({OrderWords::tr("%n pass(es)", nullptr, figures.headlandPasses),
                                              metresText(figures.headlandWidth, 1)})
                                 : OrderWords::tr("none", "headland");
    std::vector<Row> rows{{OrderWords::tr("Operation"), operationName(sheet_.operation)},
                          {OrderWords::tr("Headland"), headland},
                          {OrderWords::tr("Swaths"), numberText(figures.swaths, 0)},
                          {OrderWords::tr("Kept free at the edge"), shortLengthText(figures.margin)}};
    if (figures.refills > 0) {
        const bool unloads = operationOf(sheet_.operation).tank == TankUse::Fills;
        rows.push_back({unloads ? OrderWords::tr("Unloadings") : OrderWords::tr("Refills"),
                        inOneLine({numberText(figures.refills, 0), lengthText(figures.refillWay)})});
    }
    for (const SheetSetting& setting : sheet_.settings) {
        rows.push_back({settingName(*setting.parameter), settingValue(setting)});
    }
    return rows;
}

void OrderLayout::rowsSideBySide(const QString& leftTitle, const std::vector<Row>& left,
                                 const QString& rightTitle, const std::vector<Row>& right) {
    constexpr double kGap = 8.0;
    const double width = 0.5 * (flow_.width() - kGap);
    const auto lay = [&](const QString& title, const std::vector<Row>& rows, double x, double top) {
        flow_.draw([=](Canvas& canvas) {
            canvas.text({x, top + 5.0}, title, kHeading);
            canvas.line({x, top + 6.6}, {x + width, top + 6.6}, ink::kLine);
        });
        double y = top + 8.0;
        for (const Row& row : rows) {
            const QStringList names = wrappedLines(row.name, 0.52 * width, kBody);
            const QStringList values = wrappedLines(row.value, 0.45 * width, kBody);
            flow_.draw([=](Canvas& canvas) {
                TextLook quiet = kBody;
                quiet.colour = ink::kQuiet;
                for (qsizetype i = 0; i < names.size(); ++i) {
                    canvas.text({x, y + 3.4 + static_cast<double>(i) * lineHeightMm(kBody)}, names[i], quiet);
                }
                for (qsizetype i = 0; i < values.size(); ++i) {
                    canvas.text({x + width, y + 3.4 + static_cast<double>(i) * lineHeightMm(kBody)},
                                values[i], kBody, Qt::AlignRight);
                }
            });
            y += 1.0 + lineHeightMm(kBody) *
                           static_cast<double>(std::max({qsizetype{1}, names.size(), values.size()}));
        }
        return y;
    };
    const double top = flow_.y();
    const double one = lay(leftTitle, left, flow_.left(), top);
    const double two = lay(rightTitle, right, flow_.left() + width + kGap, top);
    flow_.skip(std::max(one, two) - top);
}

void OrderLayout::layFacts() {
    // A list that is longer than a page would have to be made by hand.
    constexpr std::size_t kMostRows = 40;
    std::vector<Row> rows = planRows();
    rows.resize(std::min(rows.size(), kMostRows));
    rowsSideBySide(OrderWords::tr("Machine"), machineRows(), OrderWords::tr("Plan and settings"), rows);
}

void OrderLayout::layRecord() {
    layHeading(flow_, OrderWords::tr("What was done"), 46.0);
    constexpr double kHeight = 44.0;
    const QRectF box = flow_.take(kHeight);
    const QString area = plan_.order.actualArea ? hectaresText(*plan_.order.actualArea, 2) : QString{};
    const QString time = plan_.order.actualTime ? durationText(*plan_.order.actualTime) : QString{};
    const QString areaLabel =
        Display::instance().isImperial() ? OrderWords::tr("Acres worked") : OrderWords::tr("Hectares worked");
    flow_.draw([=, status = plan_.order.status, remark = fromStd(plan_.order.remark)](Canvas& canvas) {
        const double column = box.width() / 4.0;
        const auto cell = [&](int index, int row, int span = 1) {
            return QRectF{box.left() + index * column, box.top() + 7.0 + row * 12.5, span * column - 4.0,
                          12.5};
        };
        double x = box.left();
        for (const WorkOrderStatus each : {WorkOrderStatus::Draft, WorkOrderStatus::Issued,
                                           WorkOrderStatus::InProgress, WorkOrderStatus::Done}) {
            canvas.rectangle({x, box.top() + 0.6, 3.2, 3.2}, Qt::white, ink::kText, 0.25);
            if (each == status) {
                canvas.line({x + 0.6, box.top() + 1.2}, {x + 2.6, box.top() + 3.2}, ink::kText, 0.4);
                canvas.line({x + 2.6, box.top() + 1.2}, {x + 0.6, box.top() + 3.2}, ink::kText, 0.4);
            }
            canvas.text({x + 4.6, box.top() + 3.3}, statusText(each), kBody);
            x += 4.6 + textWidthMm(statusText(each), kBody) + 7.0;
        }
        drawField(canvas, cell(0, 0), areaLabel, area);
        drawField(canvas, cell(1, 0), OrderWords::tr("Hours"), time);
        drawField(canvas, cell(2, 0), OrderWords::tr("Begin"), {});
        drawField(canvas, cell(3, 0), OrderWords::tr("End", "of the work"), {});
        drawField(canvas, cell(0, 1), OrderWords::tr("Wind"), {});
        drawField(canvas, cell(1, 1), OrderWords::tr("Temperature"), {});
        drawField(canvas, cell(2, 1, 2), OrderWords::tr("Remarks"), remark);
        drawField(canvas, cell(0, 2, 2), OrderWords::tr("Date"), {});
        drawField(canvas, cell(2, 2, 2), OrderWords::tr("Signature"), {});
    });
}

void OrderLayout::layHash() {
    flow_.skip(3.0);
    flow_.need(9.0);
    const QRectF box = flow_.take(9.0);
    flow_.draw([box, hash = plan_.hash](Canvas& canvas) {
        canvas.text(
            box.topLeft() + QPointF{0.0, 3.0},
            OrderWords::tr(
                "This plan's path.csv has the SHA-256 sum below. A file with another sum is another plan."),
            kLabel);
        canvas.text(box.topLeft() + QPointF{0.0, 7.2}, hash,
                    {.points = 8.0, .weight = QFont::Medium, .colour = ink::kText});
    });
}

}  // namespace furrow
