#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/message.h"
#include "planner/geometry/point.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

struct ExportJob;

// What a receiver finds in written files: taken apart by code that shares nothing with the writers and judges
// nothing. The checks of export_check.cpp judge it.

/// An area as it stands in a file, points as they are, a repeated first point too.
struct FoundArea {
    enum class Kind { Field, Obstacle, Other };
    Kind kind = Kind::Other;
    std::string name;
    GeoPolygon rings;
    std::optional<double> statedM2;
};

/// A line to steer along, or a swath.
struct FoundLine {
    std::string name;
    GeoRing points;
    std::optional<double> widthM;
    std::size_t fewestPoints = 2;
};

/// A place on a path. Where `isLocal`, in the plan's frame.
struct FoundSample {
    GeoPoint geo;
    Point local;
    bool isLocal = false;
    std::optional<double> timeS;
    std::optional<double> headingRad;  ///< of the nose, counter-clockwise from east
    std::optional<double> speedMps;
    bool reverse = false;
};

struct FoundPath {
    std::vector<FoundSample> samples;
    bool isWhole = true;       ///< from the plan's start to its end; else a stretch of it
    bool knowsGear = false;    ///< `reverse` is stated
};

/// Names that must be unequal and fit.
struct FoundNames {
    std::vector<std::string> names;
    std::size_t longest = 0;  ///< characters; 0: any
    bool ascii = false;
    bool mustDiffer = true;
};

/// Numbers that count up by one from the first.
struct FoundOrder {
    std::int64_t first = 0;
    std::vector<std::int64_t> numbers;
};

/// One file, or several that are read as one.
struct FoundContent {
    std::string file;
    bool repeatsFirst = true;  ///< rings end with their first point; else without it
    enum class Winding { Any, OuterLeft, OuterRight } winding = Winding::Any;  ///< left: counter-clockwise
    std::optional<bool> namesCrs;  ///< where the format has a place for its coordinate system: whether it is WGS84
    std::vector<FoundArea> areas;
    std::vector<FoundLine> lines;
    std::vector<GeoPoint> points;
    std::vector<FoundPath> paths;
    std::vector<FoundNames> names;
    std::vector<FoundOrder> orders;
    std::vector<Message> faults;  ///< what cannot be read, is missing, or contradicts itself
};

/// A written file in memory.
struct ExportedFile {
    std::string path;
    std::string bytes;
};

/// The common signature of what takes a format's files apart. Whatever the bytes are: what cannot be read is a fault.
using ContentFinder = std::vector<FoundContent>(std::span<const ExportedFile> files, const ExportJob& job);

ContentFinder findGeoJson;
ContentFinder findCsv;
ContentFinder findIsoxml;
ContentFinder findAgOpenGps;
ContentFinder findShapefiles;     ///< loose, in folders
ContentFinder findZippedShapefile;
ContentFinder findGeoPackage;
ContentFinder findKml;            ///< and KMZ
ContentFinder findGpx;
ContentFinder findDxf;
ContentFinder findWaypoints;
ContentFinder findGroundStationPlan;
ContentFinder findRosbag;         ///< either storage
ContentFinder findNavPathYaml;
ContentFinder findCoverageGoal;
ContentFinder findPathMessage;

// What several of them need.

/// The whole text as a number; nothing for anything else, "nan" among it.
std::optional<double> decimalIn(std::string_view text);

/// "line 12 is not as this format has it"
Message badLine(std::size_t number);
/// "this is no KML"
Message isNot(std::string_view format);
Message cannotBeRead();
Message isMissing(std::string_view what);
/// "12 entries are announced, and 11 are there"
Message badCount(std::size_t announced, std::size_t found);

}  // namespace furrow
