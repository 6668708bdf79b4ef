#include "planner/imagery/tile_pixels.h"

#include <cmath>
#include <numbers>

namespace furrow {

TileEdges edgesOf(TileId id) {
    const double side = kMercatorWorldM / std::exp2(id.zoom);
    const double west = -0.5 * kMercatorWorldM + id.column * side;
    const double north = 0.5 * kMercatorWorldM - id.row * side;
    return {.west = west, .south = north - side, .east = west + side, .north = north};
}

GeoPoint fromMercator(double eastM, double northM) {
    constexpr double kRadiusM = kMercatorWorldM / (2.0 * std::numbers::pi);
    return {.lonDeg = eastM / kMercatorWorldM * 360.0,
            .latDeg = std::atan(std::sinh(northM / kRadiusM)) * 180.0 / std::numbers::pi};
}

double mercatorPixelM(int zoom) {
    return kMercatorWorldM / (kTileSide * std::exp2(zoom));
}

void addPixel(std::vector<std::uint8_t>& rgba, std::span<const std::uint8_t, 3> colour, std::uint8_t alpha) {
    for (const std::uint8_t channel : colour) {
        rgba.push_back(static_cast<std::uint8_t>((channel * alpha + 127) / 255));
    }
    rgba.push_back(alpha);
}

}  // namespace furrow
