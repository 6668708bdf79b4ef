#pragma once

#include "planner/geometry/polygon.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// One kind of thing on a map, in the order of drawing; in metres.
struct MapLayer {
    std::string name;  ///< in the legend; empty for none
    MultiPolygon areas;
    std::vector<Polyline> lines;
    std::string_view fill;    ///< of areas; empty for none
    std::string_view stroke;  ///< of lines and outlines; empty for none
    double width = 1.0;       ///< pixels
    std::string_view dash;    ///< "4 3"
    bool arrows = false;      ///< in the middle of each line, where there is room for one
};

/// A map of a field: north is up.
struct MapPicture {
    std::string title;
    std::string note;  ///< one or two sentences under the title
    std::vector<MapLayer> layers;
    double width = 900.0;          ///< pixels
    double largestHeight = 900.0;  ///< of the map itself
};

/// As an SVG file with a legend and a scale bar. Points closer than a third of a pixel are left out. What
/// is not finite is not drawn; a map of nothing says so.
std::string svgOf(const MapPicture& picture);

/// Several maps in one file, side by side in rows, each at its own scale.
std::string svgOf(std::span<const MapPicture> pictures, int columns, const std::string& title,
                  const std::string& note);

}  // namespace furrow
