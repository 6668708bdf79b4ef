#include "planner/imagery/raster_imagery.h"

#include "planner/core/file_error.h"
#include "planner/gdal/messages.h"
#include "planner/imagery/height_tile.h"

#include <gdal_alg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <numbers>

namespace furrow {

namespace {

/// A raster without overviews that is larger is reduced to this once.
constexpr int kReducedSide = 2048;
/// To reduce more pixels than these takes minutes.
constexpr double kMostPixelsWithoutOverviews = 4e9;
constexpr double kMostBlockBytes = 5e8;
/// Heights are drawn finer than they were measured: lines and slopes between them are smooth.
constexpr int kHeightZoomsBeyond = 5;
constexpr int kSampleSide = 256;

bool isWide(GDALDataType type) {
    return type != GDT_Byte;
}

Error noPlace(const std::string& where) {
    return inputRefused(where, "the picture does not say where it lies",
                        "give a GeoTIFF, or export it again with its coordinate system");
}

}  // namespace

Result<std::shared_ptr<const Imagery>> RasterImagery::open(const std::filesystem::path& path) {
    const std::string where = path.string();
    const GdalMessages messages;
    RasterDataset raster = openRaster(path);
    if (!raster || raster->GetRasterCount() == 0) {
        return std::unexpected(readFailed(
            where,
            raster ? "there is no picture in it" : "it is damaged, or not a picture that Furrow can show",
            "give a GeoTIFF, MBTiles, or a folder of tiles"));
    }
    std::shared_ptr<RasterImagery> made{new RasterImagery{path}};
    std::error_code error;
    made->written_ = std::filesystem::last_write_time(path, error);
    made->bytes_ = std::filesystem::file_size(path, error);
    auto reader = std::make_unique<TileReader>(std::move(raster), path);
    GDALDataset& opened = reader->raster();
    const auto ready = made->place(*reader).and_then([&] { return made->chooseBands(opened); }).and_then([&] {
        return made->facts_.kind == ImageryKind::Heights ? made->measureHeights(opened)
               : made->wide_                             ? made->measureRange(opened)
                                                         : Result<void>{};
    });
    if (!ready) {
        return std::unexpected(ready.error());
    }
    made->readers_.push_back(std::move(reader));
    return made;
}

Result<void> RasterImagery::place(TileReader& reader) {
    GDALDataset& raster = reader.raster();
    const std::string where = path_.string();
    const OGRSpatialReference* system = raster.GetSpatialRef();
    const bool hasPoints = raster.GetGCPCount() > 0 && raster.GetGCPSpatialRef() != nullptr;
    std::array<double, 6> affine{};
    if (!hasPoints && (system == nullptr || system->IsEmpty() || system->IsLocal() ||
                       raster.GetGeoTransform(affine.data()) != CE_None)) {
        return std::unexpected(noPlace(where));
    }
    double pixelM = 0.0;
    TileEdges extent;
    if (!reader.place(pixelM, extent)) {
        return std::unexpected(noPlace(where));
    }
    constexpr double kHalf = 0.5 * kMercatorWorldM;
    edges_ = {.west = std::max(extent.west, -kHalf),
              .south = std::max(extent.south, -kHalf),
              .east = std::min(extent.east, kHalf),
              .north = std::min(extent.north, kHalf)};
    if (!(edges_.west < edges_.east && edges_.south < edges_.north && pixelM > 0.0)) {
        return std::unexpected(noPlace(where));
    }
    facts_.southWest = fromMercator(edges_.west, edges_.south);
    facts_.northEast = fromMercator(edges_.east, edges_.north);
    // A tenth of a zoom coarser than the raster shows all of it still.
    facts_.finestZoom = std::clamp(static_cast<int>(std::ceil(std::log2(mercatorPixelM(0) / pixelM) - 0.1)),
                                   0, kFinestTileZoom);

    int blockWidth = 0;
    int blockHeight = 0;
    GDALRasterBand& band = *raster.GetRasterBand(1);
    band.GetBlockSize(&blockWidth, &blockHeight);
    const double blockBytes =
        double(blockWidth) * blockHeight * GDALGetDataTypeSizeBytes(band.GetRasterDataType());
    const int longest = std::max(raster.GetRasterXSize(), raster.GetRasterYSize());
    const bool reduces = longest > kReducedSide && band.GetOverviewCount() == 0;
    const double pixels = double(raster.GetRasterXSize()) * raster.GetRasterYSize();
    if (blockBytes > kMostBlockBytes || (reduces && pixels > kMostPixelsWithoutOverviews)) {
        return std::unexpected(inputRefused(where, "it is too large to be shown without overviews",
                                            "save it in tiles and with overviews (gdal_translate -of COG)"));
    }
    if (reduces) {
        const double reducedPixelM = pixelM * longest / kReducedSide;
        reducedZoom_ = static_cast<int>(std::floor(std::log2(mercatorPixelM(0) / reducedPixelM) + 0.3));
    }
    return {};
}

Result<void> RasterImagery::chooseBands(GDALDataset& raster) {
    const int count = raster.GetRasterCount();
    std::array<int, 3> colours{};
    int alpha = 0;
    for (int band = 1; band <= count; ++band) {
        switch (raster.GetRasterBand(band)->GetColorInterpretation()) {
            case GCI_RedBand: colours[0] = band; break;
            case GCI_GreenBand: colours[1] = band; break;
            case GCI_BlueBand: colours[2] = band; break;
            case GCI_AlphaBand: alpha = band; break;
            default: break;
        }
    }
    GDALRasterBand& first = *raster.GetRasterBand(1);
    wide_ = isWide(first.GetRasterDataType());
    if (std::ranges::all_of(colours, [](int band) { return band > 0; })) {
        bands_.assign(colours.begin(), colours.end());
    } else if (count - (alpha > 0 ? 1 : 0) >= 3) {
        bands_ = {1, 2, 3};
    } else {
        bands_ = {1};
    }
    alpha_ = alpha;
    if (const GDALColorTable* table = first.GetColorTable();
        bands_.size() == 1 && !wide_ && table != nullptr) {
        for (int i = 0; i < 256; ++i) {
            const GDALColorEntry* entry = table->GetColorEntry(std::min(i, table->GetColorEntryCount() - 1));
            palette_.push_back({static_cast<std::uint8_t>(entry->c1), static_cast<std::uint8_t>(entry->c2),
                                static_cast<std::uint8_t>(entry->c3), static_cast<std::uint8_t>(entry->c4)});
        }
    }
    // Sixteen bits without a sign are what cameras count in; heights come with one, or as fractions.
    if (count == 1 && wide_ && first.GetRasterDataType() != GDT_UInt16) {
        facts_.kind = ImageryKind::Heights;
        facts_.finestZoom = std::min(facts_.finestZoom + kHeightZoomsBeyond, kFinestTileZoom);
    }
    return {};
}

Result<void> RasterImagery::measureHeights(GDALDataset& raster) {
    const auto sample = reducedRaster(raster, bands_, kSampleSide, false, path_.string(), {});
    if (!sample) {
        return std::unexpected(sample.error());
    }
    const double latRad =
        0.5 * (facts_.southWest.latDeg + facts_.northEast.latDeg) * std::numbers::pi / 180.0;
    slope_ =
        meanSlope(**sample, (edges_.east - edges_.west) * std::cos(latRad) / (*sample)->GetRasterXSize());
    return {};
}

Result<void> RasterImagery::measureRange(GDALDataset& raster) {
    const auto sample = reducedRaster(raster, bands_, kSampleSide, false, path_.string(), {});
    if (!sample) {
        return std::unexpected(sample.error());
    }
    int hasNoData = FALSE;
    const auto noData = static_cast<float>(raster.GetRasterBand(1)->GetNoDataValue(&hasNoData));
    std::vector<float> values;
    for (int band = 1; band <= (*sample)->GetRasterCount(); ++band) {
        std::ranges::copy_if(floatsOf(**sample, band), std::back_inserter(values), [&](float value) {
            return std::isfinite(value) && (hasNoData == FALSE || value != noData);
        });
    }
    if (values.empty()) {
        return {};
    }
    // Without the two hundredths at either end, so that a single bright roof does not darken the field.
    std::ranges::sort(values);
    darkest_ = values[values.size() / 50];
    lightest_ = std::max<double>(values[values.size() - 1 - values.size() / 50], darkest_ + 1e-6);
    return {};
}

Result<void> RasterImagery::unchanged() const {
    std::error_code error;
    const auto written = std::filesystem::last_write_time(path_, error);
    if (error) {
        return std::unexpected(
            readFailed(path_.string(), "the file is not there any more", "put it back, or remove the layer"));
    }
    const auto bytes = std::filesystem::file_size(path_, error);
    if (written != written_ || bytes != bytes_) {
        return std::unexpected(
            readFailed(path_.string(), "the file was changed while it was open", "open it again"));
    }
    return {};
}

bool RasterImagery::isInside(TileId id) const {
    const TileEdges tile = edgesOf(id);
    return tile.west < edges_.east && tile.east > edges_.west && tile.south < edges_.north &&
           tile.north > edges_.south;
}

Result<std::unique_ptr<TileReader>> RasterImagery::takeReader() const {
    {
        const std::scoped_lock lock{mutex_};
        if (!readers_.empty()) {
            auto reader = std::move(readers_.back());
            readers_.pop_back();
            return reader;
        }
    }
    const GdalMessages messages;
    RasterDataset raster = openRaster(path_);
    if (!raster) {
        return std::unexpected(
            readFailed(path_.string(), "the file cannot be read any more", "open it again"));
    }
    return std::make_unique<TileReader>(std::move(raster), path_);
}

Result<RasterDataset> RasterImagery::read(TileId id, const JobContext& job) const {
    const bool heights = facts_.kind == ImageryKind::Heights;
    TileBands bands{.colours = bands_,
                    .alpha = alpha_,
                    .type = wide_ ? GDT_Float32 : GDT_Byte,
                    .margin = heights ? kHeightMargin : 0,
                    .withAlpha = !heights,
                    .smooth = palette_.empty()};
    auto reader = takeReader();
    if (!reader) {
        return std::unexpected(reader.error());
    }
    Result<RasterDataset> made = std::unexpected(cancelled());
    if (id.zoom <= reducedZoom_) {
        const std::scoped_lock lock{reducedMutex_};
        if (const auto reduced = reduce(**reader, job); !reduced) {
            made = std::unexpected(reduced.error());
        } else {
            // In the order in which they were copied.
            for (std::size_t i = 0; i < bands.colours.size(); ++i) {
                bands.colours[i] = static_cast<int>(i) + 1;
            }
            bands.alpha = alpha_ > 0 ? static_cast<int>(bands.colours.size()) + 1 : 0;
            made = reduced_->tile(id, bands, path_.string(), job);
        }
    } else {
        made = (*reader)->tile(id, bands, path_.string(), job);
    }
    const std::scoped_lock lock{mutex_};
    readers_.push_back(std::move(*reader));
    return made;
}

Result<void> RasterImagery::reduce(TileReader& reader, const JobContext& job) const {
    if (reduced_) {
        return {};
    }
    std::vector<int> bands = bands_;
    if (alpha_ > 0) {
        bands.push_back(alpha_);
    }
    auto raster = reducedRaster(reader.raster(), bands, kReducedSide, palette_.empty(), path_.string(), job);
    if (!raster) {
        return std::unexpected(raster.error());
    }
    reduced_ = std::make_unique<TileReader>(std::move(*raster), std::filesystem::path{});
    return {};
}

Result<std::optional<TilePicture>> RasterImagery::tile(TileId id, const JobContext& job) const {
    if (const auto same = unchanged(); !same) {
        return std::unexpected(same.error());
    }
    if (!isInside(id)) {
        return std::nullopt;
    }
    return read(id, job).transform([&](const RasterDataset& tile) {
        return facts_.kind == ImageryKind::Heights ? heightTile(*tile, id, contourStepM(id.zoom))
                                                   : std::optional{pictureOf(*tile)};
    });
}

TilePicture RasterImagery::pictureOf(GDALDataset& warped) const {
    const std::size_t pixels = std::size_t{kTileSide} * kTileSide;
    const int alphaBand = warped.GetRasterCount();
    const auto alpha = bytesOf(warped, alphaBand);
    std::vector<std::vector<std::uint8_t>> colours;
    for (int band = 1; band < alphaBand && band <= 3; ++band) {
        if (!wide_) {
            colours.push_back(bytesOf(warped, band));
            continue;
        }
        std::vector<std::uint8_t> bytes;
        for (const float value : floatsOf(warped, band)) {
            const double share = (double{value} - darkest_) / (lightest_ - darkest_);
            bytes.push_back(static_cast<std::uint8_t>(
                std::lround(255.0 * std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0))));
        }
        colours.push_back(std::move(bytes));
    }
    TilePicture picture{.side = kTileSide, .rgba = {}};
    picture.rgba.reserve(pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!palette_.empty()) {
            const auto& entry = palette_[colours[0][i]];
            addPixel(picture.rgba, std::span<const std::uint8_t, 4>{entry}.first<3>(),
                     static_cast<std::uint8_t>(entry[3] * alpha[i] / 255));
            continue;
        }
        const bool grey = colours.size() < 3;
        const std::array<std::uint8_t, 3> colour{colours[0][i], colours[grey ? 0 : 1][i],
                                                 colours[grey ? 0 : 2][i]};
        addPixel(picture.rgba, colour, alpha[i]);
    }
    return picture;
}

double RasterImagery::contourStepM(int zoom) const {
    if (facts_.kind == ImageryKind::Picture) {
        return 0.0;
    }
    const double latRad =
        0.5 * (facts_.southWest.latDeg + facts_.northEast.latDeg) * std::numbers::pi / 180.0;
    return contourStep(slope_, mercatorPixelM(zoom) * std::cos(latRad));
}

}  // namespace furrow
