#pragma once

#include <QGeoCoordinate>
#include <QList>

namespace furrow::test {

/// Corners of a rectangle of 16 ha, as they are clicked on the map.
inline QList<QGeoCoordinate> drawnRectangle() {
    return {{58.25, 22.5}, {58.25, 22.507}, {58.2535, 22.507}, {58.2535, 22.5}};
}

}  // namespace furrow::test
