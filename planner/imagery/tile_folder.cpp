#include "planner/imagery/tile_folder.h"

#include "planner/core/file_error.h"
#include "planner/core/text_file.h"
#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"
#include "planner/imagery/tile_pixels.h"
#include "planner/imagery/warped_tile.h"
#include "planner/io/files/file_folder.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace furrow {

namespace fs = std::filesystem;

namespace {

constexpr std::array kExtensions{".png", ".jpg", ".jpeg", ".webp"};
constexpr std::array kTileDrivers{"PNG", "JPEG", "WEBP", static_cast<const char*>(nullptr)};
constexpr int kLargestSide = 1024;
/// Columns whose rows are read to find how far the tiles reach.
constexpr std::size_t kSampledColumns = 64;

std::optional<int> numberOf(const std::string& name) {
    int number = -1;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    return error == std::errc{} && end == name.data() + name.size() && number >= 0 ? std::optional{number}
                                                                                   : std::nullopt;
}

/// Subfolders whose names are numbers, ascending.
std::vector<int> numberedFolders(const fs::path& folder) {
    std::vector<int> numbers;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{folder, error}) {
        if (const auto number = numberOf(entry.path().filename().string());
            number && entry.is_directory(error)) {
            numbers.push_back(*number);
        }
    }
    std::ranges::sort(numbers);
    return numbers;
}

struct Tiles {
    std::vector<int> rows;  ///< ascending
    std::string extension;
};

Tiles tilesIn(const fs::path& column) {
    Tiles tiles;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{column, error}) {
        const std::string extension = entry.path().extension().string();
        const auto row = numberOf(entry.path().stem().string());
        if (row && std::ranges::contains(kExtensions, extension)) {
            tiles.rows.push_back(*row);
            tiles.extension = extension;
        }
    }
    std::ranges::sort(tiles.rows);
    return tiles;
}

std::vector<int> zoomsIn(const fs::path& folder) {
    std::vector<int> zooms = numberedFolders(folder);
    std::erase_if(zooms, [](int zoom) { return zoom > kFinestTileZoom; });
    return zooms;
}

struct Extent {
    int west = 0;
    int east = 0;
    int low = 0;
    int high = 0;
    std::string extension;  ///< empty where there are no tiles
};

Extent extentOf(const fs::path& zoomFolder) {
    Extent extent;
    const std::vector<int> columns = numberedFolders(zoomFolder);
    const std::size_t step = std::max<std::size_t>(1, columns.size() / kSampledColumns);
    for (std::size_t i = 0; i < columns.size(); i += step) {
        const Tiles tiles = tilesIn(zoomFolder / std::to_string(columns[i]));
        if (tiles.rows.empty()) {
            continue;
        }
        const bool first = extent.extension.empty();
        extent.low = first ? tiles.rows.front() : std::min(extent.low, tiles.rows.front());
        extent.high = first ? tiles.rows.back() : std::max(extent.high, tiles.rows.back());
        extent.extension = tiles.extension;
    }
    if (!columns.empty()) {
        extent.west = columns.front();
        extent.east = columns.back();
    }
    return extent;
}

/// What the files that tile makers write beside their tiles say.
bool saysRowsFromSouth(const fs::path& folder) {
    std::error_code error;
    if (fs::is_regular_file(folder / "tilemapresource.xml", error)) {
        return true;
    }
    for (const char* name : {"metadata.json", "tiles.json", "tilejson.json"}) {
        if (const auto text = fileStart(folder / name, 65536)) {
            const std::size_t scheme = text->find("\"scheme\"");
            return scheme != std::string::npos && text->find("\"tms\"", scheme) < scheme + 24;
        }
    }
    return false;
}

/// Where a picture shows something: from an alpha band, or a value that stands for nothing.
std::vector<std::uint8_t> maskOf(GDALDataset& raster) {
    const int width = raster.GetRasterXSize();
    const int height = raster.GetRasterYSize();
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    if (raster.GetRasterBand(1)->GetMaskBand()->RasterIO(GF_Read, 0, 0, width, height, mask.data(), width,
                                                         height, GDT_Byte, 0, 0, nullptr) != CE_None) {
        std::ranges::fill(mask, std::uint8_t{255});
    }
    return mask;
}

}  // namespace

