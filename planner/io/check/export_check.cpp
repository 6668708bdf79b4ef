#include "planner/io/check/export_check.h"

#include "planner/geodesy/local_frame.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/io/check/path_checks.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/received_content.h"
#include "planner/io/files/file_folder.h"
#include "planner/io/files/file_names.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <format>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace furrow {

namespace {

constexpr double kAreaShare = 0.005;
// Rounding to whole square metres, and to tenths of an are, counts on small areas.
constexpr double kAreaSlackM2 = 6.0;
constexpr double kFarM = 10'000.0;
constexpr double kSamePlaceM = 0.5;
constexpr double kSameSwathEndM = 1e-3;
// Of what is shorter nothing can be recorded, and nobody drives it.
constexpr Length kShortestPath = metres(5.0);
constexpr double kWidthSlackM = 0.0011;

/// What the files of a format have to hold of the fields that are meant.
enum Carries : unsigned {
    kNothing = 0,
    kFields = 1,              ///< an area for each part
    kHoles = 2,               ///< as inner rings
    kObstaclesAsHoles = 4,    ///< in the part that they lie in
    kHolesAsFields = 8,       ///< nothing but outlines
    kLines = 16,
    kLinesWithoutPlan = 32,   ///< swaths where there is a plan
    kPath = 64,
};

struct CheckedFormat {
    std::string_view id;
    ContentFinder* find;
    unsigned carries;
};

constexpr CheckedFormat kFormats[] = {
    {"geojson", findGeoJson, kFields | kHoles | kLinesWithoutPlan | kPath},
    {"csv", findCsv, kFields | kHoles | kPath},
    {"isoxml", findIsoxml, kFields | kHoles | kLines},
    {"isoxml-v3", findIsoxml, kFields | kHoles | kLines},
    {"agopengps", findAgOpenGps, kFields | kHoles | kObstaclesAsHoles | kPath},
    {"shapefile", findShapefiles, kFields | kHoles | kLinesWithoutPlan | kPath},
    {"shapefile-zip", findZippedShapefile, kFields | kHoles},
    {"aggps", findShapefiles, kFields | kHoles | kLines},
    {"kml", findKml, kFields | kHoles | kLinesWithoutPlan | kPath},
    {"kmz", findKml, kFields | kHoles | kLinesWithoutPlan | kPath},
    {"geopackage", findGeoPackage, kFields | kHoles | kLinesWithoutPlan | kPath},
    {"gpx", findGpx, kFields | kHolesAsFields | kPath},
    {"dxf", findDxf, kFields | kHolesAsFields | kLinesWithoutPlan | kPath},
    {"waypoints", findWaypoints, kPath},
    {"qgc-plan", findGroundStationPlan, kFields | kPath},
    {"rosbag2", findRosbag, kPath},
    {"rosbag2-mcap", findRosbag, kPath},
    {"nav-path", findNavPathYaml, kPath},
    {"coverage-goal", findCoverageGoal, kNothing},
    {"protobuf", findPathMessage, kFields | kHoles | kPath},
};

/// What the checks look at, and where they say what they found: one word for each kind of mistake and file is enough.
struct Looking {
    const ExportJob& job;
    const CheckedFormat& format;
    std::span<const ExportedFile> files;
    std::span<const FoundContent> contents;
    ExportChecks& result;
    bool looked = false;  ///< at something

    void tell(const std::string& file, const Message& problem) {
        result.problems.push_back(message("Receivers may refuse {}: {}.", file, problem));
    }
};

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char byte) { return static_cast<unsigned char>(byte) < 0x80; });
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

GeoRing opened(const GeoRing& ring) {
    GeoRing open = ring;
    if (open.size() > 1 && open.front() == open.back()) {
        open.pop_back();
    }
    return open;
}

GeoPolygon opened(const GeoPolygon& rings) {
    GeoPolygon open{.outer = opened(rings.outer), .holes = {}};
    for (const GeoRing& hole : rings.holes) {
        open.holes.push_back(opened(hole));
    }
    return open;
}

bool onEarth(GeoPoint point) {
    return std::isfinite(point.lonDeg) && std::isfinite(point.latDeg) && std::abs(point.lonDeg) <= 180.0 &&
           std::abs(point.latDeg) <= 90.0;
}

