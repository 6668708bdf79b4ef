#include "planner/imagery/imagery.h"

#include "planner/core/file_error.h"
#include "planner/gdal/messages.h"
#include "planner/imagery/raster_imagery.h"
#include "planner/imagery/tile_folder.h"

#include <algorithm>
#include <mutex>

namespace furrow {

namespace {

/// Blocks that GDAL keeps decoded; tiles are kept by whoever shows them.
constexpr GIntBig kBlockCacheBytes = GIntBig{16} << 20;

void limitBlockCache() {
    static std::once_flag once;
    std::call_once(once, [] { GDALSetCacheMax64(kBlockCacheBytes); });
}

/// A mask of what is worked has few values; where it cannot be read, the reader of masks says why.
bool isMask(GDALDataset& raster) {
    constexpr int kSampleSide = 128;
    constexpr std::size_t kMostValues = 16;
    const auto sample = reducedRaster(raster, {1}, kSampleSide, false, {}, {});
    if (!sample) {
        return true;
    }
    std::vector<float> values = floatsOf(**sample, 1);
    std::ranges::sort(values);
    return static_cast<std::size_t>(std::ranges::unique(values).begin() - values.begin()) <= kMostValues;
}

}  // namespace

Result<std::shared_ptr<const Imagery>> openImagery(const std::filesystem::path& path,
                                                   std::optional<bool> rowsFromSouth) {
    limitBlockCache();
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        return std::unexpected(readFailed(path.string(), "there is no such file or folder",
                                          "put it back, or choose another one"));
    }
    if (std::filesystem::is_directory(status)) {
        return TileFolder::open(path, rowsFromSouth);
    }
    if (!std::filesystem::is_regular_file(status)) {
        return std::unexpected(
            readFailed(path.string(), "it is no file", "choose a file or a folder of tiles"));
    }
    if (std::filesystem::file_size(path, error) == 0) {
        return std::unexpected(readFailed(path.string(), "the file is empty", "copy or export it again"));
    }
    return RasterImagery::open(path);
}

bool isImagery(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        return TileFolder::isOne(path);
    }
    if (!std::filesystem::is_regular_file(path, error)) {
        return false;
    }
    if (path.extension() == ".mbtiles") {
        return true;
    }
    const GdalMessages messages;
    const RasterDataset raster = openRaster(path);
    return raster && raster->GetRasterCount() > 0 && (raster->GetRasterCount() > 1 || !isMask(*raster));
}

}  // namespace furrow
