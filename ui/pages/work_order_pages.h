#pragma once

#include "planner/project/review.h"
#include "planner/project/work_order.h"
#include "planner/sheet/order_sheet.h"
#include "ui/pages/canvas.h"

#include <QDateTime>
#include <QSizeF>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

class QPainter;

namespace furrow {

enum class PaperSize { A4, Letter };

/// In millimetres, upright.
QSizeF paperMm(PaperSize paper);

/// SHA-256 of the bytes of path.csv as Furrow exports it, in hexadecimal: equal on paper and in the plan's
/// folder.
QString planHash(const std::string& pathFile);

/// One plan that is handed out.
struct OrderedPlan {
    std::shared_ptr<const OrderSheet> sheet;
    WorkOrder order;
    QString planName;  ///< empty where it has none
    QString season;
    QString hash;                              ///< as planHash says
    std::vector<ReviewComment> comments = {};  ///< that stand on it
};

/// What is printed together.
struct PrintJob {
    QString farm;  ///< its name; may be empty
    std::vector<OrderedPlan> plans;
    PaperSize paper = PaperSize::A4;
    QDateTime printed;
    bool wholeFarm = false;  ///< with a first page of all fields and their totals
};

/// Work orders as pages: laid out once, in the language and units of the moment, and painted on any device.
class WorkOrderPages {
public:
    explicit WorkOrderPages(const PrintJob& job);
    ~WorkOrderPages();
    WorkOrderPages(WorkOrderPages&&) noexcept;
    WorkOrderPages& operator=(WorkOrderPages&&) noexcept;

    int count() const { return static_cast<int>(pages_.size()); }
    QSizeF sizeMm() const { return size_; }
    /// @param page  from 0
    /// @param dotsPerMm  of the painter's device
    void paint(QPainter& painter, int page, double dotsPerMm) const;

    using Drawing = std::function<void(Canvas&)>;

private:
    QSizeF size_;
    std::vector<std::vector<Drawing>> pages_;
};

}  // namespace furrow