bool TileFolder::isOne(const fs::path& folder) {
    for (const int zoom : zoomsIn(folder)) {
        for (const int column : numberedFolders(folder / std::to_string(zoom))) {
            if (!tilesIn(folder / std::to_string(zoom) / std::to_string(column)).rows.empty()) {
                return true;
            }
        }
    }
    return false;
}

Result<std::shared_ptr<const Imagery>> TileFolder::open(const fs::path& folder,
                                                        std::optional<bool> rowsFromSouth) {
    const std::vector<int> zooms = zoomsIn(folder);
    const Extent extent = zooms.empty() ? Extent{} : extentOf(folder / std::to_string(zooms.back()));
    if (extent.extension.empty()) {
        return std::unexpected(readFailed(folder.string(), "there are no tiles in this folder",
                                          "choose the folder that holds the folders of the zooms, 0 to 24"));
    }
    if (const auto text = fileStart(folder / "tilemapresource.xml", 4096);
        text && text->contains("geodetic")) {
        return std::unexpected(
            inputRefused(folder.string(), "its tiles are in degrees, not in web Mercator",
                         "make them again with the profile mercator, or give the raster itself"));
    }
    std::shared_ptr<TileFolder> made{new TileFolder{folder, extent.extension}};
    ImageryFacts& facts = made->facts_;
    facts.isTileFolder = true;
    facts.rowsFromSouth = rowsFromSouth.value_or(saysRowsFromSouth(folder));
    facts.coarsestZoom = zooms.front();
    facts.finestZoom = zooms.back();
    const int last = (1 << zooms.back()) - 1;
    const int north = facts.rowsFromSouth ? last - extent.high : extent.low;
    const int south = facts.rowsFromSouth ? last - extent.low : extent.high;
    const TileEdges first = edgesOf({zooms.back(), extent.west, north});
    const TileEdges opposite = edgesOf({zooms.back(), extent.east, south});
    facts.southWest = fromMercator(first.west, opposite.south);
    facts.northEast = fromMercator(opposite.east, first.north);
    return made;
}

Result<std::optional<TilePicture>> TileFolder::tile(TileId id, const JobContext& /*job*/) const {
    const int row = facts_.rowsFromSouth ? (1 << id.zoom) - 1 - id.row : id.row;
    const fs::path path =
        folder_ / std::to_string(id.zoom) / std::to_string(id.column) / (std::to_string(row) + extension_);
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return fs::is_directory(folder_, error)
                   ? Result<std::optional<TilePicture>>{std::nullopt}
                   : std::unexpected(readFailed(folder_.string(), "the folder is not there any more",
                                                "put it back, or remove the layer"));
    }
    registerGdalDrivers();
    const GdalMessages messages;
    const RasterDataset raster{
        GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, kTileDrivers.data())};
    const int side = raster ? raster->GetRasterXSize() : 0;
    if (!raster || raster->GetRasterYSize() != side || side > kLargestSide) {
        return std::unexpected(readFailed(path.string(), "a tile is damaged", "make the tiles again"));
    }
    std::vector<std::vector<std::uint8_t>> bands;
    for (int band = 1; band <= raster->GetRasterCount(); ++band) {
        bands.push_back(bytesOf(*raster, band));
    }
    const std::vector<std::uint8_t> alpha = maskOf(*raster);
    if (messages.failed()) {
        return std::unexpected(readFailed(path.string(), "a tile is damaged", "make the tiles again"));
    }
    const GDALColorTable* table = raster->GetRasterBand(1)->GetColorTable();
    TilePicture picture{.side = side, .rgba = {}};
    picture.rgba.reserve(alpha.size() * 4);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        std::array<std::uint8_t, 3> colour{};
        std::uint8_t opacity = alpha[i];
        if (table != nullptr) {
            const GDALColorEntry* entry =
                table->GetColorEntry(std::min<int>(bands[0][i], table->GetColorEntryCount() - 1));
            colour = {static_cast<std::uint8_t>(entry->c1), static_cast<std::uint8_t>(entry->c2),
                      static_cast<std::uint8_t>(entry->c3)};
            opacity = static_cast<std::uint8_t>(entry->c4);
        } else {
            const bool grey = bands.size() < 3;
            colour = {bands[0][i], bands[grey ? 0 : 1][i], bands[grey ? 0 : 2][i]};
        }
        addPixel(picture.rgba, colour, opacity);
    }
    return picture;
}

}  // namespace furrow
