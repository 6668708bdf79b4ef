#include "planner/gdal/elevation.h"

#include "planner/gdal/drivers.h"
#include "planner/gdal/raster_dataset.h"

#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <limits>

namespace furrow {

namespace {

constexpr double kFinestM = 1.0;
constexpr double kMostCells = 1024.0;
constexpr int kHeightBand = 1;

// Formats that are files of their own and name no others.
constexpr std::array kHeightDrivers{"GTiff", "AAIGrid", "SRTMHGT", "DTED", static_cast<const char*>(nullptr)};

Error noHeights(const std::filesystem::path& path, Message what) {
    return {.code = ErrorCode::ReadFailed,
            .what = std::move(what),
            .where = path.string(),
            .remedy = "give heights as a GeoTIFF or an ASCII grid"};
}

int goOn(double /*share*/, const char* /*message*/, void* job) {
    return static_cast<const JobContext*>(job)->stopRequested() ? FALSE : TRUE;
}

/// The raster's own resolution in metres, about.
double cellOf(GDALDataset& raster) {
    std::array<double, 6> transform{};
    if (raster.GetGeoTransform(transform.data()) != CE_None) {
        return kFinestM;
    }
    const double step =
        std::min(std::hypot(transform[1], transform[4]), std::hypot(transform[2], transform[5]));
    const OGRSpatialReference* const system = raster.GetSpatialRef();
    return system != nullptr && system->IsGeographic() != 0 ? step * 111e3 : step;
}

/// The raster warped onto the cells of a grid in the local frame; nothing where that fails.
RasterDataset warpedOnto(const ElevationGrid& grid, GDALDataset& raster, const LocalFrame& frame,
                         const JobContext& job) {
    // Cells of the result have their values in their middles.
    const double west = grid.origin.x - 0.5 * grid.cellM;
    const double south = grid.origin.y - 0.5 * grid.cellM;
    std::array<std::string, 20> words{
        "-of",
        "MEM",
        "-b",  // others would be warped, too, each into memory of its own
        std::to_string(kHeightBand),
        "-ot",
        "Float64",
        "-r",
        "bilinear",
        "-t_srs",
        frame.projString(),
        "-dstnodata",
        "nan",
        "-te",
        std::format("{}", west),
        std::format("{}", south),
        std::format("{}", west + static_cast<double>(grid.columns) * grid.cellM),
        std::format("{}", south + static_cast<double>(grid.rows) * grid.cellM),
        "-ts",
        std::format("{}", grid.columns),
        std::format("{}", grid.rows)};
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    CPLPushErrorHandler(CPLQuietErrorHandler);
    GDALWarpAppOptions* const options = GDALWarpAppOptionsNew(arguments.data(), nullptr);
    GDALWarpAppOptionsSetProgress(options, goOn, const_cast<JobContext*>(&job));
    GDALDatasetH source = &raster;
    RasterDataset warped{GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &source, options, nullptr))};
    GDALWarpAppOptionsFree(options);
    CPLPopErrorHandler();
    return warped;
}

bool readHeights(GDALDataset& warped, ElevationGrid& grid) {
    const int columns = static_cast<int>(grid.columns);
    for (std::size_t row = 0; row < grid.rows; ++row) {
        // Rasters begin in the north.
        double* const line = grid.heightsM.data() + (grid.rows - 1 - row) * grid.columns;
        if (warped.GetRasterBand(1)->RasterIO(GF_Read, 0, static_cast<int>(row), columns, 1, line, columns, 1,
                                              GDT_Float64, 0, 0, nullptr) != CE_None) {
            return false;
        }
    }
    return true;
}

}  // namespace

Result<ElevationGrid> readElevation(const std::filesystem::path& path, const LocalFrame& frame,
                                    const Bounds& box, const JobContext& job) {
    registerGdalDrivers();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        return std::unexpected(noHeights(path, "there is no such file"));
    }
    CPLPushErrorHandler(CPLQuietErrorHandler);
    const RasterDataset raster{
        GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, kHeightDrivers.data())};
    CPLPopErrorHandler();
    if (!raster || raster->GetRasterCount() == 0) {
        return std::unexpected(noHeights(path, "it is no raster of heights"));
    }
    if (raster->GetSpatialRef() == nullptr) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "it does not say in which coordinate system it is",
                                     .where = path.string(),
                                     .remedy = "export it again with its coordinate system"});
    }
    const double cellM =
        std::max({kFinestM, cellOf(*raster), std::max(box.width(), box.height()) / kMostCells});
    ElevationGrid grid{.origin = box.min,
                       .cellM = cellM,
                       .columns = static_cast<std::size_t>(std::ceil(box.width() / cellM)) + 1,
                       .rows = static_cast<std::size_t>(std::ceil(box.height() / cellM)) + 1,
                       .heightsM = {}};
    grid.heightsM.assign(grid.columns * grid.rows, std::numeric_limits<double>::quiet_NaN());
    const RasterDataset warped = warpedOnto(grid, *raster, frame, job);
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (!warped || !readHeights(*warped, grid)) {
        return std::unexpected(noHeights(path, "its heights cannot be read"));
    }
    if (std::ranges::none_of(grid.heightsM, [](double heightM) { return std::isfinite(heightM); })) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "it has no heights where the field is",
                                     .where = path.string(),
                                     .remedy = "give heights that cover the field"});
    }
    return grid;
}

}  // namespace furrow
