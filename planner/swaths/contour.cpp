#include "planner/geometry/geos_bridge.h"
#include "planner/swaths/contour_lines.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/guide_curve.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace furrow {

namespace {

// A parallel may lie beside the line of its own mean height by at most 2 widths, or 12 m for narrow machines
// (root mean square). Beyond that a new contour is taken.
constexpr double kMostAwayWidths = 2.0;
constexpr double kMostAwayM = 12.0;
// Flatter land has no direction.
constexpr double kFlat = 1e-3;
constexpr Length kLook = metres(5.0);
// Strips overlap by this in the search for remainders, so that no narrow gap is left between them.
constexpr Length kJoined = metres(0.1);
// If more than this share of a region remains, no contour fits.
constexpr double kProgress = 0.9;
// Least smoothing of the heights, since no machine follows the bumps of a scan.
constexpr Length kLeastEvened = metres(10.0);
// Largest number of blocks. The rest follows the contour beside it, even if it does not fit.
constexpr std::size_t kMostBlocks = 64;

/// Land that has no swaths yet.
struct Region {
    Polygon outline;
    bool anyway = false;  ///< no contour fits; worked along its longest edge
};

/// A part of the mainland that follows one contour.
struct Block {
    double heightM = 0.0;
    std::vector<SwathLine> lines;
};

std::vector<double> heightsIn(const ElevationGrid& heights, const MainlandEdges& edges) {
    std::vector<double> found;
    const Bounds box = edges.box();
    // About a thousand places are enough for a median.
    const double apartM = std::max(heights.cellM, std::sqrt(box.width() * box.height() / 1000.0));
    for (double y = box.min.y + 0.5 * apartM; y < box.max.y; y += apartM) {
        for (double x = box.min.x + 0.5 * apartM; x < box.max.x; x += apartM) {
            if (const auto height = heightAt(heights, {x, y}); height && edges.contains({x, y})) {
                found.push_back(*height);
            }
        }
    }
    return found;
}

/// The median height. Land without known heights, for example a pond, counts as level.
double medianOf(std::vector<double> heights) {
    if (heights.empty()) {
        return 0.0;
    }
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    return *middle;
}

/// The longest stretch of these lines that lies inside, with one more point at each end.
Polyline longestInside(const std::vector<Polyline>& lines, const MainlandEdges& edges) {
    Polyline longest;
    for (const Polyline& line : lines) {
        for (std::size_t i = 0; i < line.size();) {
            if (!edges.contains(line[i])) {
                ++i;
                continue;
            }
            const std::size_t first = i == 0 ? 0 : i - 1;
            while (i < line.size() && edges.contains(line[i])) {
                ++i;
            }
            const Polyline stretch{line.begin() + static_cast<std::ptrdiff_t>(first),
                                   line.begin() + static_cast<std::ptrdiff_t>(std::min(i + 1, line.size()))};
            if (stretch.size() > 1 && (longest.empty() || lengthM(stretch) > lengthM(longest))) {
                longest = stretch;
            }
        }
    }
    return longest;
}

/// Opens a ring by this gap, because a closed line has no two sides to work along.
Polyline opened(Polyline line, double gapM) {
    if (line.size() > 2 && distance(line.front(), line.back()) < gapM) {
        const Point start = line.front();
        while (line.size() > 3 && distance(line.back(), start) < gapM) {
            line.pop_back();
        }
    }
    return line;
}

/// The longest edge of a remainder. Usually the land beside it is already worked.
Polyline longestEdge(const Polygon& region) {
    Polyline longest{region.outer[0], region.outer[1]};
    forEachEdge({region}, [&](Point from, Point to) {
        if (distance(from, to) > distance(longest[0], longest[1])) {
            longest = {from, to};
        }
    });
    return longest;
}

/// The distance of these lines from the contour of their own mean height.
double awayM(const std::vector<Curve>& parts, const ElevationGrid& heights) {
    std::vector<std::pair<double, double>> seen;  // height and slope
    for (const Curve& part : parts) {
        const Length length = part.length();
        Pose pose = part.start;
        Length passed;
        std::size_t piece = 0;
        for (Length way; way < length; way += kLook) {
            while (piece + 1 < part.pieces.size() && passed + part.pieces[piece].length < way) {
                pose = advanced(pose, part.pieces[piece], part.pieces[piece].length);
                passed += part.pieces[piece].length;
                ++piece;
            }
            const Point at = advanced(pose, part.pieces[piece], way - passed).position;
            const double stepM = std::max(heights.cellM, 1.0);
            const auto height = heightAt(heights, at);
            const auto east = heightAt(heights, at + Point{stepM, 0.0});
            const auto north = heightAt(heights, at + Point{0.0, stepM});
            if (height && east && north) {
                seen.emplace_back(*height, std::hypot(*east - *height, *north - *height) / stepM);
            }
        }
    }
    double mean = 0.0;
    double slope = 0.0;
    for (const auto& [height, here] : seen) {
        mean += height / static_cast<double>(seen.size());
        slope += here / static_cast<double>(seen.size());
    }
    double sum = 0.0;
    for (const auto& [height, here] : seen) {
        sum += (height - mean) * (height - mean) / static_cast<double>(seen.size());
    }
    return seen.empty() ? 0.0 : std::sqrt(sum) / std::max(slope, kFlat);
}

/// Lays swaths in regions, contour by contour.
class ContourLayer {
public:
    ContourLayer(const SwathTask& task, const SwathSpacing& spacing, ElevationGrid heights)
        : task_{task},
          spacing_{spacing},
          heights_{std::move(heights)},
          mainland_{task.mainland},
          radius_{swathRadius(task.machine)},
          reach_{metres(mainland_.box().width() + mainland_.box().height())} {
        for (const Polygon& polygon : task.mainland) {
            regions_.push_back({polygon});
        }
    }

