#include "ui/plan/field_choice_model.h"

#include "planner/io/boundary_import.h"
#include "ui/map/map_frame.h"
#include "ui/plan/unit_text.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

/// The outer ring of the first part inside the unit square, with few enough points for a thumbnail.
QList<QPointF> outlineOf(const FieldSource& field) {
    constexpr std::size_t kMostPoints = 120;
    if (field.parts.empty() || field.parts.front().outer.size() < 3) {
        return {};
    }
    const GeoRing& ring = field.parts.front().outer;
    const std::size_t step = ring.size() / kMostPoints + 1;
    const WorldPoint origin = worldPoint(ring.front());
    QList<QPointF> points;
    for (std::size_t i = 0; i < ring.size(); i += step) {
        const MapPoint point = mapPoint(worldPoint(ring[i]), origin);
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
            return {};
        }
        points.emplace_back(double{point.x}, double{point.y});
    }
    const auto [left, right] = std::ranges::minmax(points, {}, &QPointF::x);
    const auto [top, bottom] = std::ranges::minmax(points, {}, &QPointF::y);
    const double size = std::max({right.x() - left.x(), bottom.y() - top.y(), 1e-6});
    const QPointF corner{(left.x() + right.x() - size) / 2.0, (top.y() + bottom.y() - size) / 2.0};
    for (QPointF& point : points) {
        point = (point - corner) / size;
    }
    points.push_back(points.front());
    return points;
}

}  // namespace

void FieldChoiceModel::show(std::vector<FieldSource> fields) {
    beginResetModel();
    fields_ = std::move(fields);
    endResetModel();
    emit countChanged();
}

int FieldChoiceModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : count();
}

QVariant FieldChoiceModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return fromStd(field(index.row()).name);
        case AreaRole: return areaText(areaOf(field(index.row())));
        case OutlineRole: return QVariant::fromValue(outlineOf(field(index.row())));
        default: return {};
    }
}

QHash<int, QByteArray> FieldChoiceModel::roleNames() const {
    return {{NameRole, "name"}, {AreaRole, "area"}, {OutlineRole, "outline"}};
}

}  // namespace furrow
