#include "planner/imagery/height_tile.h"

#include "planner/gdal/messages.h"

#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <numbers>

namespace furrow {

namespace {

constexpr int kFullSide = kTileSide + 2 * kHeightMargin;
/// What GDAL gives level ground under light from 45 degrees: 1 + 254 sin 45°.
constexpr double kLevelShade = 1.0 + 254.0 * std::numbers::sqrt2 / 2.0;
/// How much of what lies beneath the darkest and the lightest slope hide.
constexpr double kStrongest = 0.85;
constexpr double kWantedGapPx = 30.0;
constexpr std::array<std::uint8_t, 3> kContourColour{122, 74, 30};

/// GDAL's hillshade of the same size; 0 where it is unknown.
std::vector<std::uint8_t> shadeOf(GDALDataset& heights, TileId id) {
    const TileEdges edges = edgesOf(id);
    const double latRad =
        fromMercator(edges.west, 0.5 * (edges.north + edges.south)).latDeg * std::numbers::pi / 180.0;
    // Metres of web Mercator are shorter on the ground away from the equator.
    std::array<std::string, 7> words{
        "-of", "MEM", "-s", std::format("{}", std::cos(latRad)), "-alt", "45", "-compute_edges"};
    std::vector<char*> list;
    for (std::string& word : words) {
        list.push_back(word.data());
    }
    list.push_back(nullptr);
    const GdalMessages messages;
    GDALDEMProcessingOptions* options = GDALDEMProcessingOptionsNew(list.data(), nullptr);
    const RasterDataset shade{
        GDALDataset::FromHandle(GDALDEMProcessing("", &heights, "hillshade", nullptr, options, nullptr))};
    GDALDEMProcessingOptionsFree(options);
    return shade ? bytesOf(*shade, 1)
                 : std::vector<std::uint8_t>(static_cast<std::size_t>(kFullSide) *
                                             static_cast<std::size_t>(kFullSide));
}

/// How much of a pixel a contour line covers: from the height's distance to the next line over its gradient.
double contourCover(double height, double gradientPerPixel, double stepM) {
    if (gradientPerPixel < stepM * 1e-3) {
        return 0.0;  // so level that a line would be an area
    }
    const double number = std::round(height / stepM);
    const double awayPx = std::abs(height - number * stepM) / gradientPerPixel;
    const double halfWidthPx = std::fmod(std::abs(number), 5.0) < 0.5 ? 1.0 : 0.5;
    return std::clamp(halfWidthPx + 0.5 - awayPx, 0.0, 1.0);
}

}  // namespace

std::optional<TilePicture> heightTile(GDALDataset& heights, TileId id, double stepM) {
    const std::vector<float> values = floatsOf(heights, 1);
    if (std::ranges::none_of(values, [](float value) { return std::isfinite(value); })) {
        return std::nullopt;
    }
    const std::vector<std::uint8_t> shade = shadeOf(heights, id);
    TilePicture picture{.side = kTileSide, .rgba = {}};
    picture.rgba.reserve(static_cast<std::size_t>(kTileSide) * kTileSide * 4);
    for (int row = kHeightMargin; row < kHeightMargin + kTileSide; ++row) {
        for (int column = kHeightMargin; column < kHeightMargin + kTileSide; ++column) {
            const auto at = static_cast<std::size_t>(row) * kFullSide + static_cast<std::size_t>(column);
            if (!std::isfinite(values[at]) || shade[at] == 0) {
                picture.rgba.insert(picture.rgba.end(), 4, 0);
                continue;
            }
            const double light =
                (shade[at] - kLevelShade) / (shade[at] < kLevelShade ? kLevelShade : 255.0 - kLevelShade);
            const double hidden = kStrongest * std::abs(light);
            const double slopeX = 0.5 * (values[at + 1] - values[at - 1]);
            const double slopeY = 0.5 * (values[at + kFullSide] - values[at - kFullSide]);
            const double gradient = std::hypot(slopeX, slopeY);
            const double line =
                std::isfinite(gradient) ? 0.9 * contourCover(values[at], gradient, stepM) : 0.0;
            const double ground = light < 0.0 ? 0.0 : 255.0 * hidden;
            for (const std::uint8_t colour : kContourColour) {
                picture.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(line * colour + (1.0 - line) * ground)));
            }
            picture.rgba.push_back(
                static_cast<std::uint8_t>(std::lround(255.0 * (line + (1.0 - line) * hidden))));
        }
    }
    return picture;
}

double meanSlope(GDALDataset& heights, double cellM) {
    const std::vector<float> values = floatsOf(heights, 1);
    const auto width = static_cast<std::size_t>(heights.GetRasterXSize());
    GDALRasterBand* band = heights.GetRasterBand(1);
    int hasNoData = FALSE;
    const auto noData = static_cast<float>(band->GetNoDataValue(&hasNoData));
    const auto known = [&](std::size_t at) {
        return std::isfinite(values[at]) && (hasNoData == FALSE || values[at] != noData);
    };
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t at = 0; at + width + 1 < values.size(); ++at) {
        if ((at + 1) % width != 0 && known(at) && known(at + 1) && known(at + width)) {
            sum += std::hypot(values[at + 1] - values[at], values[at + width] - values[at]) / cellM;
            ++count;
        }
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

double contourStep(double slope, double metresPerPixel) {
    const double wanted = std::max(slope, 1e-3) * metresPerPixel * kWantedGapPx;
    double power = 0.1;
    while (power < 1000.0) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * power >= wanted) {
                return factor * power;
            }
        }
        power *= 10.0;
    }
    return power;
}

}  // namespace furrow
