#pragma once

#include "planner/imagery/warped_tile.h"

#include <array>
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

    Result<void> place(TileReader& reader);
    Result<void> chooseBands(GDALDataset& raster);
    Result<void> measureHeights(GDALDataset& raster);
    Result<void> measureRange(GDALDataset& raster);
    Result<void> unchanged() const;

    Result<std::unique_ptr<TileReader>> takeReader() const;
    /// From the raster itself, or for coarse tiles from the reduced one.
    Result<RasterDataset> read(TileId id, const JobContext& job) const;
    Result<void> reduce(TileReader& reader, const JobContext& job) const;
    bool isInside(TileId id) const;
    TilePicture pictureOf(GDALDataset& warped) const;

    std::filesystem::path path_;
    std::filesystem::file_time_type written_;
    std::uintmax_t bytes_ = 0;
    TileEdges edges_;
    std::vector<int> bands_;
    int alpha_ = 0;      ///< its band; 0 for none
    bool wide_ = false;  ///< values beyond a byte, drawn between these two
    double darkest_ = 0.0;
    double lightest_ = 255.0;
    std::vector<std::array<std::uint8_t, 4>> palette_;
    double slope_ = 0.0;
    /// Tiles up to this zoom are made of the reduced raster; -1 for none.
    int reducedZoom_ = -1;

    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<TileReader>> readers_;
    mutable std::mutex reducedMutex_;
    mutable std::unique_ptr<TileReader> reduced_;
};

}  // namespace furrow
