#include "planner/imagery/warped_tile.h"

#include "planner/core/file_error.h"
#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"

#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_utils.h>
#include <gdalwarper.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <utility>

namespace furrow {

namespace {

constexpr std::array kPictureDrivers{"GTiff",
                                     "MBTiles",
                                     "GPKG",
                                     "PNG",
                                     "JPEG",
                                     "WEBP",
                                     "JP2OpenJPEG",
                                     "AAIGrid",
                                     "SRTMHGT",
                                     "DTED",
                                     static_cast<const char*>(nullptr)};

int goOn(double /*share*/, const char* /*message*/, void* job) {
    return static_cast<const JobContext*>(job)->stopRequested() ? FALSE : TRUE;
}

Error damaged(const std::string& where, const std::string& reason) {
    return readFailed(where,
                      reason.empty() ? Message{"a part of it cannot be read"}
                                     : message("a part of it is damaged: {}", reason),
                      "copy or export the file again");
}

Result<RasterDataset> checked(GDALDatasetH made, const GdalMessages& messages, const std::string& where,
                              const JobContext& job) {
    RasterDataset dataset{GDALDataset::FromHandle(made)};
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (!dataset || messages.failed()) {
        return std::unexpected(damaged(where, messages.failure()));
    }
    return dataset;
}

struct WarpOptionsCloser {
    void operator()(GDALWarpOptions* options) const { GDALDestroyWarpOptions(options); }
};

/// Values that stand for nothing, of the bands that are read.
void setNoData(GDALWarpOptions& options, GDALDataset& raster, const TileBands& bands) {
    std::vector<double> values;
    bool any = false;
    for (const int band : bands.colours) {
        int has = FALSE;
        const double value = raster.GetRasterBand(band)->GetNoDataValue(&has);
        any = any || has != FALSE;
        // A value that no band holds, where only others have one.
        values.push_back(has != FALSE ? value : -1.1e20);
    }
    const std::size_t bytes = sizeof(double) * values.size();
    if (any) {
        options.padfSrcNoDataReal = static_cast<double*>(CPLMalloc(bytes));
        std::ranges::copy(values, options.padfSrcNoDataReal);
    }
    if (!bands.withAlpha) {
        options.padfDstNoDataReal = static_cast<double*>(CPLMalloc(bytes));
        std::ranges::fill_n(options.padfDstNoDataReal, std::ssize(values),
                            std::numeric_limits<double>::quiet_NaN());
    }
}

/// All values of a band; zeros where they cannot be read.
template <class Value>
std::vector<Value> valuesOf(GDALDataset& raster, int band, GDALDataType type) {
    const int width = raster.GetRasterXSize();
    const int height = raster.GetRasterYSize();
    std::vector<Value> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (raster.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height, type,
                                             0, 0, nullptr) != CE_None) {
        std::ranges::fill(values, Value{});
    }
    return values;
}

}  // namespace

RasterDataset openRaster(const std::filesystem::path& path, int level) {
    registerGdalDrivers();
    std::string option = "OVERVIEW_LEVEL=" + std::to_string(level);
    std::array<const char*, 2> options{level < 0 ? nullptr : option.c_str(), nullptr};
    return RasterDataset{GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                           kPictureDrivers.data(), options.data())};
}

/// One resolution of a raster with its way to web Mercator.
struct TileReader::Level {
    RasterDataset owned;
    GDALDataset* raster = nullptr;
    double reduction = 1.0;  ///< pixels of the raster itself along one of its own
    bool tried = false;
    void* transformer = nullptr;

    ~Level() {
        if (transformer != nullptr) {
            GDALDestroyGenImgProjTransformer(transformer);
        }
    }
    bool findWay() {
        if (!tried && raster != nullptr) {
            char** options = CSLSetNameValue(nullptr, "DST_SRS", "EPSG:3857");
            transformer = GDALCreateGenImgProjTransformer2(raster, nullptr, options);
            CSLDestroy(options);
        }
        tried = true;
        return transformer != nullptr;
    }
};

TileReader::TileReader(RasterDataset raster, std::filesystem::path path)
    : raster_{std::move(raster)}, path_{std::move(path)} {
    levels_.push_back(std::make_unique<Level>());
    levels_.front()->raster = raster_.get();
    GDALRasterBand* band = raster_->GetRasterBand(1);
    for (int i = 0; !path_.empty() && band != nullptr && i < band->GetOverviewCount(); ++i) {
        levels_.push_back(std::make_unique<Level>());
        levels_.back()->reduction =
            double(raster_->GetRasterXSize()) / std::max(1, band->GetOverview(i)->GetXSize());
    }
}

TileReader::~TileReader() = default;

bool TileReader::place(double& pixelM, TileEdges& edges) {
    std::array<double, 6> suggested{};
    std::array<double, 4> extent{};
    int columns = 0;
    int rows = 0;
    if (!levels_.front()->findWay() ||
        GDALSuggestedWarpOutput2(raster_.get(), GDALGenImgProjTransform, levels_.front()->transformer,
                                 suggested.data(), &columns, &rows, extent.data(), 0) != CE_None) {
        return false;
    }
    pixelM = suggested[1];
    edges = {.west = extent[0], .south = extent[1], .east = extent[2], .north = extent[3]};
    return true;
}

