#include "planner/io/formats/shapefile/shapefile.h"

#include "planner/geodesy/local_frame.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/map_layers.h"
#include "planner/io/files/file_names.h"
#include "planner/io/formats/shapefile/owner.h"

#include <format>
#include <utility>

namespace furrow {

namespace {

using Kind = VectorLayer::Kind;
using Shape = VectorLayer::Shape;

// What these displays show of a name.
constexpr std::size_t kLongestAgGpsName = 30;

double lengthM(const GeoRing& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        sum += roughDistanceM(line[i - 1], line[i]);
    }
    return sum;
}

VectorLayer agGpsBoundary(const FieldContent& content, const std::string& name, const std::string& date) {
    return {"Boundary",
            Shape::Polygons,
            {{"Date", Kind::Text, 8},
             {"Id", Kind::Whole, 9},
             {"Name", Kind::Text, 30},
             {"Area", Kind::Real, 12, 3}},
            {{.polygons = content.field.parts,
              .values = {date, std::int64_t{1}, name, inHectares(content.statedArea())}}}};
}

VectorLayer agGpsSwaths(const FieldContent& content, const std::string& date) {
    VectorLayer layer{"Swaths",
                      Shape::Line,
                      {{"Date", Kind::Text, 8},
                       {"Time", Kind::Text, 10},
                       {"Version", Kind::Text, 8},
                       {"Id", Kind::Whole, 9},
                       {"Name", Kind::Text, 30},
                       {"Length", Kind::Real, 12, 3},
                       {"Dist1", Kind::Real, 12, 3},
                       {"Dist2", Kind::Real, 12, 3}},
                      {}};
    UniqueNames names{kLongestAgGpsName, true};
    std::int64_t number = 0;
    for (const GuidanceLine& line : content.lines) {
        GeoRing points = drawn(line, metres(100.0));
        if (points.size() < 2) {
            continue;
        }
        const double length = lengthM(points);
        layer.features.push_back({.line = std::move(points),
                                  .values = {date, "00:00:00", "1.0", ++number,
                                             names.unique(line.name, "Line"), length, 0.0, 0.0}});
    }
    return layer;
}

}  // namespace

Result<FormatFiles> writeAgGps(const ExportJob& job) {
    // The same plan gives the same bytes.
    const std::string date = "20000101";
    FormatFiles made;
    UniqueNames names{kLongestAgGpsName, true};
    for (const FieldContent& content : job.fields) {
        const std::string name = names.unique(safeFileName(content.field.name, "Field"), "Field");
        std::vector<VectorLayer> layers{agGpsBoundary(content, name, date)};
        if (VectorLayer swaths = agGpsSwaths(content, date); !swaths.features.empty()) {
            layers.push_back(std::move(swaths));
        }
        auto files = vectorFiles(VectorFormat::Shapefile, name, layers, job.job);
        if (!files) {
            return std::unexpected(files.error());
        }
        for (FileInMemory& file : *files) {
            file.path = std::format("AgGPS/Data/{}/{}/{}/{}", kClient, kFarm, name, file.path);
            made.files.push_back(toWrite(std::move(file)));
        }
    }
    return made;
}

}  // namespace furrow