    Result<std::vector<SwathLine>> lay(const JobContext& job) {
        while (!regions_.empty()) {
            if (job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            const Region region = std::move(regions_.front());
            regions_.pop_front();
            if (const auto laid = layBlock(region, job); !laid) {
                return std::unexpected(laid.error());
            }
        }
        // Blocks are ordered uphill, like the tracks of one block.
        std::ranges::stable_sort(blocks_, {}, &Block::heightM);
        std::vector<SwathLine> all;
        int firstTrack = 0;
        for (Block& block : blocks_) {
            int last = firstTrack;
            for (SwathLine& line : block.lines) {
                line.track += firstTrack;
                last = std::max(last, line.track + 1);
                all.push_back(std::move(line));
            }
            firstTrack = last;
        }
        return all;
    }

private:
    /// The longest contour line of this height in a region, or its longest edge.
    Result<GuideLine> guideFor(const Polygon& region, const MainlandEdges& edges, double heightM,
                               bool alongEdge) const {
        Polyline contour =
            opened(longestInside(contourLines(heights_, heightM), edges), 2.0 * spacing_.width.si());
        if (alongEdge || contour.size() < 2 || lengthM(contour) < 2.0 * spacing_.width.si()) {
            contour = longestEdge(region);
        }
        const auto guide = guideCurve(contour, radius_, reach_, kElevation.key);
        // A line that turns back on itself is no guide.
        return guide ? guide : guideCurve(longestEdge(region), radius_, reach_, kElevation.key);
    }

    /// Where parallels lie that cover a region.
    std::vector<double> placesBeside(const ParallelLines& parallels, const MainlandEdges& edges) const {
        double lowM = std::numeric_limits<double>::infinity();
        double highM = -lowM;
        for (const Point& point : edges.pointsAlong(kLook)) {
            const double leftM = parallels.leftOf(point);
            lowM = std::min(lowM, leftM);
            highM = std::max(highM, leftM);
        }
        return trackPlaces(lowM, highM, spacing_, true);
    }

    Result<void> layBlock(const Region& given, const JobContext& job) {
        const Polygon& region = given.outline;
        const MainlandEdges edges{{region}};
        const double middleM = medianOf(heightsIn(heights_, edges));
        const auto guide = guideFor(region, edges, middleM, given.anyway);
        if (!guide) {
            return std::unexpected(guide.error());
        }
        // Swaths reach half a width into the neighbouring block, so that nothing is left between the two.
        auto around = dilated({region}, 0.5 * spacing_.width, metres(0.1), job)
                          .and_then([&](const MultiPolygon& wider) {
                              return intersection(wider, task_.mainland, job);
                          });
        if (!around) {
            return std::unexpected(around.error());
        }
        const ParallelLines parallels{*guide};
        const std::vector<double> places = placesBeside(parallels, edges);
        const MainlandEdges working{*around};
        Block block{.heightM = middleM, .lines = {}};
        const bool isLast = given.anyway || blocks_.size() + 1 >= kMostBlocks;
        // From the contour outwards, to both sides, until a parallel leaves its own contour.
        const auto nearest = static_cast<std::size_t>(
            std::ranges::min_element(places, {}, [](double place) { return std::abs(place); }) -
            places.begin());
        std::size_t first = nearest;
        std::size_t last = nearest;
        std::vector<std::vector<Curve>> parts(places.size());
        const auto follows = [&](std::size_t i) {
            for (const GuideLine& line : parallels.at(places[i], radius_)) {
                for (Curve& part : working.partsInside(drivable(line))) {
                    if (part.length() >= spacing_.width) {
                        parts[i].push_back(std::move(part));
                    }
                }
            }
            return i == nearest || isLast ||
                   awayM(parts[i], heights_) <= std::max(kMostAwayWidths * spacing_.width.si(), kMostAwayM);
        };
        follows(nearest);
        while (last + 1 < places.size() && follows(last + 1)) {
            ++last;
        }
        while (first > 0 && follows(first - 1)) {
            --first;
        }
        for (std::size_t i = first; i <= last; ++i) {
            for (Curve& part : parts[i]) {
                block.lines.push_back({static_cast<int>(i), std::move(part)});
            }
        }
        MultiPolygon worked;
        for (const SwathLine& line : block.lines) {
            addStrips(line.line, spacing_.width + kJoined, worked);
        }
        blocks_.push_back(std::move(block));
        return leaveRest(given, worked, job);
    }

    /// Keeps the rest of a block for a later block, except slivers.
    Result<void> leaveRest(const Region& region, const MultiPolygon& worked, const JobContext& job) {
        const Length sliver = 0.25 * spacing_.width;
        const auto rest =
            unionOf(worked, job, kSnapGrid)
                .and_then([&](const MultiPolygon& all) {
                    return difference({region.outline}, all, job, kSnapGrid);
                })
                .and_then([&](const MultiPolygon& left) { return eroded(left, sliver, metres(0.05), job); })
                .and_then([&](const MultiPolygon& core) { return dilated(core, sliver, metres(0.05), job); });
        if (!rest) {
            return std::unexpected(rest.error());
        }
        const double widthM = spacing_.width.si();
        for (const Polygon& piece : *rest) {
            const bool isSlow = area(piece) > kProgress * area(region.outline);
            // A piece that did not shrink would come back endlessly.
            if (area(piece).si() > 2.0 * widthM * widthM && !(isSlow && region.anyway)) {
                regions_.push_back({piece, isSlow});
            }
        }
        return {};
    }

    const SwathTask& task_;
    SwathSpacing spacing_;
    ElevationGrid heights_;
    MainlandEdges mainland_;
    Length radius_;
    Length reach_;
    std::deque<Region> regions_;
    std::vector<Block> blocks_;
};

Result<SwathSet> alongContours(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (task.guides == nullptr || !task.guides->elevation) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "contour needs heights",
                                     .where = std::string{kElevation.key},
                                     .remedy = "name a raster of heights, such as a GeoTIFF"});
    }
    const auto spacing = spacingFor(task);
    if (!spacing) {
        return std::unexpected(spacing.error());
    }
    // A machine cannot follow shapes smaller than its width or its bends.
    const Length evened =
        std::max({2.0 * task.machine.operatingWidth(), 2.0 * task.machine.minTurningRadius(), kLeastEvened});
    return ContourLayer{task, *spacing, smoothed(*task.guides->elevation, evened)}
        .lay(job.part(0.0, 0.5))
        .and_then([&](const std::vector<SwathLine>& lines) {
            return swathsOnLines(lines, task, job.part(0.5, 1.0));
        });
}

constexpr const Parameter* kContourParameters[] = {&kElevation};

}  // namespace

const Parameter kElevation{
    .key = "swaths.elevation",
    .name = "Heights",
    .description = "A raster of heights in metres that covers the field, such as a GeoTIFF.",
    .kind = ParameterKind::File,
    .standard = {},
    .choices = {}};

const Method<SwathGenerator> kContourMethod{
    .info = {.id = "contour",
             .name = "Along the contours",
             .description =
                 "Across the slope: beside a line of equal height, and a new one where that no longer fits.",
             .parameters = kContourParameters},
    .run = alongContours};

}  // namespace furrow
