#include "ui/pages/work_order_pages.h"

#include "ui/pages/order_layout.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <iterator>

namespace furrow {

namespace {

struct PageWords {
    Q_DECLARE_TR_FUNCTIONS(WorkOrderPages)
};

const TextLook kBold{.points = 8.5, .weight = QFont::DemiBold, .colour = ink::kText};

// As many digits as tell plans apart when they are compared by eye.
constexpr qsizetype kShortHash = 12;

/// The first page of a farm: all fields, and what they come to.
class FarmTable {
public:
    FarmTable(const PrintJob& job, PageFlow& flow) : job_{job}, flow_{flow} {}

    /// @param pages  the page on which each plan begins, from 1
    void lay(const std::vector<int>& pages) {
        flow_.newPage();
        placeColumns(pages);
        layTitle();
        layHead();
        for (std::size_t i = 0; i < job_.plans.size(); ++i) {
            if (flow_.rest() < 2.0 * kRow) {
                flow_.newPage();
                layHead();
            }
            layRow(cellsOf(job_.plans[i], pages[i]), kBody, i % 2 == 0);
        }
        layTotals();
    }

private:
    static constexpr double kRow = 6.0;
    static constexpr int kColumns = 8;
    using Cells = std::array<QString, kColumns>;

    static constexpr double kGap = 4.0;
    static bool isNumber(int column) { return (column >= 3 && column <= 5) || column == 7; }

    void layTitle() {
        const QRectF box = flow_.take(20.0);
        flow_.draw(
            [box, farm = job_.farm.isEmpty() ? PageWords::tr("Farm") : job_.farm,
             count = static_cast<int>(job_.plans.size()),
             date = QLocale{}.toString(job_.printed.date(), QStringLiteral("d MMM yyyy"))](Canvas& canvas) {
                canvas.text(box.topLeft() + QPointF{0.0, 3.6}, PageWords::tr("Work orders"),
                            {.points = 10.0, .weight = QFont::DemiBold, .colour = ink::kAccent});
                canvas.text(box.topLeft() + QPointF{0.0, 11.8}, elided(farm, box.width(), kTitle), kTitle);
                canvas.text(box.topLeft() + QPointF{0.0, 17.4},
                            inOneLine({PageWords::tr("%n field(s)", nullptr, count), date}),
                            {.points = 10.0, .weight = QFont::Normal, .colour = ink::kQuiet});
            });
    }

    Cells head() const {
        const bool named =
            std::ranges::any_of(job_.plans, [](const OrderedPlan& plan) { return !plan.planName.isEmpty(); });
        return {PageWords::tr("Field"),   named ? PageWords::tr("Plan") : QString{},
                PageWords::tr("Machine"), PageWords::tr("Area"),
                PageWords::tr("Time"),    PageWords::tr("Driven"),
                PageWords::tr("State"),   PageWords::tr("Page")};
    }

    /// Each column as wide as what is in it. Where that is too much, the widest of field, plan and machine
    /// give way; what is left over goes to the field.
    void placeColumns(const std::vector<int>& pages) {
        const auto widen = [this](const Cells& cells, const TextLook& look) {
            for (std::size_t i = 0; i < kColumns; ++i) {
                if (!cells[i].isEmpty()) {
                    room_[i] = std::max(room_[i], textWidthMm(cells[i], look));
                }
            }
        };
        widen(head(), kLabel);
        widen(totals(), kBold);
        for (std::size_t i = 0; i < job_.plans.size(); ++i) {
            widen(cellsOf(job_.plans[i], pages[i]), kBody);
        }
        double left = flow_.width() - 2.0;
        for (const double room : room_) {
            left -= room > 0.0 ? room + kGap : 0.0;
        }
        left += kGap;
        constexpr double kStep = 0.5;
        while (left < 0.0) {
            *std::max_element(room_.begin(), room_.begin() + 3) -= kStep;
            left += kStep;
        }
        room_[0] += left;
        double at = 0.0;
        for (std::size_t i = 0; i < kColumns; ++i) {
            edges_[i] = at + (isNumber(static_cast<int>(i)) ? room_[i] : 0.0);
            at += room_[i] > 0.0 ? room_[i] + kGap : 0.0;
        }
    }

    void layHead() {
        layRow(head(), kLabel, false);
        flow_.draw([y = flow_.y() - 0.8, x = flow_.left(), width = flow_.width()](Canvas& canvas) {
            canvas.line({x, y}, {x + width, y}, ink::kLine);
        });
    }

    static Cells cellsOf(const OrderedPlan& plan, int page) {
        const OrderSheet& sheet = *plan.sheet;
        return {fromStd(sheet.fieldName),
                plan.planName,
                shown(sheet.machine.name()),
                areaText(sheet.figures.field),
                durationText(sheet.figures.time),
                lengthText(sheet.figures.path),
                sheet.blockingCount() > 0 ? PageWords::tr("Not drivable") : statusText(plan.order.status),
                QString::number(page)};
    }

