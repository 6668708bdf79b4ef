#include "tests/support/wkt.h"

#include <cstdlib>
#include <string>

namespace furrow::test {

MultiPolygon polygonsAsInFile(std::string_view wkt) {
    const std::string text{wkt};
    const int polygonDepth = text.starts_with("MULTI") ? 2 : 1;
    MultiPolygon polygons;
    Ring* ring = nullptr;
    int depth = 0;
    for (std::size_t i = text.find('('); i < text.size();) {
        const char letter = text[i];
        if (letter == '(') {
            ++depth;
            if (depth == polygonDepth) {
                polygons.emplace_back();
                ring = nullptr;
            } else if (depth == polygonDepth + 1) {
                Polygon& polygon = polygons.back();
                ring = ring == nullptr ? &polygon.outer : &polygon.holes.emplace_back();
            }
            ++i;
        } else if (letter == ')') {
            --depth;
            ++i;
        } else if (letter == ',' || letter == ' ') {
            ++i;
        } else {
            char* end = nullptr;
            const double x = std::strtod(text.c_str() + i, &end);
            const double y = std::strtod(end, &end);
            ring->push_back({x, y});
            i = static_cast<std::size_t>(end - text.c_str());
        }
    }
    return polygons;
}

MultiPolygon polygonsFromWkt(std::string_view wkt) {
    MultiPolygon polygons = polygonsAsInFile(wkt);
    const auto open = [](Ring& ring) {
        if (ring.size() > 1 && ring.front() == ring.back()) {
            ring.pop_back();
        }
    };
    for (Polygon& polygon : polygons) {
        open(polygon.outer);
        for (Ring& hole : polygon.holes) {
            open(hole);
        }
    }
    return polygons;
}

Polyline lineFromWkt(std::string_view wkt) {
    const std::string text{wkt};
    return polygonsAsInFile("POLYGON(" + text.substr(text.find('(')) + ")").front().outer;
}

}  // namespace furrow::test
