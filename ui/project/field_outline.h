#pragma once

#include "planner/field/field.h"

#include <QList>
#include <QPointF>

namespace furrow {

/// The outer ring of the first part inside the unit square, y downwards, with few enough points for a
/// thumbnail; nothing for a ring that cannot be drawn.
QList<QPointF> fieldOutline(const FieldSource& field);

}  // namespace furrow
