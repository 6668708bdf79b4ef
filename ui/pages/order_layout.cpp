#include "ui/pages/order_layout.h"

#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/shown_value.h"
#include "planner/settings/operation.h"
#include "planner/units/unit_system.h"
#include "ui/pages/qr_code.h"
#include "ui/pages/sheet_map.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow {

namespace {

struct LayoutWords {
    Q_DECLARE_TR_FUNCTIONS(WorkOrderPages)
};

const TextLook kValue{.points = 9.0, .weight = QFont::Medium, .colour = ink::kText};
const TextLook kHeading{.points = 11.0, .weight = QFont::DemiBold, .colour = ink::kText};

constexpr double kQr = 24.0;
constexpr std::size_t kMostFindings = 40;

/// Of a method, where the turn is one alone.
QString turnName(const std::string& id) {
    for (const StageInfo& stage : stages()) {
        const auto method = std::ranges::find(stage.methods, id, &MethodInfo::id);
        if (stage.id == "path" && method != stage.methods.end()) {
            return shown(method->name);
        }
    }
    return LayoutWords::tr("Several moves");
}

QString operationName(const std::string& id) {
    const auto choice = std::ranges::find(kOperationKind.choices, id, &Choice::id);
    return choice == kOperationKind.choices.end() ? fromStd(id) : shown(choice->name);
}

/// Of a stage's setting that picks its method, the method.
QString settingValue(const SheetSetting& setting) {
    if (setting.parameter->kind == ParameterKind::Angle) {
        if (const auto* degrees = std::get_if<double>(&setting.value)) {
            return LayoutWords::tr("%1°").arg(numberText(*degrees, 1));
        }
    }
    // Names of gates can be read, coordinates cannot.
    const bool isDrawn = setting.parameter->kind == ParameterKind::Places
                             ? settingText(setting.value).contains('(')
                             : setting.parameter->kind == ParameterKind::Line ||
                                   setting.parameter->kind == ParameterKind::Lines;
    if (isDrawn) {
        return LayoutWords::tr("as drawn");
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
        case WorkOrderStatus::Draft: return LayoutWords::tr("Draft", "work order");
        case WorkOrderStatus::Issued: return LayoutWords::tr("Issued", "work order");
        case WorkOrderStatus::InProgress: return LayoutWords::tr("In progress", "work order");
        case WorkOrderStatus::Done: break;
    }
    return LayoutWords::tr("Done", "work order");
}

QString problemText(const OrderSheet& sheet) {
    const auto problems = static_cast<int>(sheet.blockingCount());
    return problems == 0 ? QString{} : LayoutWords::tr("Not drivable: %n problem(s)", nullptr, problems);
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
    layFindings();
    layComments();
    layTurns();
    layPasses();
    layHash();
}

void OrderLayout::layHead() {
    const QRectF box = flow_.take(19.0);
    const double textWidth = flow_.width() - kQr - 4.0;
    const QString title = plan_.order.number.empty()
                              ? LayoutWords::tr("Work order")
                              : LayoutWords::tr("Work order %1").arg(fromStd(plan_.order.number));
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
    return (acres ? LayoutWords::tr("%1/ac") : LayoutWords::tr("%1/ha")).arg(amount.trimmed());
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
        Row{LayoutWords::tr("Customer"), fromStd(plan_.order.customer)},
        Row{LayoutWords::tr("Field address"), fromStd(plan_.order.address)},
        Row{LayoutWords::tr("Operator"), fromStd(plan_.order.operatorName)},
        Row{LayoutWords::tr("Time"), fromStd(plan_.order.timeWindow)},
        Row{LayoutWords::tr("Product"), fromStd(plan_.order.product)},
        Row{LayoutWords::tr("Rate and total"),
            total.isEmpty() ? rate : LayoutWords::tr("%1 = %2", "rate and total").arg(rate, total)}};
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
        sheet_.gates.empty() ? LayoutWords::tr("Where the work starts") : LayoutWords::tr("Gate");
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
        {LayoutWords::tr("Area"), areaText(figures.field)},
        {LayoutWords::tr("Time"), durationText(figures.time)},
        {LayoutWords::tr("Driven"), lengthText(figures.path)},
        {LayoutWords::tr("Working"), inOneLine({lengthText(figures.working), percentText(working)})},
        {LayoutWords::tr("Turning"),
         inOneLine({lengthText(figures.path - figures.working), percentText(1.0 - working)})},
        {LayoutWords::tr("Covered"), percentOrDash(figures.coveredShare, 1)},
        {LayoutWords::tr("Worked twice"), percentOrDash(figures.overlapShare, 1)},
        {LayoutWords::tr("Outside the field"),
         figures.outside ? squareMetresText(*figures.outside, 0) : dash},
        {LayoutWords::tr("Fuel"),
         figures.fuelLitres ? LayoutWords::tr("%1 l").arg(numberText(*figures.fuelLitres, 0)) : dash},
        {LayoutWords::tr("Above the best order"), percentOrDash(figures.gap, 1)},
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

void OrderLayout::heading(const QString& text, double heightBelow) {
    flow_.skip(3.0);
    flow_.need(8.0 + heightBelow);
    const QRectF box = flow_.take(8.0);
    flow_.draw([=](Canvas& canvas) {
        canvas.text(box.topLeft() + QPointF{0.0, 5.0}, text, kHeading);
        canvas.line(box.topLeft() + QPointF{0.0, 6.6}, box.topRight() + QPointF{0.0, 6.6}, ink::kLine);
    });
}

std::vector<OrderLayout::Row> OrderLayout::machineRows() const {
    const Machine& machine = sheet_.machine;
    const MachineSpec& spec = machine.spec();
    std::vector<Row> rows{{LayoutWords::tr("Machine"), shown(machine.name())},
                          {LayoutWords::tr("Working width"), shortLengthText(machine.operatingWidth())},
                          {LayoutWords::tr("Width in turns"), shortLengthText(machine.turningWidth())},
                          {LayoutWords::tr("Turning radius"), metresText(machine.minTurningRadius(), 1)},
                          {LayoutWords::tr("Speed at work"), speedText(spec.tractor.workingSpeed)},
                          {LayoutWords::tr("Speed in turns"), speedText(spec.tractor.turningSpeed)},
                          {LayoutWords::tr("Implement"), spec.implement.mounting == Mounting::Trailed
                                                             ? LayoutWords::tr("trailed")
                                                             : LayoutWords::tr("mounted")}};
    if (spec.tank) {
        // Its unit is the user's own: litres, kilograms, seeds. What it is enough for needs none.
        const QString land = spec.tank->ratePerM2 > 0.0
                                 ? areaText(squareMetres(spec.tank->capacity / spec.tank->ratePerM2))
                                 : QString{};
        rows.push_back({LayoutWords::tr("Tank"), land.isEmpty() ? numberText(spec.tank->capacity, 0)
                                                 : operationOf(sheet_.operation).tank == TankUse::Fills
                                                     ? LayoutWords::tr("full after %1").arg(land)
                                                     : LayoutWords::tr("enough for %1").arg(land)});
    }
    return rows;
}

std::vector<OrderLayout::Row> OrderLayout::planRows() const {
    const SheetFigures& figures = sheet_.figures;
    const QString headland = figures.headlandPasses > 0
                                 ? inOneLine({LayoutWords::tr("%n pass(es)", nullptr, figures.headlandPasses),
                                              metresText(figures.headlandWidth, 1)})
                                 : LayoutWords::tr("none", "headland");
    std::vector<Row> rows{{LayoutWords::tr("Operation"), operationName(sheet_.operation)},
                          {LayoutWords::tr("Headland"), headland},
                          {LayoutWords::tr("Swaths"), numberText(figures.swaths, 0)},
                          {LayoutWords::tr("Kept free at the edge"), shortLengthText(figures.margin)}};
    if (figures.refills > 0) {
        const bool unloads = operationOf(sheet_.operation).tank == TankUse::Fills;
        rows.push_back({unloads ? LayoutWords::tr("Unloadings") : LayoutWords::tr("Refills"),
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
    rowsSideBySide(LayoutWords::tr("Machine"), machineRows(), LayoutWords::tr("Plan and settings"), rows);
}

void OrderLayout::layRecord() {
    heading(LayoutWords::tr("What was done"), 46.0);
    constexpr double kHeight = 44.0;
    const QRectF box = flow_.take(kHeight);
    const QString area = plan_.order.actualArea ? hectaresText(*plan_.order.actualArea, 2) : QString{};
    const QString time = plan_.order.actualTime ? durationText(*plan_.order.actualTime) : QString{};
    const QString areaLabel = Display::instance().isImperial() ? LayoutWords::tr("Acres worked")
                                                               : LayoutWords::tr("Hectares worked");
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
        drawField(canvas, cell(1, 0), LayoutWords::tr("Hours"), time);
        drawField(canvas, cell(2, 0), LayoutWords::tr("Begin"), {});
        drawField(canvas, cell(3, 0), LayoutWords::tr("End", "of the work"), {});
        drawField(canvas, cell(0, 1), LayoutWords::tr("Wind"), {});
        drawField(canvas, cell(1, 1), LayoutWords::tr("Temperature"), {});
        drawField(canvas, cell(2, 1, 2), LayoutWords::tr("Remarks"), remark);
        drawField(canvas, cell(0, 2, 2), LayoutWords::tr("Date"), {});
        drawField(canvas, cell(2, 2, 2), LayoutWords::tr("Signature"), {});
    });
}

namespace {

constexpr double kRemarkIndent = 9.0;
constexpr double kRemarkAside = 38.0;

TextLook quietBody() {
    TextLook look = kBody;
    look.colour = ink::kQuiet;
    return look;
}

}  // namespace

/// A mark that is on the map, what is said there, and something short on the right.
void OrderLayout::layRemark(const QString& mark, const QColor& colour, const std::vector<Paragraph>& text,
                            const QString& aside) {
    std::vector<Paragraph> lines;
    for (const Paragraph& paragraph : text) {
        for (const QString& line :
             wrappedLines(paragraph.text, flow_.width() - kRemarkIndent - kRemarkAside, paragraph.look)) {
            lines.push_back({line, paragraph.look});
        }
    }
    const double height = 1.6 + lineHeightMm(kBody) * static_cast<double>(lines.size());
    flow_.need(height);
    const QRectF box = flow_.take(height);
    const TextLook quiet{.points = 7.5, .weight = QFont::Normal, .colour = ink::kQuiet};
    flow_.draw([=, shortened = elided(aside, kRemarkAside - 2.0, quiet)](Canvas& canvas) {
        canvas.text(box.topLeft() + QPointF{5.5, 3.4}, mark,
                    {.points = 8.5, .weight = QFont::DemiBold, .colour = colour}, Qt::AlignRight);
        double base = box.top() + 3.4;
        for (const Paragraph& line : lines) {
            canvas.text({box.left() + kRemarkIndent, base}, line.text, line.look);
            base += lineHeightMm(kBody);
        }
        canvas.text(box.topRight() + QPointF{0.0, 3.4}, shortened, quiet, Qt::AlignRight);
    });
}

void OrderLayout::layFindings() {
    heading(LayoutWords::tr("Findings"), 10.0);
    if (sheet_.findings.empty()) {
        const QRectF box = flow_.take(5.0);
        flow_.draw([box](Canvas& canvas) {
            canvas.text(box.topLeft() + QPointF{0.0, 3.6},
                        LayoutWords::tr("None: the plan can be driven as drawn."), kBody);
        });
        return;
    }
    const std::size_t count = kMostFindings;
    for (std::size_t i = 0; i < std::min(sheet_.findings.size(), count); ++i) {
        const Finding& finding = sheet_.findings[i];
        const bool blocking = isBlocking(finding);
        TextLook look = kBody;
        look.weight = blocking ? QFont::DemiBold : QFont::Normal;
        layRemark(QString::number(i + 1), blocking ? ink::kFailure : ink::kFinding,
                  {{sentence(finding.text), look}, {sentence(finding.suggestion), quietBody()}},
                  placeText(sheet_.findingPlaces[i]));
    }
    if (sheet_.findings.size() > count) {
        const QRectF box = flow_.take(5.0);
        const QString more = LayoutWords::tr("and %n more, in the window and in summary.json", nullptr,
                                             static_cast<int>(sheet_.findings.size() - count));
        flow_.draw([=](Canvas& canvas) {
            canvas.text(box.topLeft() + QPointF{kRemarkIndent, 3.6}, more, quietBody());
        });
    }
}

void OrderLayout::layComments() {
    if (plan_.comments.empty()) {
        return;
    }
    heading(LayoutWords::tr("Comments"), 10.0);
    for (std::size_t i = 0; i < plan_.comments.size(); ++i) {
        layRemark(commentLetter(i), ink::kText, {{fromStd(plan_.comments[i].text), kBody}},
                  fromStd(plan_.comments[i].author));
    }
}

void OrderLayout::layTurns() {
    if (sheet_.turns.empty()) {
        return;
    }
    QStringList kinds;
    for (const SheetTurns& turns : sheet_.turns) {
        kinds << LayoutWords::tr("%1 × %2", "count and kind of turns")
                     .arg(turns.count)
                     .arg(turnName(turns.type));
    }
    if (sheet_.figures.reverse > metres(0.0)) {
        kinds << LayoutWords::tr("%1 in reverse").arg(lengthText(sheet_.figures.reverse));
    }
    const QStringList lines = wrappedLines(inOneLine(kinds), flow_.width(), kBody);
    heading(LayoutWords::tr("Turns"), lineHeightMm(kBody) * static_cast<double>(lines.size()));
    for (const QString& line : lines) {
        const QRectF box = flow_.take(lineHeightMm(kBody));
        flow_.draw([=](Canvas& canvas) { canvas.text(box.topLeft() + QPointF{0.0, 3.2}, line, kBody); });
    }
}

void OrderLayout::layPasses() {
    constexpr double kRow = 4.1;
    constexpr double kHead = 5.0;
    struct Pass {
        QString number;
        QString name;
        QString length;
        QString bearing;
    };
    std::vector<Pass> passes;
    for (const SheetPass& pass : sheet_.passes) {
        const bool headland = pass.kind == SegmentKind::HeadlandPass;
        passes.push_back({QString::number(passes.size() + 1),
                          headland ? LayoutWords::tr("Headland") + u' ' +
                                         LayoutWords::tr("H%1", "headland pass").arg(pass.number)
                                   : LayoutWords::tr("Swath %1").arg(pass.number),
                          lengthText(pass.length),
                          pass.bearingDeg ? LayoutWords::tr("%1°").arg(
                                                static_cast<int>(std::lround(*pass.bearingDeg)) % 360)
                                          : QString{}});
    }
    constexpr int kColumns = 4;
    constexpr double kBearing = 7.8;
    const TextLook cell{.points = 8.0, .weight = QFont::Normal, .colour = ink::kText};
    const double width = flow_.width() / kColumns;
    heading(LayoutWords::tr("Order of the passes"), kHead + 3.0 * kRow);
    std::size_t next = 0;
    while (next < passes.size()) {
        flow_.need(kHead + kRow);
        const auto most = static_cast<std::size_t>((flow_.rest() - kHead) / kRow);
        const std::size_t left = passes.size() - next;
        const std::size_t rows = std::min(most, (left + kColumns - 1) / kColumns);
        const QRectF box = flow_.take(kHead + static_cast<double>(rows) * kRow);
        for (int column = 0; column < kColumns && next < passes.size(); ++column) {
            const std::size_t end = std::min(passes.size(), next + rows);
            const double x = box.left() + column * width;
            const double inner = width - 3.5;
            flow_.draw([=, part = std::vector<Pass>(passes.begin() + static_cast<std::ptrdiff_t>(next),
                                                    passes.begin() + static_cast<std::ptrdiff_t>(end))](
                           Canvas& canvas) {
                const double top = box.top();
                canvas.text({x + 6.0, top + 3.2}, LayoutWords::tr("No."), kLabel, Qt::AlignRight);
                canvas.text({x + 7.5, top + 3.2}, LayoutWords::tr("Pass"), kLabel);
                canvas.text({x + inner - kBearing, top + 3.2}, LayoutWords::tr("Length"), kLabel,
                            Qt::AlignRight);
                canvas.text({x + inner, top + 3.2}, LayoutWords::tr("To"), kLabel, Qt::AlignRight);
                TextLook bold = cell;
                bold.weight = QFont::DemiBold;
                for (std::size_t i = 0; i < part.size(); ++i) {
                    const double y = top + kHead + static_cast<double>(i) * kRow;
                    if (i % 2 == 0) {
                        canvas.rectangle({x, y, inner, kRow}, ink::kGround);
                    }
                    canvas.text({x + 6.0, y + 3.0}, part[i].number, cell, Qt::AlignRight);
                    canvas.text({x + 7.5, y + 3.0}, elided(part[i].name, inner - 7.5 - kBearing - 10.0, bold),
                                bold);
                    canvas.text({x + inner - kBearing, y + 3.0}, part[i].length, cell, Qt::AlignRight);
                    canvas.text({x + inner, y + 3.0}, part[i].bearing, cell, Qt::AlignRight);
                }
            });
            next = end;
        }
        if (next < passes.size()) {
            flow_.newPage();
        }
    }
}

void OrderLayout::layHash() {
    flow_.skip(3.0);
    flow_.need(9.0);
    const QRectF box = flow_.take(9.0);
    flow_.draw([box, hash = plan_.hash](Canvas& canvas) {
        canvas.text(
            box.topLeft() + QPointF{0.0, 3.0},
            LayoutWords::tr(
                "This plan's path.csv has the SHA-256 sum below. A file with another sum is another plan."),
            kLabel);
        canvas.text(box.topLeft() + QPointF{0.0, 7.2}, hash,
                    {.points = 8.0, .weight = QFont::Medium, .colour = ink::kText});
    });
}

}  // namespace furrow