TileReader::Level* TileReader::levelFor(double pixelM) {
    if (pixelM_ == 0.0) {
        TileEdges ignored;
        if (!place(pixelM_, ignored)) {
            return nullptr;
        }
    }
    // The coarsest that is not coarser than the tile, but for a little.
    std::size_t best = 0;
    for (std::size_t i = 1; i < levels_.size(); ++i) {
        if (levels_[i]->reduction * pixelM_ <= 1.2 * pixelM &&
            levels_[i]->reduction > levels_[best]->reduction) {
            best = i;
        }
    }
    Level& level = *levels_[best];
    if (best > 0 && level.raster == nullptr && !level.tried) {
        level.owned = openRaster(path_, static_cast<int>(best) - 1);
        level.raster = level.owned.get();
    }
    return level.findWay() ? &level : levels_.front()->findWay() ? levels_.front().get() : nullptr;
}

Result<RasterDataset> TileReader::tile(TileId id, const TileBands& bands, const std::string& where,
                                       const JobContext& job) {
    const GdalMessages messages;
    const double pixelM = mercatorPixelM(id.zoom);
    Level* level = levelFor(pixelM);
    if (level == nullptr) {
        return std::unexpected(damaged(where, messages.failure()));
    }
    const int side = kTileSide + 2 * bands.margin;
    const auto count = static_cast<int>(bands.colours.size());
    RasterDataset target{GetGDALDriverManager()->GetDriverByName("MEM")->Create(
        "", side, side, count + (bands.withAlpha ? 1 : 0), bands.type, nullptr)};
    const TileEdges edges = edgesOf(id);
    const double rim = bands.margin * pixelM;
    std::array affine{edges.west - rim, pixelM, 0.0, edges.north + rim, 0.0, -pixelM};
    if (!target || target->SetGeoTransform(affine.data()) != CE_None) {
        return std::unexpected(damaged(where, messages.failure()));
    }
    GDALSetGenImgProjTransformerDstGeoTransform(level->transformer, affine.data());

    const std::unique_ptr<GDALWarpOptions, WarpOptionsCloser> options{GDALCreateWarpOptions()};
    options->hSrcDS = level->raster;
    options->hDstDS = target.get();
    options->eResampleAlg = bands.smooth ? GRA_Bilinear : GRA_NearestNeighbour;
    if (bands.smooth && bands.margin > 0 && pixelM < pixelM_) {
        options->eResampleAlg = GRA_CubicSpline;
    }
    options->nBandCount = count;
    options->panSrcBands = static_cast<int*>(CPLMalloc(sizeof(int) * bands.colours.size()));
    options->panDstBands = static_cast<int*>(CPLMalloc(sizeof(int) * bands.colours.size()));
    for (int i = 0; i < count; ++i) {
        options->panSrcBands[i] = bands.colours[static_cast<std::size_t>(i)];
        options->panDstBands[i] = i + 1;
    }
    options->nSrcAlphaBand = bands.alpha;
    options->nDstAlphaBand = bands.withAlpha ? count + 1 : 0;
    setNoData(*options, *level->raster, bands);
    options->papszWarpOptions =
        CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", bands.withAlpha ? "0" : "NO_DATA");
    options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "UNIFIED_SRC_NODATA", "PARTIAL");
    if (pixelM < 2.1 * level->reduction * pixelM_) {
        // Four neighbours are enough, and many times as quick as a kernel that fits exactly.
        options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "XSCALE", "1");
        options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "YSCALE", "1");
    }
    if (bands.withAlpha && bands.type != GDT_Byte) {
        options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "DST_ALPHA_MAX", "255");
    }
    constexpr double kErrorPx = 0.125;
    options->pfnTransformer = GDALApproxTransform;
    options->pTransformerArg =
        GDALCreateApproxTransformer(GDALGenImgProjTransform, level->transformer, kErrorPx);
    options->pfnProgress = goOn;
    options->pProgressArg = const_cast<JobContext*>(&job);

    GDALWarpOperation operation;
    const bool drawn = operation.Initialize(options.get()) == CE_None &&
                       operation.ChunkAndWarpImage(0, 0, side, side) == CE_None;
    GDALDestroyApproxTransformer(options->pTransformerArg);
    options->pTransformerArg = nullptr;
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (!drawn || messages.failed()) {
        return std::unexpected(damaged(where, messages.failure()));
    }
    return target;
}

Result<RasterDataset> reducedRaster(GDALDataset& source, const std::vector<int>& bands, int longestSide,
                                    bool average, const std::string& where, const JobContext& job) {
    const int longest = std::max(source.GetRasterXSize(), source.GetRasterYSize());
    const auto reduced = [&](int side) {
        return std::to_string(
            std::max<std::int64_t>(1, std::int64_t{side} * std::min(longest, longestSide) / longest));
    };
    CPLStringList words;
    const auto add = [&](std::initializer_list<std::string> more) {
        std::ranges::for_each(more, [&](const std::string& word) { words.AddString(word.c_str()); });
    };
    add({"-of", "MEM", "-r", average ? "average" : "nearest", "-outsize", reduced(source.GetRasterXSize()),
         reduced(source.GetRasterYSize())});
    for (const int band : bands) {
        add({"-b", std::to_string(band)});
    }
    const GdalMessages messages;
    GDALTranslateOptions* options = GDALTranslateOptionsNew(words.List(), nullptr);
    GDALTranslateOptionsSetProgress(options, goOn, const_cast<JobContext*>(&job));
    GDALDatasetH made = GDALTranslate("", &source, options, nullptr);
    GDALTranslateOptionsFree(options);
    return checked(made, messages, where, job);
}

std::vector<std::uint8_t> bytesOf(GDALDataset& raster, int band) {
    return valuesOf<std::uint8_t>(raster, band, GDT_Byte);
}

std::vector<float> floatsOf(GDALDataset& raster, int band) {
    return valuesOf<float>(raster, band, GDT_Float32);
}

}  // namespace furrow
