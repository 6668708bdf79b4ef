#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace furrow {

/// A square of web Mercator: the world is one tile at zoom 0 and is halved with each zoom. Rows count from
/// the north.
struct TileId {
    int zoom = 0;
    int column = 0;
    int row = 0;

    friend auto operator<=>(const TileId&, const TileId&) = default;
};

/// The pixels of a tile: red, green, blue, alpha of one byte each, colours multiplied by alpha; rows from the
/// north.
struct TilePicture {
    int side = 0;  ///< pixels along an edge
    std::vector<std::uint8_t> rgba;
};

enum class ImageryKind {
    Picture,  ///< as photographed or drawn
    Heights,  ///< shown as hillshade with contour lines
};

/// What is known of imagery when it is opened.
struct ImageryFacts {
    ImageryKind kind = ImageryKind::Picture;
    GeoPoint southWest;
    GeoPoint northEast;
    /// Tiles beyond these show nothing new; coarser ones than the first are not there.
    int coarsestZoom = 0;
    int finestZoom = 0;
    /// Comes as a folder of tiles, which does not always say from where its rows count.
    bool isTileFolder = false;
    bool rowsFromSouth = false;
};

/// Imagery on this computer, read tile by tile. Several threads may ask at once.
class Imagery {
public:
    virtual ~Imagery() = default;
    Imagery(const Imagery&) = delete;
    Imagery& operator=(const Imagery&) = delete;

    const ImageryFacts& facts() const { return facts_; }

    /// Reads one tile; nothing where the imagery has none there.
    /// ReadFailed: the file was removed or changed since it was opened, or a part of it is damaged.
    /// Cancelled. Cost: of the pixels under the tile, those of an overview where the file has them. A large
    /// file without overviews is read once as a whole before its first coarse tile.
    virtual Result<std::optional<TilePicture>> tile(TileId id, const JobContext& job) const = 0;

    /// Between contour lines at this zoom, m; 0 for a picture.
    virtual double contourStepM(int /*zoom*/) const { return 0.0; }

protected:
    Imagery() = default;

    ImageryFacts facts_;
};

inline constexpr int kTileSide = 256;
inline constexpr int kFinestTileZoom = 24;

/// Opens a GeoTIFF, MBTiles or GeoPackage with tiles, JPEG 2000, PNG or JPEG with a world file, a grid of
/// heights, or a folder of tiles named zoom/column/row; in any projection.
///
/// @param rowsFromSouth  whether rows of a tile folder count from the south (TMS); as the folder says by
/// default
/// @return ReadFailed: not there, empty, no known format, damaged. InputRefused: it does not say where it
/// lies, it
///         holds no picture, or it is too large to be read without overviews. Nothing is written and nothing
///         fetched.
Result<std::shared_ptr<const Imagery>> openImagery(const std::filesystem::path& path,
                                                   std::optional<bool> rowsFromSouth = {});

/// Whether a file or folder is imagery rather than a field: MBTiles, a tile folder, a raster of several bands
/// or of many values. One band of few values is a mask of what is worked.
bool isImagery(const std::filesystem::path& path);

}  // namespace furrow
