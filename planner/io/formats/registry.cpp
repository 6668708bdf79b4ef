#include "planner/io/formats/registry.h"

#include "planner/io/formats/agopengps/agopengps_writer.h"
#include "planner/io/formats/geojson/geojson_writer.h"
#include "planner/io/formats/isoxml/isoxml_writer.h"
#include "planner/io/formats/kml/kml.h"
#include "planner/io/formats/ros/ros.h"
#include "planner/io/formats/shapefile/shapefile_writer.h"

#include <string>

namespace furrow {

namespace {

constexpr FormatInfo kFormats[] = {
    {"geojson", "GeoJSON", "geojson json", true,
     "Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.", writeGeoJson, true},
    {"csv", "CSV table", "csv", true,
     "Every sample of the path; without a plan boundaries as WKT, or as points.", writeCsv, true, {}, true},
    {"isoxml", "ISOXML 4.3", "xml zip", true,
     "Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.", writeIsoxml4,
     true, {}, true},
    {"isoxml-v3", "ISOXML 3.3", "xml zip", true,
     "Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.",
     writeIsoxml3, true, "isoxml-v3", true},
    {"agopengps", "AgOpenGPS field", "", true,
     "Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.", writeAgOpenGps, true,
     "agopengps"},
    {"shapefile", "Shapefile", "shp zip", true,
     "Boundary, obstacles, gates, mainland, swaths and path, a shapefile of each.", writeShapefiles, true,
     "shapefile"},
    {"shapefile-zip", "Zipped boundary", "zip", true,
     "The boundary alone as a flat zipped shapefile, as operations centres take it.", writeBoundaryZip, true},
    {"aggps", "AgGPS folder", "", true,
     "Boundary and guidance lines for Trimble and FM displays; no driving order.", writeAgGps, true},
    {"kml", "KML", "kml", true, "Boundary, obstacles, gates, headland, swaths and path, to look at.", writeKml, true},
    {"kmz", "KMZ", "kmz", true, "The same as KML, zipped.", writeKmz, true},
    {"geopackage", "GeoPackage", "gpkg", true,
     "Boundary, obstacles, gates, mainland, swaths and path as layers for a GIS.", writeGeoPackage, true},
    {"gpx", "GPX", "gpx", true, "The path as a track, swath ends as a route, gates as waypoints; for phones.",
     writeGpx, true, {}, true},
    {"dxf", "DXF drawing", "dxf", true,
     "Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.", writeDxf, true},
    {"waypoints", "MAVLink waypoints", "waypoints", false,
     "The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.", writeWaypoints},
    {"qgc-plan", "QGroundControl plan", "plan", false,
     "The same mission with the boundary and obstacles as fences.", writeGroundStationPlan},
    {"rosbag2", "rosbag2, sqlite3", "db3", false, "The path as nav_msgs/Path in a recording of ROS 2.",
     writeRosbagSqlite, false, "ros", true},
    {"rosbag2-mcap", "rosbag2, MCAP", "mcap", false, "The path as nav_msgs/Path in a recording of ROS 2.",
     writeRosbagMcap, false, "ros", true},
    {"nav-path", "nav_msgs/Path as YAML", "yaml", false, "The path as one message for ros2 topic pub.",
     writeNavPathYaml, false, "ros"},
    {"coverage-goal", "opennav_coverage goal", "yaml", false,
     "Boundary, headland, heading and order; the robot lays swaths and turns itself.", writeCoverageGoal, false,
     "ros"},
    {"protobuf", "Protobuf message", "pb", false,
     "The path with times, velocities and orientations, and the boundary as a fence; for own robots.", writeProtobuf},
    {"gml", "GML", "gml xml", true, "Boundaries, also field files of Fields2Cover and GAOS."},
    {"flatgeobuf", "FlatGeobuf", "fgb", true, "Boundaries."},
    {"wkt", "Well-known text", "wkt txt", true, "Boundaries in longitude and latitude."},
    {"raster", "Raster mask", "tif png", true, "What is worked and what is not, as a field."},
    {.id = "logs", .name = "NMEA or gpsd log", .extensions = "log nmea txt json", .carries = "What a machine drove.", .readsTracks = true},
};

}  // namespace

std::span<const FormatInfo> formats() {
    return kFormats;
}

Result<const FormatInfo*> findPlanFormat(std::string_view id) {
    std::string known;
    for (const FormatInfo& format : kFormats) {
        if (format.writes() && format.id == id) {
            return &format;
        }
        if (format.writes()) {
            known += (known.empty() ? "" : ", ") + std::string{format.id};
        }
    }
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = message("plans cannot be written as '{}'", id),
                                 .where = "--format",
                                 .remedy = message("use one or more of: {}", known)});
}

}  // namespace furrow
