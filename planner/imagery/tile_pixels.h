#pragma once

#include "planner/imagery/imagery.h"

#include <span>

namespace furrow {

/// Around the world in web Mercator, m.
inline constexpr double kMercatorWorldM = 40075016.685578488;

/// Edges of a tile in web Mercator (EPSG:3857), m.
struct TileEdges {
    double west = 0.0;
    double south = 0.0;
    double east = 0.0;
    double north = 0.0;
};

TileEdges edgesOf(TileId id);
GeoPoint fromMercator(double eastM, double northM);
/// Pixels of 256 around the world at this zoom are this wide, m of web Mercator.
double mercatorPixelM(int zoom);

/// Appends one pixel, multiplying by its alpha.
void addPixel(std::vector<std::uint8_t>& rgba, std::span<const std::uint8_t, 3> colour, std::uint8_t alpha);

}  // namespace furrow
