#include "planner/gdal/worked_patches.h"

#include "planner/core/file_error.h"
#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"
#include "planner/gdal/raster_dataset.h"
#include "planner/geometry/simplify.h"

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kMostPixels = 1e8;
constexpr double kSmoothingPixels = 0.75;

/// 1 where it is worked, 0 elsewhere.
std::optional<std::vector<GByte>> maskOf(GDALDataset& raster) {
    const int width = raster.GetRasterXSize();
    const int height = raster.GetRasterYSize();
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    GDALRasterBand* band = raster.GetRasterBand(1);
    std::vector<GByte> mask(count);
    std::vector<float> row(static_cast<std::size_t>(width));
    std::vector<GByte> valid(static_cast<std::size_t>(width));
    // Knows of values for nothing and of transparency.
    GDALRasterBand* validity = band->GetMaskBand();
    for (int y = 0; y < height; ++y) {
        if (band->RasterIO(GF_Read, 0, y, width, 1, row.data(), width, 1, GDT_Float32, 0, 0, nullptr) !=
                CE_None ||
            validity->RasterIO(GF_Read, 0, y, width, 1, valid.data(), width, 1, GDT_Byte, 0, 0, nullptr) !=
                CE_None) {
            return std::nullopt;
        }
        for (std::size_t x = 0; x < row.size(); ++x) {
            const bool worked = valid[x] != 0 && std::isfinite(row[x]) && row[x] != 0.0F;
            mask[static_cast<std::size_t>(y) * row.size() + x] = worked ? 1 : 0;
        }
    }
    return mask;
}

/// Polygons of worked pixels, in pixels.
std::vector<std::unique_ptr<OGRGeometry>> patchesOf(std::vector<GByte>& mask, int width, int height) {
    const RasterDataset memory{
        GetGDALDriverManager()->GetDriverByName("MEM")->Create("", width, height, 1, GDT_Byte, nullptr)};
    GDALRasterBand* band = memory->GetRasterBand(1);
    std::vector<std::unique_ptr<OGRGeometry>> patches;
    if (band->RasterIO(GF_Write, 0, 0, width, height, mask.data(), width, height, GDT_Byte, 0, 0, nullptr) !=
        CE_None) {
        return patches;
    }
    const RasterDataset shapes{
        GetGDALDriverManager()->GetDriverByName("Memory")->Create("", 0, 0, 0, GDT_Unknown, nullptr)};
    OGRLayer* layer = shapes->CreateLayer("patches", nullptr, wkbPolygon, nullptr);
    if (GDALPolygonize(band, band, layer, -1, nullptr, nullptr, nullptr) != CE_None) {
        return patches;
    }
    for (const auto& feature : *layer) {
        patches.emplace_back(feature->StealGeometry());
    }
    return patches;
}

/// From pixels to WGS84.
class Placing {
public:
    static Result<Placing> of(GDALDataset& raster, const std::string& where) {
        Placing made;
        if (raster.GetGeoTransform(made.affine_.data()) != CE_None) {
            return std::unexpected(inputRefused(where, "the picture does not say where it lies",
                                                "give a GeoTIFF, or a world file (.pgw) beside the PNG"));
        }
        const OGRSpatialReference* system = raster.GetSpatialRef();
        if (system == nullptr || system->IsEmpty()) {
            const GeoPoint corner = made.affine({0.0, 0.0});
            const GeoPoint opposite = made.affine(
                {static_cast<double>(raster.GetRasterXSize()), static_cast<double>(raster.GetRasterYSize())});
            for (const GeoPoint& point : {corner, opposite}) {
                if (!(std::abs(point.lonDeg) <= 180.0 && std::abs(point.latDeg) <= 90.0)) {
                    return std::unexpected(
                        inputRefused(where, "the picture does not say which coordinate system it uses",
                                     "save it as GeoTIFF, or with a world file in degrees"));
                }
            }
            return made;
        }
        OGRSpatialReference wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        OGRSpatialReference own{*system};
        own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        made.transform_.reset(OGRCreateCoordinateTransformation(&own, &wgs84));
        if (!made.transform_) {
            return std::unexpected(inputRefused(where, "its coordinate system cannot be turned into WGS84",
                                                "save it again in WGS84"));
        }
        return made;
    }

