#pragma once

#include "planner/field/field.h"
#include "tests/support/field_generator.h"
#include "tests/support/wkt.h"

#include <QString>

#include <limits>
#include <optional>
#include <string>

// Fields that the rows of a test draw as well-known text.

namespace furrow::test {

/// Where rows are drawn.
inline constexpr GeoPoint kDrawnAt{9.2, 51.3};

/// Rows are drawn in metres around the centre; the corners are on the ground, so that a field's own frame,
/// centred on its bounding box, shows the same shape within a millimetre.
inline FieldSource sourceFromWkt(const QString& wkt, GeoPoint centre = kDrawnAt) {
    return fieldSourceFromLocal(polygonsAsInFile(wkt.toStdString()), centre);
}

/// The place of an error or a note, in the metres of the row.
inline Point placeOf(const std::optional<GeoPoint>& place, GeoPoint centre = kDrawnAt) {
    return place ? LocalFrame::centredOn(centre)->toLocal(*place)
                 : Point{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
}

inline std::string allNotes(const Field& field) {
    std::string text;
    for (const Note& note : field.repairs()) {
        text += note.where + ": " + note.text + "\n";
    }
    return text;
}

}  // namespace furrow::test
