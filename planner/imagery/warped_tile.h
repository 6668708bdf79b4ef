#pragma once

#include "planner/gdal/raster_dataset.h"
#include "planner/imagery/tile_pixels.h"

#include <gdal_priv.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace furrow {

/// What of a raster is drawn on its tiles, and how.
struct TileBands {
    std::vector<int> colours;  ///< bands that are read, from 1
    int alpha = 0;             ///< the band that says where there is something; 0 for none
    GDALDataType type = GDT_Byte;
    int margin = 0;         ///< pixels more on each side of a tile
    bool withAlpha = true;  ///< a band more that says where there is something; without it NaN does
    bool smooth = true;     ///< mixes neighbours; not for values that are numbers of colours
};

/// Reads tiles from one raster, of its overviews the one that fits. For one thread at a time. Finding the way
/// from one projection to another takes many times as long as a tile, so it is kept.
class TileReader {
public:
    /// @param path  of the raster, to open its overviews by; empty for none
    TileReader(RasterDataset raster, std::filesystem::path path);
    ~TileReader();
    TileReader(const TileReader&) = delete;
    TileReader& operator=(const TileReader&) = delete;

    GDALDataset& raster() { return *raster_; }
    /// Pixels of the raster itself in web Mercator are this wide, about; what it covers. False where it has
    /// no place.
    bool place(double& pixelM, TileEdges& edges);

    /// A raster in memory with the bands asked for. ReadFailed with GDAL's reason, at `where`; Cancelled.
    Result<RasterDataset> tile(TileId id, const TileBands& bands, const std::string& where,
                               const JobContext& job);

private:
    struct Level;
    Level* levelFor(double pixelM);

    RasterDataset raster_;
    std::filesystem::path path_;
    double pixelM_ = 0.0;
    std::vector<std::unique_ptr<Level>> levels_;  ///< the raster itself, then its overviews; opened as needed
};

/// A raster of a file as GDAL opens it, from formats that are files of their own and name no others; of
/// overview `level`, or the raster itself. Null where it is none.
RasterDataset openRaster(const std::filesystem::path& path, int level = -1);

/// The whole of these bands in memory, at most this large. Errors as above.
Result<RasterDataset> reducedRaster(GDALDataset& source, const std::vector<int>& bands, int longestSide,
                                    bool average, const std::string& where, const JobContext& job);

/// One band of a raster in memory.
std::vector<std::uint8_t> bytesOf(GDALDataset& raster, int band);
std::vector<float> floatsOf(GDALDataset& raster, int band);

}  // namespace furrow