    std::optional<GeoPoint> operator()(Point pixel) const {
        GeoPoint point = affine(pixel);
        if (transform_ && transform_->Transform(1, &point.lonDeg, &point.latDeg) == 0) {
            return std::nullopt;
        }
        return point;
    }

private:
    struct TransformCloser {
        void operator()(OGRCoordinateTransformation* transform) const {
            OGRCoordinateTransformation::DestroyCT(transform);
        }
    };
    GeoPoint affine(Point pixel) const {
        return {affine_[0] + pixel.x * affine_[1] + pixel.y * affine_[2],
                affine_[3] + pixel.x * affine_[4] + pixel.y * affine_[5]};
    }
    std::array<double, 6> affine_{};
    std::unique_ptr<OGRCoordinateTransformation, TransformCloser> transform_;
};

/// Empty where it is smoothed away or has no place.
GeoRing smoothRing(const OGRLinearRing& ring, const Placing& placing) {
    Polyline pixels;
    for (int i = 0; i < ring.getNumPoints(); ++i) {
        pixels.push_back({ring.getX(i), ring.getY(i)});
    }
    // The ring as two lines, so that the end that they share is a far one.
    const auto half = static_cast<std::ptrdiff_t>(pixels.size() / 2);
    Polyline smooth = simplified({pixels.begin(), pixels.begin() + half + 1}, metres(kSmoothingPixels));
    const Polyline second = simplified({pixels.begin() + half, pixels.end()}, metres(kSmoothingPixels));
    smooth.insert(smooth.end(), second.begin() + 1, second.end() - 1);
    GeoRing placed;
    for (const Point& pixel : smooth) {
        const auto point = placing(pixel);
        if (!point) {
            return {};
        }
        placed.push_back(*point);
    }
    return placed.size() >= 3 ? placed : GeoRing{};
}

}  // namespace

Result<std::vector<GeoPolygon>> workedPatches(const std::filesystem::path& path, const JobContext& job) {
    registerGdalDrivers();
    const GdalMessages messages;
    const std::string name = path.filename().string();
    constexpr const char* kDrivers[] = {"GTiff", "PNG", nullptr};
    const RasterDataset raster{GDALDataset::Open(std::filesystem::absolute(path).c_str(),
                                                 GDAL_OF_RASTER | GDAL_OF_READONLY, kDrivers, nullptr,
                                                 nullptr)};
    if (!raster || raster->GetRasterCount() == 0) {
        return std::unexpected(readFailed(
            name, message("the picture cannot be read ({})", messages.failure()), "export it again"));
    }
    const int width = raster->GetRasterXSize();
    const int height = raster->GetRasterYSize();
    if (static_cast<double>(width) * height > kMostPixels) {
        return std::unexpected(inputRefused(name, message("it has {} by {} pixels", width, height),
                                            "give a picture of at most 100 million pixels"));
    }
    const auto placing = Placing::of(*raster, name);
    if (!placing) {
        return std::unexpected(placing.error());
    }
    auto mask = maskOf(*raster);
    if (!mask) {
        return std::unexpected(readFailed(name, "the picture is damaged", "export it again"));
    }
    std::vector<GeoPolygon> patches;
    for (const auto& patch : patchesOf(*mask, width, height)) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const OGRPolygon& polygon = *patch->toPolygon();
        GeoPolygon placed{.outer = smoothRing(*polygon.getExteriorRing(), *placing), .holes = {}};
        for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
            if (GeoRing hole = smoothRing(*polygon.getInteriorRing(i), *placing); !hole.empty()) {
                placed.holes.push_back(std::move(hole));
            }
        }
        if (!placed.outer.empty()) {
            patches.push_back(std::move(placed));
        }
    }
    return patches;
}

}  // namespace furrow
