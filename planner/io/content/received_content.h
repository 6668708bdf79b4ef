#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/message.h"
#include "planner/geometry/point.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

// What a receiver finds in written files. The checks of io/check judge it.

/// An area as it stands in a file, points as they are, a repeated first point too.
struct ReceivedArea {
    enum class Kind { Field, Obstacle, Other };
    Kind kind = Kind::Other;
    std::string name;
    GeoPolygon rings;
    std::optional<double> statedM2;
};

/// A line to steer along, or a swath.
struct ReceivedLine {
    std::string name;
    GeoRing points;
    std::optional<double> widthM;
    std::size_t fewestPoints = 2;
};

/// A place on a path. Where `isLocal`, in the plan's frame.
struct ReceivedSample {
    GeoPoint geo;
    Point local;
    bool isLocal = false;
    std::optional<double> timeS;
    std::optional<double> headingRad;  ///< of the nose, counter-clockwise from east
    std::optional<double> speedMps;
    bool reverse = false;
};

struct ReceivedPath {
    std::vector<ReceivedSample> samples;
    bool isWhole = true;     ///< from the plan's start to its end; else a stretch of it
    bool knowsGear = false;  ///< `reverse` is stated
};

/// Names that must be unequal and fit.
struct ReceivedNames {
    std::vector<std::string> names;
    std::size_t longest = 0;  ///< characters; 0: any
    bool ascii = false;
    bool mustDiffer = true;
};

/// Numbers that count up by one from the first.
struct ReceivedNumbers {
    std::int64_t first = 0;
    std::vector<std::int64_t> numbers;
};

/// One file, or several that are read as one.
struct ReceivedContent {
    std::string file;
    bool repeatsFirst = true;  ///< rings end with their first point; else without it
    enum class Winding { Any, OuterLeft, OuterRight } winding = Winding::Any;  ///< left: counter-clockwise
    std::optional<bool>
        namesCrs;  ///< where the format has a place for its coordinate system: whether it is WGS84
    std::vector<ReceivedArea> areas;
    std::vector<ReceivedLine> lines;
    std::vector<GeoPoint> points;
    std::vector<ReceivedPath> paths;
    std::vector<ReceivedNames> names;
    std::vector<ReceivedNumbers> orders;
    std::vector<Message> faults;  ///< what cannot be read, is missing, or contradicts itself
};

// What several finders say.

/// "line 12 is not as this format has it"
Message badLine(std::size_t number);
/// "this is no KML"
Message isNot(std::string_view format);
Message cannotBeRead();
Message isMissing(std::string_view what);
/// "12 entries are announced, and 11 are there"
Message badCount(std::size_t announced, std::size_t found);

}  // namespace furrow
