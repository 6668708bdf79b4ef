#pragma once

#include "ui/pages/work_order_pages.h"

#include <QRectF>

#include <vector>

namespace furrow {

/// Fills pages from top to bottom.
class PageFlow {
public:
    using Drawing = WorkOrderPages::Drawing;

    static constexpr double kMargin = 12.0;
    static constexpr double kFooter = 9.0;  ///< above the lower margin

    explicit PageFlow(QSizeF size) : size_{size} {}

    /// Goes on at the top of a new page.
    void newPage();
    /// Goes on on a new page where less than this is left.
    void need(double heightMm);
    /// Takes this much of the page; gives the box of it.
    QRectF take(double heightMm);
    void skip(double heightMm) { y_ += heightMm; }
    void draw(Drawing drawing) { pages_.back().push_back(std::move(drawing)); }

    double left() const { return kMargin; }
    double width() const { return size_.width() - 2.0 * kMargin; }
    double y() const { return y_; }
    double bottom() const { return size_.height() - kMargin - kFooter; }
    double rest() const { return bottom() - y_; }
    std::size_t page() const { return pages_.size() - 1; }
    std::vector<std::vector<Drawing>>& pages() { return pages_; }

private:
    QSizeF size_;
    double y_ = kMargin;
    std::vector<std::vector<Drawing>> pages_;
};

}  // namespace furrow