template <class Visit>
void forEachRing(const FoundArea& area, const Visit& visit) {
    visit(area.rings.outer, true);
    for (const GeoRing& hole : area.rings.holes) {
        visit(hole, false);
    }
}

/// Every place of a file that is given in degrees.
template <class Visit>
void forEachPlace(const FoundContent& content, const Visit& visit) {
    for (const FoundArea& area : content.areas) {
        forEachRing(area, [&visit](const GeoRing& ring, bool) { std::ranges::for_each(ring, visit); });
    }
    for (const FoundLine& line : content.lines) {
        std::ranges::for_each(line.points, visit);
    }
    std::ranges::for_each(content.points, visit);
    for (const FoundPath& path : content.paths) {
        for (const FoundSample& sample : path.samples) {
            if (!sample.isLocal) {
                visit(sample.geo);
            }
        }
    }
}

void faults(Looking& looking) {
    looking.looked = true;
    for (const FoundContent& content : looking.contents) {
        for (const Message& fault : content.faults) {
            looking.tell(content.file, fault);
        }
    }
}

/// On FAT, on Windows, and by terminals of eight and three capitals.
void fileNames(Looking& looking) {
    std::set<std::string> used;
    for (const ExportedFile& file : looking.files) {
        looking.looked = true;
        const std::filesystem::path path{file.path};
        bool legal = path.is_relative();
        for (const std::filesystem::path& part : path) {
            legal = legal && part.string() == safeFileName(part.string(), "");
        }
        const std::string name = path.filename().string();
        if (legal && path.has_parent_path() && path.parent_path().filename() == "TASKDATA") {
            const std::size_t dot = name.find('.');
            legal = dot != std::string::npos && dot <= 8 && name.size() - dot <= 4 &&
                    std::ranges::none_of(name, [](char letter) { return letter >= 'a' && letter <= 'z'; });
        }
        if (!legal) {
            looking.tell(file.path, "some systems do not allow a file of this name");
        }
        if (!used.insert(inSmallLetters(file.path)).second) {
            looking.tell(file.path, "another file differs from it in capitals only");
        }
    }
}

void coordinates(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        std::optional<GeoPoint> wrong;
        forEachPlace(content, [&](GeoPoint point) {
            looking.looked = true;
            if (!wrong && !onEarth(point)) {
                wrong = point;
            }
        });
        if (wrong) {
            looking.tell(content.file, message("{}, {} is no longitude and latitude", wrong->lonDeg, wrong->latDeg));
        }
    }
}

/// Far from the bounding boxes of all fields that were meant.
void place(Looking& looking) {
    constexpr double kDegreeM = 111'000.0;
    const auto isNear = [&looking](GeoPoint point) {
        return std::ranges::any_of(looking.job.fields, [point](const FieldContent& content) {
            return std::ranges::any_of(content.field.parts, [point](const GeoPolygon& part) {
                const GeoPoint first = part.outer.front();
                double eastM = 0.0;
                double northM = 0.0;
                for (const GeoPoint& corner : part.outer) {
                    eastM = std::max(eastM, kDegreeM * std::abs(lonNear(corner.lonDeg, first.lonDeg) - first.lonDeg));
                    northM = std::max(northM, kDegreeM * std::abs(corner.latDeg - first.latDeg));
                }
                return roughDistanceM(point, first) < kFarM + eastM + northM;
            });
        });
    };
    for (const FoundContent& content : looking.contents) {
        std::optional<GeoPoint> far;
        std::optional<GeoPoint> lastGood;
        forEachPlace(content, [&](GeoPoint point) {
            looking.looked = true;
            // Next to one that is near is near enough.
            if (far || !onEarth(point) || (lastGood && roughDistanceM(point, *lastGood) < kFarM / 2.0)) {
                return;
            }
            if (isNear(point)) {
                lastGood = point;
            } else {
                far = point;
            }
        });
        if (far) {
            looking.tell(content.file, message("{:.6f}, {:.6f} is far from the field", far->lonDeg, far->latDeg));
        }
    }
}

