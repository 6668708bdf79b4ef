#include "planner/io/formats/raster/raster_mask.h"

#include "planner/core/file_error.h"
#include "planner/gdal/worked_patches.h"
#include "planner/geodesy/local_frame.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

constexpr double kSmallestShare = 0.01;
constexpr double kSmallestM2 = 100.0;

}  // namespace

Recognition recogniseRaster(const ChosenFile& chosen) {
    constexpr std::array<std::string_view, 5> kMagic = {
        std::string_view{"II*\0", 4}, std::string_view{"MM\0*", 4}, std::string_view{"II+\0", 4},
        std::string_view{"MM\0+", 4}, std::string_view{"\x89PNG", 4}};
    const bool known = chosen.start() && std::ranges::any_of(kMagic, [&chosen](std::string_view magic) {
                           return chosen.start()->starts_with(magic);
                       });
    return known ? Recognition::Likely : Recognition::No;
}

Result<ImportedFields> readRasterMask(const ChosenFile& chosen, const JobContext& job) {
    const std::filesystem::path& path = chosen.path();
    auto read = workedPatches(path, job);
    if (!read) {
        return std::unexpected(read.error());
    }
    const std::string name = path.filename().string();
    std::vector<std::pair<double, GeoPolygon>> patches;
    for (GeoPolygon& patch : *read) {
        const double areaM2 = geodesicArea(patch).si();
        patches.emplace_back(areaM2, std::move(patch));
    }
    std::ranges::stable_sort(patches, std::greater{}, &std::pair<double, GeoPolygon>::first);
    ImportedFields imported;
    FieldContent content{.field = {.id = path.stem().string(), .name = path.stem().string(), .origin = name}};
    std::size_t small = 0;
    for (auto& [areaM2, polygon] : patches) {
        if (areaM2 >= std::max(kSmallestM2, kSmallestShare * patches.front().first)) {
            content.field.parts.push_back(std::move(polygon));
        } else {
            ++small;
        }
    }
    if (content.field.parts.empty()) {
        return std::unexpected(inputRefused(name, "no pixel of the picture is worked",
                                            "worked pixels need a value other than 0"));
    }
    if (small > 0) {
        imported.notes.push_back({message("{} small patches of worked pixels are left out", small), name});
    }
    imported.fields.push_back(std::move(content));
    return imported;
}

}  // namespace furrow
