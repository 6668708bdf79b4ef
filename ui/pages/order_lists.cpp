#include "ui/pages/order_lists.h"

#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "ui/pages/sheet_map.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

constexpr std::size_t kMostFindings = 40;
constexpr double kRemarkIndent = 9.0;
constexpr double kRemarkAside = 38.0;

TextLook quietBody() {
    TextLook look = kBody;
    look.colour = ink::kQuiet;
    return look;
}

/// Of a method, where the turn is one alone.
QString turnName(const std::string& id) {
    for (const StageInfo& stage : stages()) {
        const auto method = std::ranges::find(stage.methods, id, &MethodInfo::id);
        if (stage.id == "path" && method != stage.methods.end()) {
            return shown(method->name);
        }
    }
    return OrderWords::tr("Several moves");
}

}  // namespace

void layHeading(PageFlow& flow, const QString& text, double heightBelow) {
    flow.skip(3.0);
    flow.need(8.0 + heightBelow);
    const QRectF box = flow.take(8.0);
    flow.draw([=](Canvas& canvas) {
        canvas.text(box.topLeft() + QPointF{0.0, 5.0}, text, kHeading);
        canvas.line(box.topLeft() + QPointF{0.0, 6.6}, box.topRight() + QPointF{0.0, 6.6}, ink::kLine);
    });
}

OrderLists::OrderLists(const OrderedPlan& plan, PageFlow& flow)
    : plan_{plan}, sheet_{*plan.sheet}, flow_{flow} {}

void OrderLists::lay() {
    layFindings();
    layComments();
    layTurns();
    layPasses();
}

/// A mark that is on the map, what is said there, and something short on the right.
void OrderLists::layRemark(const QString& mark, const QColor& colour, const std::vector<Paragraph>& text,
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

void OrderLists::layFindings() {
    layHeading(flow_, OrderWords::tr("Findings"), 10.0);
    if (sheet_.findings.empty()) {
        const QRectF box = flow_.take(5.0);
        flow_.draw([box](Canvas& canvas) {
            canvas.text(box.topLeft() + QPointF{0.0, 3.6},
                        OrderWords::tr("None: the plan can be driven as drawn."), kBody);
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
        const QString more = OrderWords::tr("and %n more, in the window and in summary.json", nullptr,
                                            static_cast<int>(sheet_.findings.size() - count));
        flow_.draw([=](Canvas& canvas) {
            canvas.text(box.topLeft() + QPointF{kRemarkIndent, 3.6}, more, quietBody());
        });
    }
}

void OrderLists::layComments() {
    if (plan_.comments.empty()) {
        return;
    }
    layHeading(flow_, OrderWords::tr("Comments"), 10.0);
    for (std::size_t i = 0; i < plan_.comments.size(); ++i) {
        layRemark(commentLetter(i), ink::kText, {{fromStd(plan_.comments[i].text), kBody}},
                  fromStd(plan_.comments[i].author));
    }
}

void OrderLists::layTurns() {
    if (sheet_.turns.empty()) {
        return;
    }
    QStringList kinds;
    for (const SheetTurns& turns : sheet_.turns) {
        kinds << OrderWords::tr("%1 × %2", "count and kind of turns")
                     .arg(turns.count)
                     .arg(turnName(turns.type));
    }
    if (sheet_.figures.reverse > metres(0.0)) {
        kinds << OrderWords::tr("%1 in reverse").arg(lengthText(sheet_.figures.reverse));
    }
    const QStringList lines = wrappedLines(inOneLine(kinds), flow_.width(), kBody);
    layHeading(flow_, OrderWords::tr("Turns"), lineHeightMm(kBody) * static_cast<double>(lines.size()));
    for (const QString& line : lines) {
        const QRectF box = flow_.take(lineHeightMm(kBody));
        flow_.draw([=](Canvas& canvas) { canvas.text(box.topLeft() + QPointF{0.0, 3.2}, line, kBody); });
    }
}

void OrderLists::layPasses() {
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
        passes.push_back(
            {QString::number(passes.size() + 1),
             headland
                 ? OrderWords::tr("Headland") + u' ' + OrderWords::tr("H%1", "headland pass").arg(pass.number)
                 : OrderWords::tr("Swath %1").arg(pass.number),
             lengthText(pass.length),
             pass.bearingDeg
                 ? OrderWords::tr("%1°").arg(static_cast<int>(std::lround(*pass.bearingDeg)) % 360)
                 : QString{}});
    }
    constexpr int kColumns = 4;
    constexpr double kBearing = 7.8;
    const TextLook cell{.points = 8.0, .weight = QFont::Normal, .colour = ink::kText};
    const double width = flow_.width() / kColumns;
    layHeading(flow_, OrderWords::tr("Order of the passes"), kHead + 3.0 * kRow);
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
                canvas.text({x + 6.0, top + 3.2}, OrderWords::tr("No."), kLabel, Qt::AlignRight);
                canvas.text({x + 7.5, top + 3.2}, OrderWords::tr("Pass"), kLabel);
                canvas.text({x + inner - kBearing, top + 3.2}, OrderWords::tr("Length"), kLabel,
                            Qt::AlignRight);
                canvas.text({x + inner, top + 3.2}, OrderWords::tr("To"), kLabel, Qt::AlignRight);
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

}  // namespace furrow