void ringsClosed(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        const FoundArea* wrong = nullptr;
        const FoundArea* small = nullptr;
        for (const FoundArea& area : content.areas) {
            forEachRing(area, [&](const GeoRing& ring, bool) {
                looking.looked = true;
                const bool repeats = ring.size() > 1 && ring.front() == ring.back();
                wrong = wrong == nullptr && repeats != content.repeatsFirst ? &area : wrong;
                small = small == nullptr && opened(ring).size() < 3 ? &area : small;
            });
        }
        if (small != nullptr) {
            looking.tell(content.file, message("a ring of '{}' has fewer than three corners", small->name));
        } else if (wrong != nullptr) {
            looking.tell(content.file, content.repeatsFirst
                                           ? message("a ring of '{}' does not end where it begins", wrong->name)
                                           : message("a ring of '{}' ends with its first point again", wrong->name));
        }
    }
}

void simple(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        for (const FoundArea& area : content.areas) {
            const GeoPolygon rings = opened(area.rings);
            bool usable = rings.outer.size() >= 3;
            forEachRing({.rings = rings}, [&usable](const GeoRing& ring, bool) {
                usable = usable && ring.size() >= 3 && std::ranges::all_of(ring, onEarth);
            });
            const auto frame = usable ? LocalFrame::centredOn(rings.outer.front()) : std::unexpected(Error{});
            if (!frame) {
                continue;  // the other checks say why
            }
            looking.looked = true;
            const auto invalid = findInvalidPlace({frame->toLocal(rings)}, {});
            if (!invalid || *invalid) {
                looking.tell(content.file, message("'{}' crosses itself, or a hole lies outside of it", area.name));
                break;
            }
        }
    }
}

/// Across the antimeridian programs that know no globe see it the other way round.
bool spansGlobe(const GeoRing& ring) {
    const auto [west, east] = std::ranges::minmax(ring, {}, &GeoPoint::lonDeg);
    return east.lonDeg - west.lonDeg > 180.0;
}

void winding(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        if (content.winding == FoundContent::Winding::Any) {
            continue;
        }
        const bool outerLeft = content.winding == FoundContent::Winding::OuterLeft;
        const FoundArea* wrong = nullptr;
        for (const FoundArea& area : content.areas) {
            forEachRing(area, [&](const GeoRing& ring, bool outer) {
                looking.looked = true;
                const bool left = isCounterClockwise(opened(ring));
                const bool judged = wrong == nullptr && ring.size() >= 3 && !spansGlobe(ring);
                wrong = judged && left != (outer == outerLeft) ? &area : wrong;
            });
        }
        if (wrong != nullptr) {
            looking.tell(content.file, message("a ring of '{}' runs the wrong way round", wrong->name));
        }
    }
}

void areas(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        for (const FoundArea& area : content.areas) {
            const GeoPolygon rings = opened(area.rings);
            if (!area.statedM2 || rings.outer.size() < 3) {
                continue;
            }
            looking.looked = true;
            const double most = geodesicArea({.outer = rings.outer, .holes = {}}).si();
            const double own = geodesicArea(rings).si();
            // A field's area is stated with obstacles taken out, which are areas of their own.
            const double least = area.kind == FoundArea::Kind::Field ? std::min(own, 0.2 * most) : own;
            if (*area.statedM2 > own + kAreaShare * most + kAreaSlackM2 ||
                *area.statedM2 < least - kAreaShare * most - kAreaSlackM2) {
                looking.tell(content.file,
                             message("'{}' is said to have {:.0f} m², and has {:.0f} m²", area.name, *area.statedM2, own));
                break;
            }
        }
    }
}

void crs(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        looking.looked = looking.looked || content.namesCrs.has_value();
        if (content.namesCrs == false) {
            looking.tell(content.file, "it does not say in which coordinate system it is");
        }
    }
}

void names(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        for (const FoundNames& list : content.names) {
            std::set<std::string> used;
            for (const std::string& name : list.names) {
                looking.looked = true;
                const bool twice = list.mustDiffer && !name.empty() && !used.insert(name).second;
                if (list.longest > 0 && characters(name) > list.longest) {
                    looking.tell(content.file, message("the name '{}' is longer than {} characters", name, list.longest));
                } else if (twice) {
                    looking.tell(content.file, message("the name '{}' is there twice", name));
                } else if (list.ascii && !isAscii(name)) {
                    looking.tell(content.file, message("the name '{}' has letters beyond A to Z", name));
                } else if (cutText(name, name.size()) != name) {
                    looking.tell(content.file, message("the name '{}' has characters that are no letters", name));
                } else {
                    continue;
                }
                break;
            }
        }
    }
}

