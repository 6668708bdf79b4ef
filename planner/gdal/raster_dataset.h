#pragma once

#include <gdal_priv.h>

#include <memory>

namespace furrow {

struct DatasetCloser {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// A raster in a file or in memory, or shapes in memory; closed at the end.
using RasterDataset = std::unique_ptr<GDALDataset, DatasetCloser>;

}  // namespace furrow
