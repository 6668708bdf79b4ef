#pragma once

#include "planner/project/review.h"
#include "planner/sheet/map_layout.h"
#include "planner/sheet/order_sheet.h"
#include "ui/pages/canvas.h"

#include <QRectF>

#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// The map of a work order, to scale: laid out once, drawn on any device.
class SheetMap {
public:
    /// @param box  on the page, in millimetres. Keeps what it needs of the sheet.
    SheetMap(const OrderSheet& sheet, std::span<const ReviewComment> comments, const QRectF& box);

    void draw(Canvas& canvas) const;
    /// 2000 for 1 to 2,000.
    double scale() const { return scale_; }

private:
    struct Arrow {
        QPolygonF tip;
    };
    struct Mark {
        QPointF middle;
        QString text;
        double width = 0.0;
        bool blocking = false;
    };

    QPointF onPage(Point place) const;
    QPolygonF onPage(const Polyline& line) const;
    QList<QPolygonF> onPage(const MultiPolygon& polygons) const;

    void layShapes(const OrderSheet& sheet);
    void layMarks(const OrderSheet& sheet, std::span<const ReviewComment> comments);
    void layFindings(const OrderSheet& sheet, LabelPlaces& places);
    void layComments(const OrderSheet& sheet, std::span<const ReviewComment> comments, LabelPlaces& places);
    void layGates(const OrderSheet& sheet, LabelPlaces& places);
    void layNumbers(const OrderSheet& sheet, LabelPlaces& places);
    void layArrows(LabelPlaces& places);
    void drawKey(Canvas& canvas) const;

    QRectF map_;  ///< where the field is
    QRectF key_;  ///< north, scale and what the lines mean
    double scale_ = 1000.0;
    Point centre_;

    QList<QPolygonF> field_;
    QList<QPolygonF> mainland_;
    std::vector<QList<QPolygonF>> solid_;
    std::vector<QList<QPolygonF>> passable_;
    std::vector<QPolygonF> rings_;
    std::vector<QPolygonF> swaths_;
    std::vector<Polyline> swathLines_;  ///< the same, for what is placed along them
    std::vector<int> swathNumbers_;     ///< of these
    struct Way {
        QPolygonF line;
        bool reverse = false;
        bool drivable = true;
    };
    std::vector<Way> ways_;
    QPointF start_;
    QPointF end_;
    std::vector<QPointF> gates_;
    std::vector<Mark> names_;
    std::vector<Mark> numbers_;
    std::vector<Mark> ringNumbers_;
    std::vector<Mark> findings_;
    std::vector<Mark> comments_;
    std::vector<Arrow> arrows_;
};

/// A, B ... Z, AA ...: how comments are called on the map and below it.
QString commentLetter(std::size_t index);

}  // namespace furrow