    void layRow(const Cells& cells, const TextLook& look, bool shaded) {
        const QRectF box = flow_.take(kRow);
        flow_.draw([=, room = room_, edges = edges_](Canvas& canvas) {
            if (shaded) {
                canvas.rectangle(box, ink::kGround);
            }
            for (int i = 0; i < kColumns; ++i) {
                const auto column = static_cast<std::size_t>(i);
                const double x = box.left() + 1.0 + edges[column];
                canvas.text({x, box.top() + 4.2}, elided(cells[column], room[column] + 0.1, look), look,
                            isNumber(i) ? Qt::AlignRight : Qt::AlignLeft);
            }
        });
    }

    Cells totals() const {
        Area area;
        Duration time;
        Length path;
        for (const OrderedPlan& plan : job_.plans) {
            area += plan.sheet->figures.field;
            time += plan.sheet->figures.time;
            path += plan.sheet->figures.path;
        }
        return {PageWords::tr("Total"), {}, {}, areaText(area), durationText(time), lengthText(path), {}, {}};
    }

    void layTotals() {
        flow_.need(2.0 * kRow);
        flow_.draw([y = flow_.y() + 0.3, x = flow_.left(), width = flow_.width()](Canvas& canvas) {
            canvas.line({x, y}, {x + width, y}, ink::kText, 0.3);
        });
        layRow(totals(), kBold, false);
    }

    const PrintJob& job_;
    PageFlow& flow_;
    std::array<double, kColumns> room_{};   ///< mm; none for a column without a word
    std::array<double, kColumns> edges_{};  ///< right edges of numbers, left edges of names
};

}  // namespace

QSizeF paperMm(PaperSize paper) {
    return paper == PaperSize::A4 ? QSizeF{210.0, 297.0} : QSizeF{215.9, 279.4};
}

QString planHash(const std::string& pathFile) {
    return QString::fromLatin1(
        QCryptographicHash::hash(QByteArrayView{pathFile.data(), static_cast<qsizetype>(pathFile.size())},
                                 QCryptographicHash::Sha256)
            .toHex());
}

WorkOrderPages::WorkOrderPages(const PrintJob& job) : size_{paperMm(job.paper)} {
    PageFlow orders{size_};
    std::vector<std::size_t> firstPages;
    std::vector<const OrderedPlan*> planOfPage;
    for (const OrderedPlan& plan : job.plans) {
        firstPages.push_back(orders.pages().size());
        OrderLayout{plan, job.farm, orders}.lay();
        planOfPage.resize(orders.pages().size(), &plan);
    }
    if (job.wholeFarm) {
        // How many pages the table takes does not depend on what it says.
        std::vector<int> pages(job.plans.size(), 1);
        PageFlow trial{size_};
        FarmTable{job, trial}.lay(pages);
        for (std::size_t i = 0; i < pages.size(); ++i) {
            pages[i] = static_cast<int>(trial.pages().size() + firstPages[i]) + 1;
        }
        PageFlow farm{size_};
        FarmTable{job, farm}.lay(pages);
        pages_ = std::move(farm.pages());
        planOfPage.insert(planOfPage.begin(), pages_.size(), nullptr);
    }
    std::ranges::move(orders.pages(), std::back_inserter(pages_));

    const int all = count();
    // Day and month cannot be mistaken for each other.
    const QString date = QLocale{}.toString(job.printed, QStringLiteral("d MMM yyyy, HH:mm"));
    for (int i = 0; i < all; ++i) {
        const OrderedPlan* const plan = planOfPage[static_cast<std::size_t>(i)];
        QStringList parts{PageWords::tr("Furrow %1").arg(QStringLiteral(FURROW_VERSION)), date};
        if (plan != nullptr) {
            parts << fromStd(plan->sheet->fieldName);
            if (!plan->order.number.empty()) {
                parts << fromStd(plan->order.number);
            }
            parts << PageWords::tr("plan %1").arg(plan->hash.left(kShortHash));
        }
        pages_[static_cast<std::size_t>(i)].push_back(
            [size = size_, text = inOneLine(parts),
             number = PageWords::tr("Page %1 of %2").arg(i + 1).arg(all)](Canvas& canvas) {
                const double y = size.height() - PageFlow::kMargin;
                const double right = size.width() - PageFlow::kMargin;
                canvas.line({PageFlow::kMargin, y - 4.5}, {right, y - 4.5}, ink::kLine);
                canvas.text({right, y}, number, kLabel, Qt::AlignRight);
                canvas.text(
                    {PageFlow::kMargin, y},
                    elided(text, right - PageFlow::kMargin - textWidthMm(number, kLabel) - 6.0, kLabel),
                    kLabel);
            });
    }
}

WorkOrderPages::~WorkOrderPages() = default;
WorkOrderPages::WorkOrderPages(WorkOrderPages&&) noexcept = default;
WorkOrderPages& WorkOrderPages::operator=(WorkOrderPages&&) noexcept = default;

void WorkOrderPages::paint(QPainter& painter, int page, double dotsPerMm) const {
    Canvas canvas{painter, dotsPerMm};
    for (const Drawing& drawing : pages_[static_cast<std::size_t>(page)]) {
        drawing(canvas);
    }
}

}  // namespace furrow
