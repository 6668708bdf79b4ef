#pragma once

#include "planner/imagery/warped_tile.h"

#include <chrono>
#include <mutex>

namespace furrow {

/// A raster that GDAL reads and warps. Each thread that asks at the same time has a handle of its own.
class RasterImagery final : public Imagery {
public:
    /// As openImagery.
    static Result<std::shared_ptr<const Imagery>> open(const std::filesystem::path& path);

    Result<std::optional<TilePicture>> tile(TileId id, const JobContext& job) const override;
    double contourStepM(int zoom) const override;

private:
    explicit RasterImagery(std::filesystem::path path) : path_{std::move(path)} {}

    Result<void> place(GDALDataset& raster);
    Result<void> chooseBands(GDALDataset& raster);
    Result<void> measureHeights(GDALDataset& raster);
    Result<void> measureRange(GDALDataset& raster);
    Result<void> unchanged() const;

    /// The raster's own, or the reduced one for coarse tiles.
    Result<RasterDataset> warped(const WarpRequest& request, const JobContext& job) const;
    Result<RasterDataset> takeHandle() const;
    bool isInside(TileId id) const;
    TilePicture pictureOf(GDALDataset& warped) const;

    std::filesystem::path path_;
    std::filesystem::file_time_type written_;
    std::uintmax_t bytes_ = 0;
    TileEdges edges_;
    std::vector<int> bands_;
    bool wide_ = false;  ///< values beyond a byte, drawn between these two
    double darkest_ = 0.0;
    double lightest_ = 255.0;
    std::vector<std::array<std::uint8_t, 4>> palette_;
    double slope_ = 0.0;
    /// Tiles up to this zoom are made of the reduced raster; -1 for none.
    int reducedZoom_ = -1;

    mutable std::mutex mutex_;
    mutable std::vector<RasterDataset> handles_;
    mutable std::mutex reducedMutex_;
    mutable RasterDataset reduced_;
};

/// A raster of a file as GDAL opens it, from formats that are files of their own and name no others.
/// Null where it is none.
RasterDataset openRaster(const std::filesystem::path& path);

}  // namespace furrow
