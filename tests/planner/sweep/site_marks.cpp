#include "tests/planner/sweep/site_marks.h"

#include "planner/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <fstream>
#include <limits>

namespace furrow::test {

namespace {

std::pair<Point, Point> longestEdge(const SweepSite& site) {
    std::pair<Point, Point> longest;
    for (const Polygon& polygon : site.field->boundary()) {
        for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
            const Point from = polygon.outer[i];
            const Point to = polygon.outer[(i + 1) % polygon.outer.size()];
            if (distance(from, to) > distance(longest.first, longest.second)) {
                longest = {from, to};
            }
        }
    }
    return longest;
}

Point alongLongestEdge(const SweepSite& site) {
    const auto [from, to] = longestEdge(site);
    return (1.0 / distance(from, to)) * (to - from);
}

Point leftOf(Point way) {
    return {-way.y, way.x};
}

std::string placeText(const SweepSite& site, Point point) {
    const GeoPoint place = site.field->frame().toGeo(point);
    return std::format("{:.9f} {:.9f}", place.lonDeg, place.latDeg);
}

}  // namespace

double insideM(const MultiPolygon& area, Point place) {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    forEachEdge(area, [&](Point a, Point b) {
        nearest = std::min(nearest, distanceToSegment(place, a, b));
        inside ^= meetsRay(place, a, b);
    });
    return inside ? nearest : -nearest;
}

Point middleOf(const SweepSite& site) {
    constexpr int kSteps = 24;
    const MultiPolygon& area = site.field->drivable();
    const Bounds box = bounds(area);
    Point best = box.min;
    double bestM = -std::numeric_limits<double>::infinity();
    for (int column = 1; column < kSteps; ++column) {
        for (int row = 1; row < kSteps; ++row) {
            const Point place = box.min + Point{box.width() * column / kSteps, box.height() * row / kSteps};
            if (const double inside = insideM(area, place); inside > bestM + 1e-6) {
                best = place;
                bestM = inside;
            }
        }
    }
    return best;
}

Polyline besideLongestEdge(const SweepSite& site, double widthsIn) {
    const auto [from, to] = longestEdge(site);
    const Point in = widthsIn * site.machine.operatingWidth().si() * leftOf(alongLongestEdge(site));
    return {from + in, to + in};
}

Polyline throughMiddle(const SweepSite& site, double turnedDeg, double reachM) {
    const Point edge = alongLongestEdge(site);
    const Point way = direction(std::atan2(edge.y, edge.x) + degrees(turnedDeg).si());
    const Point middle = middleOf(site);
    return {middle - reachM * way, middle + reachM * way};
}

Polyline bendAlongEdge(const SweepSite& site) {
    constexpr int kSteps = 12;
    const auto [from, to] = longestEdge(site);
    const Point in = leftOf(alongLongestEdge(site));
    const double lengthM = distance(from, to);
    Polyline line;
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        // A twentieth of its length deep: wide machines can follow it.
        line.push_back(from + share * (to - from) + 0.2 * lengthM * share * (1.0 - share) * in);
    }
    return line;
}

std::string lineText(const SweepSite& site, const Polyline& line) {
    std::string text;
    for (const Point& point : line) {
        text += (text.empty() ? "" : ", ") + placeText(site, point);
    }
    return "LINESTRING (" + text + ")";
}

std::string pointText(const SweepSite& site, Point point) {
    return "POINT (" + placeText(site, point) + ")";
}

std::string rowFile(const SweepSite& site, double widthsApart) {
    const Point along = alongLongestEdge(site);
    const Point across = leftOf(along);
    const Point from = longestEdge(site).first;
    const Bounds box = bounds(site.field->boundary());
    const double reachM = std::hypot(box.width(), box.height());
    const double apartM = widthsApart * site.machine.operatingWidth().si();
    std::string rows;
    // Where rows are planted they end before the fence: those without any field beside them are left out.
    for (double m = 0.5 * apartM; m < reachM; m += apartM) {
        double low = reachM;
        double high = -reachM;
        for (double s = -reachM; s <= reachM; s += 1.0) {
            if (insideM(site.field->drivable(), from + s * along + m * across) > 0.0) {
                low = std::min(low, s);
                high = std::max(high, s);
            }
        }
        if (high <= low) {
            continue;
        }
        const GeoPoint a = site.field->frame().toGeo(from + low * along + m * across);
        const GeoPoint b = site.field->frame().toGeo(from + high * along + m * across);
        rows += std::format(
            "{}{{\"type\":\"Feature\",\"properties\":{{}},\"geometry\":{{\"type\":\"LineString\","
            "\"coordinates\":"
            "[[{:.9f},{:.9f}],[{:.9f},{:.9f}]]}}}}",
            rows.empty() ? "" : ",\n", a.lonDeg, a.latDeg, b.lonDeg, b.latDeg);
    }
    const std::filesystem::path path = site.folder / std::format("rows_{}_widths.geojson", widthsApart);
    std::ofstream{path} << R"({"type":"FeatureCollection","features":[)" << rows << "]}\n";
    return path.string();
}

std::string heightFile(const SweepSite& site, bool hill) {
    constexpr double kCellDeg = 1e-4;
    constexpr double kAroundM = 60.0;
    const LocalFrame& frame = site.field->frame();
    const Bounds box = bounds(site.field->boundary());
    const GeoPoint low = frame.toGeo(box.min - Point{kAroundM, kAroundM});
    const GeoPoint high = frame.toGeo(box.max + Point{kAroundM, kAroundM});
    const int columns = static_cast<int>((high.lonDeg - low.lonDeg) / kCellDeg) + 2;
    const int rows = static_cast<int>((high.latDeg - low.latDeg) / kCellDeg) + 2;
    const double sizeM = std::hypot(box.width(), box.height());
    const std::filesystem::path path = site.folder / (hill ? "hill.asc" : "slope.asc");
    std::ofstream file{path};
    file << std::format(
        "ncols {}\nnrows {}\nxllcorner {:.9f}\nyllcorner {:.9f}\ncellsize {}\nNODATA_value -9999\n", columns,
        rows, low.lonDeg, low.latDeg, kCellDeg);
    for (int row = rows - 1; row >= 0; --row) {
        for (int column = 0; column < columns; ++column) {
            const Point at = frame.toLocal(
                GeoPoint{low.lonDeg + (column + 0.5) * kCellDeg, low.latDeg + (row + 0.5) * kCellDeg});
            const double height = hill ? 100.0 - 12.0 * (at.x * at.x + 0.5 * at.y * at.y) / (sizeM * sizeM)
                                       : 100.0 + 0.04 * at.y + 3.0 * std::sin(2.0 * at.x / sizeM);
            file << std::format("{:.4f} ", height);
        }
        file << '\n';
    }
    std::ofstream{std::filesystem::path{path}.replace_extension(".prj")}
        << R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
    return path.string();
}

}  // namespace furrow::test
