#pragma once

#include "planner/imagery/imagery.h"

#include <array>
#include <string>

namespace furrow {

/// A folder of pictures named zoom/column/row in web Mercator, rows counted from the north or, as TMS, from
/// the south.
class TileFolder final : public Imagery {
public:
    /// Whether a folder has such tiles. Cost: reads as few folders as it takes to find one.
    static bool isOne(const std::filesystem::path& folder);
    /// As openImagery.
    static Result<std::shared_ptr<const Imagery>> open(const std::filesystem::path& folder,
                                                       std::optional<bool> rowsFromSouth);

    Result<std::optional<TilePicture>> tile(TileId id, const JobContext& job) const override;

private:
    TileFolder(std::filesystem::path folder, std::string extension)
        : folder_{std::move(folder)}, extension_{std::move(extension)} {}

    std::filesystem::path folder_;
    std::string extension_;
};

}  // namespace furrow
