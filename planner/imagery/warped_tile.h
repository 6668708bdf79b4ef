#pragma once

#include "planner/imagery/tile_pixels.h"

#include <gdal_priv.h>

#include <memory>
#include <string>
#include <vector>

namespace furrow {

struct DatasetCloser {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using RasterDataset = std::unique_ptr<GDALDataset, DatasetCloser>;

/// What of a raster is drawn on a tile, and how.
struct WarpRequest {
    TileId id;
    int margin = 0;  ///< pixels more on each side
    std::vector<int> bands;
    std::string type = "Byte";
    std::string resampling = "bilinear";
    bool alpha = true;  ///< a band more that says where there is something; without it NaN does
};

/// A raster on a tile, in web Mercator, read from the overview that fits. ReadFailed with GDAL's reason; Cancelled.
Result<RasterDataset> warpedTile(GDALDataset& source, const WarpRequest& request, const std::string& where,
                                 const JobContext& job);

/// The whole of these bands in memory, at most this large. Errors as above.
Result<RasterDataset> reducedRaster(GDALDataset& source, const std::vector<int>& bands, int longestSide, bool average,
                                    const std::string& where, const JobContext& job);

/// One band of a raster in memory.
std::vector<std::uint8_t> bytesOf(GDALDataset& raster, int band);
std::vector<float> floatsOf(GDALDataset& raster, int band);

}  // namespace furrow
