#include "planner/imagery/warped_tile.h"

#include "planner/io/file_error.h"
#include "planner/io/gdal_messages.h"

#include <gdal_utils.h>

#include <algorithm>
#include <cstdint>
#include <format>

namespace furrow {

namespace {

int goOn(double /*share*/, const char* /*message*/, void* job) {
    return static_cast<const JobContext*>(job)->stopRequested() ? FALSE : TRUE;
}

Error damaged(const std::string& where, const std::string& reason) {
    return readFailed(where, reason.empty() ? "a part of it cannot be read" : "a part of it is damaged: " + reason,
                      "copy or export the file again");
}

/// The words of a command line as GDAL's options take them.
class Words {
public:
    void add(std::initializer_list<std::string> words) { words_.insert(words_.end(), words); }
    char** list() {
        pointers_.clear();
        for (std::string& word : words_) {
            pointers_.push_back(word.data());
        }
        pointers_.push_back(nullptr);
        return pointers_.data();
    }

private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

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

}  // namespace

Result<RasterDataset> warpedTile(GDALDataset& source, const WarpRequest& request, const std::string& where,
                                 const JobContext& job) {
    const TileEdges edges = edgesOf(request.id);
    const double rim = request.margin * mercatorPixelM(request.id.zoom);
    const std::string side = std::to_string(kTileSide + 2 * request.margin);
    Words words;
    words.add({"-of", "MEM", "-t_srs", "EPSG:3857", "-r", request.resampling, "-ot", request.type, "-te",
               std::format("{}", edges.west - rim), std::format("{}", edges.south - rim),
               std::format("{}", edges.east + rim), std::format("{}", edges.north + rim), "-ts", side, side});
    if (request.alpha) {
        words.add({"-dstalpha"});
    } else {
        words.add({"-dstnodata", "nan"});
    }
    for (const int band : request.bands) {
        words.add({"-b", std::to_string(band)});
    }
    const GdalMessages messages;
    GDALWarpAppOptions* options = GDALWarpAppOptionsNew(words.list(), nullptr);
    GDALWarpAppOptionsSetProgress(options, goOn, const_cast<JobContext*>(&job));
    GDALDatasetH handle = &source;
    GDALDatasetH made = GDALWarp("", nullptr, 1, &handle, options, nullptr);
    GDALWarpAppOptionsFree(options);
    return checked(made, messages, where, job);
}

Result<RasterDataset> reducedRaster(GDALDataset& source, const std::vector<int>& bands, int longestSide, bool average,
                                    const std::string& where, const JobContext& job) {
    const int longest = std::max(source.GetRasterXSize(), source.GetRasterYSize());
    const auto reduced = [&](int side) {
        return std::to_string(std::max<std::int64_t>(1, std::int64_t{side} * std::min(longest, longestSide) / longest));
    };
    Words words;
    words.add({"-of", "MEM", "-r", average ? "average" : "nearest", "-outsize", reduced(source.GetRasterXSize()),
               reduced(source.GetRasterYSize())});
    for (const int band : bands) {
        words.add({"-b", std::to_string(band)});
    }
    const GdalMessages messages;
    GDALTranslateOptions* options = GDALTranslateOptionsNew(words.list(), nullptr);
    GDALTranslateOptionsSetProgress(options, goOn, const_cast<JobContext*>(&job));
    GDALDatasetH made = GDALTranslate("", &source, options, nullptr);
    GDALTranslateOptionsFree(options);
    return checked(made, messages, where, job);
}

std::vector<std::uint8_t> bytesOf(GDALDataset& raster, int band) {
    const int width = raster.GetRasterXSize();
    const int height = raster.GetRasterYSize();
    std::vector<std::uint8_t> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (raster.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height, GDT_Byte, 0, 0,
                                             nullptr) != CE_None) {
        std::ranges::fill(values, std::uint8_t{0});
    }
    return values;
}

std::vector<float> floatsOf(GDALDataset& raster, int band) {
    const int width = raster.GetRasterXSize();
    const int height = raster.GetRasterYSize();
    std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (raster.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height, GDT_Float32, 0,
                                             0, nullptr) != CE_None) {
        std::ranges::fill(values, 0.0F);
    }
    return values;
}

}  // namespace furrow
