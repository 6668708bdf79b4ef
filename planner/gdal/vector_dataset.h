#pragma once

#include "planner/core/result.h"
#include "planner/gdal/messages.h"
#include "planner/gdal/vector_feature.h"
#include "planner/jobs/job.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class GDALDataset;

namespace furrow {

/// What is read of vector files, and where it goes.
struct VectorReading {
    std::span<const std::string_view> attributes;  ///< their names, capitals or not
    const JobContext& job;
    VectorFile& file;  ///< features are added to it
};

/// GDAL's options for this thread while vector files are read, put back afterwards.
class VectorReadingOptions {
public:
    VectorReadingOptions();
    ~VectorReadingOptions();
    VectorReadingOptions(const VectorReadingOptions&) = delete;
    VectorReadingOptions& operator=(const VectorReadingOptions&) = delete;
};

/// A vector file that GDAL has opened to read.
class VectorDataset {
public:
    /// @param path  as GDAL opens it, in a zip too
    /// @return nothing where no driver of Furrow's knows the file; `messages` has the reason
    static std::optional<VectorDataset> open(const std::string& path, GdalMessages& messages);

    /// Of GDAL: "GeoJSON", "CSV", ...
    std::string driver() const;
    bool hasLayers() const;
    /// Of the first layer.
    std::vector<std::string> columns() const;
    /// Whether a layer with shapes has no coordinate system.
    bool lacksSystem() const;

    /// Adds the features of all layers.
    ///
    /// @param path, name  the file that was opened, and what people call it. A drawing's coordinate system is
    /// taken
    ///                    from its name ("..._EPSG32631.dxf")
    /// @return InputRefused: no coordinate system, or none that is understood. ReadFailed: damaged.
    /// Cancelled: asked
    ///         between features.
    Result<void> readLayers(const std::string& path, const std::string& name, const GdalMessages& messages,
                            const VectorReading& reading) const;

private:
    struct Closer {
        void operator()(GDALDataset* dataset) const;
    };
    using Dataset = std::unique_ptr<GDALDataset, Closer>;

    static Dataset openWith(const std::string& path, const char* const* drivers);
    explicit VectorDataset(Dataset dataset) : dataset_{std::move(dataset)} {}

    Dataset dataset_;
};

}  // namespace furrow
