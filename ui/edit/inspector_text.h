#pragma once

#include "planner/editing/field_shape.h"
#include "planner/plan/plan.h"
#include "planner/plan/turn_options.h"
#include "ui/edit/selection.h"
#include "ui/text/quantity_text.h"

#include <QString>

#include <optional>
#include <vector>

namespace furrow {

/// What of a selection can be typed.
enum class InspectorField {
    None,
    Name,
    Latitude,
    Longitude,
    EdgeLength,
    EdgeBearing,
    EdgeHeadland,
    EdgeOverhang,
    Buffer,
    ObstacleOverhang,
    GateWidth
};

/// One line of the inspector: a figure, or something to type.
struct InspectorRow {
    QString label;
    QString text;
    InspectorField field = InspectorField::None;
    double number = 0.0;
    QuantityText::Kind quantity = QuantityText::Number;
    int decimals = 2;
    double from = 0.0;
    double to = 0.0;

    friend bool operator==(const InspectorRow&, const InspectorRow&) = default;
};

/// What is selected, in words and figures.
struct InspectorText {
    QString title;
    QString sentence;
    std::vector<InspectorRow> rows;
    std::optional<bool> passable;  ///< of obstacles
    bool isEdge = false;           ///< of the boundary: the swaths may follow it
    bool hasOwnHeadland = false;   ///< an edge with a width of its own

    friend bool operator==(const InspectorText&, const InspectorText&) = default;
};

/// Nothing where the selection is of something that is gone. `source` belongs to `shape`; both may be null
/// for a selection in a plan, and the plan for one in the field.
std::optional<InspectorText> inspectorText(const Selection& selection, const FieldShape* shape,
                                           const FieldSource* source, const Plan* plan);

/// Adds what is known of a turn beside others: how near it comes to the edge, and what could be driven in its
/// place.
void addOptions(InspectorText& text, const TurnOptions& options);

}  // namespace furrow