void lines(Looking& looking) {
    // Nobody steers along the swaths of a map by their ends: they are as short as they are driven.
    const bool areSwaths = looking.job.plan != nullptr && (looking.format.carries & kLinesWithoutPlan) != 0;
    const double sameM = areSwaths ? kSameSwathEndM : kSamePlaceM;
    for (const FoundContent& content : looking.contents) {
        for (const FoundLine& line : content.lines) {
            looking.looked = true;
            if (line.points.size() < line.fewestPoints) {
                looking.tell(content.file, message("the line '{}' has fewer than two points", line.name));
                break;
            }
            if (line.points.size() == 2 && roughDistanceM(line.points[0], line.points[1]) < sameM &&
                line.fewestPoints == 2) {
                looking.tell(content.file, message("A and B of '{}' are the same place", line.name));
                break;
            }
        }
    }
}

/// Each width that is stated is one of those meant.
void widths(Looking& looking) {
    std::vector<double> meant;
    for (const FieldContent& content : looking.job.fields) {
        for (const GuidanceLine& line : content.lines) {
            meant.push_back(line.width.value_or(Length{}).si());
        }
    }
    if (looking.job.plan != nullptr) {
        for (const Swath& swath : looking.job.plan->swaths.swaths) {
            meant.push_back(swath.width.si());
        }
    }
    for (const FoundContent& content : looking.contents) {
        for (const FoundLine& line : content.lines) {
            if (!line.widthM) {
                continue;
            }
            looking.looked = true;
            const bool known = std::ranges::any_of(
                meant, [&line](double width) { return std::abs(width - *line.widthM) < kWidthSlackM; });
            if (!known) {
                looking.tell(content.file, message("'{}' is said to be {:.3f} m wide", line.name, *line.widthM));
                break;
            }
        }
    }
}

void orders(Looking& looking) {
    for (const FoundContent& content : looking.contents) {
        for (const FoundOrder& order : content.orders) {
            looking.looked = true;
            for (std::size_t i = 0; i < order.numbers.size(); ++i) {
                const std::int64_t expected = order.first + static_cast<std::int64_t>(i);
                if (order.numbers[i] != expected) {
                    looking.tell(content.file, message("{} comes where {} should", order.numbers[i], expected));
                    break;
                }
            }
        }
    }
}

/// As many parts, holes and lines as are meant.
void counts(Looking& looking) {
    const auto carries = [&looking](Carries what) { return (looking.format.carries & what) != 0; };
    std::size_t parts = 0;
    std::size_t holes = 0;
    std::size_t guidance = 0;
    for (const FieldContent& content : looking.job.fields) {
        parts += content.field.parts.size();
        for (const GeoPolygon& part : content.field.parts) {
            holes += part.holes.size();
            for (const Obstacle& obstacle : content.field.obstacles) {
                holes += carries(kObstaclesAsHoles) && contains(part.outer, obstacle.outline.outer.front()) ? 1 : 0;
            }
        }
        guidance += static_cast<std::size_t>(std::ranges::count_if(
            content.lines, [](const GuidanceLine& line) { return drawn(line, metres(100.0)).size() >= 2; }));
    }
    std::size_t foundParts = 0;
    std::size_t foundHoles = 0;
    std::size_t foundLines = 0;
    for (const FoundContent& content : looking.contents) {
        for (const FoundArea& area : content.areas) {
            foundParts += area.kind == FoundArea::Kind::Field ? 1 : 0;
            foundHoles += area.kind == FoundArea::Kind::Field ? area.rings.holes.size() : 0;
        }
        foundLines += content.lines.size();
    }
    const std::string file = looking.contents.empty() ? std::string{looking.format.id} : looking.contents.front().file;
    const auto compare = [&](const char* pattern, std::size_t found, std::size_t meant) {
        looking.looked = true;
        if (found != meant) {
            looking.tell(file, message(pattern, found, meant));
        }
    };
    const bool asPath = looking.job.plan != nullptr && (looking.format.id == "gpx" || looking.format.id == "csv");
    if (carries(kFields) && !asPath) {
        compare("{} boundaries are in it, not {}", foundParts, parts + (carries(kHolesAsFields) ? holes : 0));
        if (carries(kHoles)) {
            const bool apart = looking.job.options.holesAsObstacles && looking.format.id.starts_with("isoxml");
            compare("{} holes are in it, not {}", foundHoles, apart ? 0 : holes);
        }
    }
    if (carries(kLines) || (carries(kLinesWithoutPlan) && looking.job.plan == nullptr)) {
        compare("{} guidance lines are in it, not {}", foundLines, guidance);
    } else if (carries(kLinesWithoutPlan)) {
        compare("{} swaths are in it, not {}", foundLines, looking.job.plan->route.steps.size());
    }
}

