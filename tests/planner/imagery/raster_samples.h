#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <QString>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

// Small rasters made by GDAL itself, so that what is read is known.
namespace furrow::test {

struct RasterShape {
    int width = 0;
    int height = 0;
    int epsg = 0;                    ///< 0 for no coordinate system
    std::array<double, 6> affine{};  ///< as GDAL's geotransform
    GDALDataType type = GDT_Byte;
    std::vector<const char*> options;  ///< of the GeoTIFF
};

/// Writes a GeoTIFF; `value(band, column, row)`, bands from 0.
inline bool writeTiff(const QString& path, const RasterShape& shape, int bands,
                      const std::function<double(int, int, int)>& value) {
    GDALAllRegister();
    std::vector<char*> options;
    options.reserve(shape.options.size() + 1);
    for (const char* option : shape.options) {
        options.push_back(const_cast<char*>(option));
    }
    options.push_back(nullptr);
    GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path.toUtf8().constData(), shape.width, shape.height, bands, shape.type, options.data());
    if (dataset == nullptr) {
        return false;
    }
    if (shape.epsg != 0) {
        OGRSpatialReference system;
        system.importFromEPSG(shape.epsg);
        dataset->SetSpatialRef(&system);
        std::array<double, 6> affine = shape.affine;
        dataset->SetGeoTransform(affine.data());
    }
    bool written = true;
    std::vector<double> row(static_cast<std::size_t>(shape.width));
    for (int band = 0; band < bands; ++band) {
        for (int y = 0; y < shape.height; ++y) {
            for (int x = 0; x < shape.width; ++x) {
                row[static_cast<std::size_t>(x)] = value(band, x, y);
            }
            written = written && dataset->GetRasterBand(band + 1)->RasterIO(
                                     GF_Write, 0, y, shape.width, 1, row.data(), shape.width, 1, GDT_Float64,
                                     0, 0, nullptr) == CE_None;
        }
    }
    return GDALClose(dataset) == CE_None && written;
}

/// Writes a square PNG of one colour.
inline bool writePng(const QString& path, int side, std::array<std::uint8_t, 4> colour) {
    GDALAllRegister();
    GDALDataset* memory =
        GetGDALDriverManager()->GetDriverByName("MEM")->Create("", side, side, 4, GDT_Byte, nullptr);
    for (int band = 0; band < 4; ++band) {
        memory->GetRasterBand(band + 1)->Fill(colour[static_cast<std::size_t>(band)]);
    }
    GDALDataset* png = GetGDALDriverManager()->GetDriverByName("PNG")->CreateCopy(
        path.toUtf8().constData(), memory, FALSE, nullptr, nullptr, nullptr);
    const bool written = png != nullptr;
    if (png != nullptr) {
        GDALClose(png);
    }
    GDALClose(memory);
    return written;
}

/// Where a place lies in web Mercator, in pixels of 256-pixel tiles at a zoom: the formula of the projection
/// itself.
struct TilePlace {
    double x = 0.0;
    double y = 0.0;
    int column() const { return static_cast<int>(x / 256.0); }
    int row() const { return static_cast<int>(y / 256.0); }
};

inline TilePlace tilePlace(double lonDeg, double latDeg, int zoom) {
    const double pixels = 256.0 * static_cast<double>(1 << zoom);
    const double latRad = latDeg * std::numbers::pi / 180.0;
    return {(lonDeg + 180.0) / 360.0 * pixels,
            (0.5 - std::log(std::tan(std::numbers::pi / 4.0 + latRad / 2.0)) / (2.0 * std::numbers::pi)) *
                pixels};
}

/// Northing of UTM on its central meridian, m: 0.9996 times the meridian arc of WGS84 by Helmert's series
/// (third flattening n; Snyder 1987, Map Projections, eq. 3-21).
inline double northingOnMeridian(double latDeg) {
    constexpr double a = 6378137.0;
    constexpr double e2 = 0.00669437999014;
    const double p = latDeg * std::numbers::pi / 180.0;
    return 0.9996 * a *
           ((1.0 - e2 / 4.0 - 3.0 * e2 * e2 / 64.0 - 5.0 * e2 * e2 * e2 / 256.0) * p -
            (3.0 * e2 / 8.0 + 3.0 * e2 * e2 / 32.0 + 45.0 * e2 * e2 * e2 / 1024.0) * std::sin(2.0 * p) +
            (15.0 * e2 * e2 / 256.0 + 45.0 * e2 * e2 * e2 / 1024.0) * std::sin(4.0 * p) -
            (35.0 * e2 * e2 * e2 / 3072.0) * std::sin(6.0 * p));
}

}  // namespace furrow::test
