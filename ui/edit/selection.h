#pragma once

#include "planner/editing/field_shape.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>

namespace furrow {

/// What is selected on the map.
struct Selection {
    Q_GADGET
    QML_ANONYMOUS

public:
    enum class Kind { None, Vertex, Edge, Hole, Obstacle, Gate, Guide, Split, Segment, Cell, Finding };
    Q_ENUM(Kind)

    Kind kind = Kind::None;
    OutlineId outline;      ///< of a vertex, an edge, a hole, an obstacle, a guide, a split line
    std::size_t index = 0;  ///< vertex, edge, gate, segment of the path, cell, finding

    /// Of an outline, or something on it.
    bool isOutline() const {
        return kind == Kind::Vertex || kind == Kind::Edge || kind == Kind::Hole || kind == Kind::Obstacle ||
               kind == Kind::Guide || kind == Kind::Split;
    }
    bool isNone() const { return kind == Kind::None; }
    bool isOf(Kind of, const OutlineId& id, std::size_t at) const {
        return kind == of && outline == id && index == at;
    }
    friend bool operator==(const Selection&, const Selection&) = default;
};

}  // namespace furrow