template <PathCheck* kCheck>
void ofPaths(Looking& looking) {
    if (looking.job.plan == nullptr || (looking.format.carries & kPath) == 0) {
        return;
    }
    for (const FoundContent& content : looking.contents) {
        for (const FoundPath& path : content.paths) {
            looking.looked = true;
            if (const auto problem = kCheck(path, *looking.job.plan)) {
                looking.tell(content.file, *problem);
                break;
            }
        }
    }
}

void pathIsThere(Looking& looking) {
    if (looking.job.plan == nullptr || (looking.format.carries & kPath) == 0 ||
        looking.job.plan->path.length() < kShortestPath) {
        return;
    }
    looking.looked = true;
    const bool there = std::ranges::any_of(looking.contents, [](const FoundContent& content) {
        return std::ranges::any_of(content.paths, [](const FoundPath& path) { return !path.samples.empty(); });
    });
    if (!there && !looking.contents.empty()) {
        looking.tell(looking.contents.front().file, "the path is not in it");
    }
}

struct Check {
    std::string_view id;
    void (*run)(Looking& looking);
};

/// A row for each, the gravest first.
constexpr Check kChecks[] = {
    {"readable", faults},
    {"coordinates", coordinates},
    {"place", place},
    {"rings-closed", ringsClosed},
    {"rings-simple", simple},
    {"counts", counts},
    {"path-there", pathIsThere},
    {"path-followed", ofPaths<pathFollowed>},
    {"path-length", ofPaths<pathLength>},
    {"path-times", ofPaths<pathTimes>},
    {"path-headings", ofPaths<pathHeadings>},
    {"path-speeds", ofPaths<pathSpeeds>},
    {"lines", lines},
    {"order", orders},
    {"crs", crs},
    {"winding", winding},
    {"areas", areas},
    {"widths", widths},
    {"names", names},
    {"file-names", fileNames},
};

}  // namespace

void ExportChecks::add(const ExportChecks& more) {
    for (const std::string_view id : more.made) {
        if (!std::ranges::contains(made, id)) {
            made.push_back(id);
        }
    }
    problems.insert(problems.end(), more.problems.begin(), more.problems.end());
}

ExportChecks checkExport(std::string_view formatId, const ExportJob& job, std::span<const FileToWrite> files) {
    ExportChecks result;
    const auto format = std::ranges::find(kFormats, formatId, &CheckedFormat::id);
    if (format == std::end(kFormats)) {
        return result;
    }
    std::vector<ExportedFile> written;
    for (const FileToWrite& file : files) {
        written.push_back({file.path.generic_string(), file.text()});
    }
    const std::vector<FoundContent> contents = format->find(written, job);
    Looking looking{job, *format, written, contents, result};
    for (const Check& check : kChecks) {
        looking.looked = false;
        check.run(looking);
        if (looking.looked) {
            result.made.push_back(check.id);
        }
    }
    return result;
}

Result<FormatFiles> checkedFiles(const FormatInfo& format, const ExportJob& job) {
    auto made = format.writer(job);
    if (!made) {
        return made;
    }
    for (FileToWrite& file : made->files) {
        // Made once for the check and the disk.
        file.text = [bytes = file.text()] { return bytes; };
    }
    if (job.job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    made->checks = checkExport(format.id, job, made->files);
    return made;
}

}  // namespace furrow
