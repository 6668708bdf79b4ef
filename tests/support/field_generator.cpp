#include "tests/support/field_generator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow::test {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Ring reversed(Ring ring) {
    std::ranges::reverse(ring);
    return ring;
}

/// Corners on a circle at rising angles: strictly convex.
Ring convexRing(std::mt19937_64& random, double radiusM) {
    const int count = 4 + static_cast<int>(uniform(random, 0.0, 12.0));
    const double flattening = uniform(random, 0.3, 1.0);
    Ring ring;
    for (int i = 0; i < count; ++i) {
        const double angle = kTwoPi * (i + uniform(random, 0.0, 0.8)) / count;
        ring.push_back({radiusM * std::cos(angle), flattening * radiusM * std::sin(angle)});
    }
    return ring;
}

/// Corners at rising angles and any distance: seen as a whole from the origin, so nothing crosses.
Ring starRing(std::mt19937_64& random, int count, double nearestM, double farthestM) {
    Ring ring;
    for (int i = 0; i < count; ++i) {
        const double angle = kTwoPi * (i + uniform(random, 0.0, 0.8)) / count;
        ring.push_back(uniform(random, nearestM, farthestM) * direction(angle));
    }
    return ring;
}

/// A star that keeps clear of the holes in it: its edges stay outside 0.52 radii, the holes inside 0.45.
Polygon withHoles(std::mt19937_64& random, double radiusM) {
    Polygon polygon{.outer = starRing(random, 12, 0.6 * radiusM, radiusM), .holes = {}};
    const int count = 1 + static_cast<int>(uniform(random, 0.0, 4.0));
    for (int i = 0; i < count; ++i) {
        Ring hole = starRing(random, 7, 0.05 * radiusM, 0.15 * radiusM);
        const Point middle = 0.3 * radiusM * direction(kTwoPi * i / count);
        for (Point& corner : hole) {
            corner = corner + middle;
        }
        polygon.holes.push_back(reversed(std::move(hole)));
    }
    return polygon;
}

}  // namespace

std::string_view shapeName(Shape shape) {
    switch (shape) {
        case Shape::Convex: return "convex";
        case Shape::Concave: return "concave";
        case Shape::Holes: return "with holes";
        case Shape::Thin: return "thin";
        case Shape::Parts: return "two parts";
    }
    return "";
}

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

MultiPolygon randomPolygons(std::mt19937_64& random, Shape shape, double radiusM) {
    MultiPolygon polygons;
    switch (shape) {
        case Shape::Convex: polygons.push_back({.outer = convexRing(random, radiusM), .holes = {}}); break;
        case Shape::Concave: {
            const int count = 6 + static_cast<int>(uniform(random, 0.0, 20.0));
            polygons.push_back({.outer = starRing(random, count, 0.35 * radiusM, radiusM), .holes = {}});
            break;
        }
        case Shape::Holes: polygons.push_back(withHoles(random, radiusM)); break;
        case Shape::Thin: {
            Ring ring = starRing(random, 10, 0.5 * radiusM, radiusM);
            const double share = uniform(random, 0.03, 0.1);
            for (Point& corner : ring) {
                corner.y *= share;
            }
            polygons.push_back({.outer = std::move(ring), .holes = {}});
            break;
        }
        case Shape::Parts:
            for (const double side : {-1.0, 1.0}) {
                Ring ring = starRing(random, 9, 0.15 * radiusM, 0.4 * radiusM);
                for (Point& corner : ring) {
                    corner.x += side * 0.5 * radiusM;
                }
                polygons.push_back({.outer = std::move(ring), .holes = {}});
            }
            break;
    }
    const Angle turn = radians(uniform(random, 0.0, kTwoPi));
    const Point by{uniform(random, -1000.0, 1000.0), uniform(random, -1000.0, 1000.0)};
    return moved(polygons, turn, by);
}

Polygon rectangle(double widthM, double heightM, Point lowerLeft) {
    return {.outer = {lowerLeft, lowerLeft + Point{widthM, 0.0}, lowerLeft + Point{widthM, heightM},
                      lowerLeft + Point{0.0, heightM}},
            .holes = {}};
}

Polygon centredRectangle(double widthM, double heightM) {
    return rectangle(widthM, heightM, {-0.5 * widthM, -0.5 * heightM});
}

MultiPolygon moved(const MultiPolygon& polygons, Angle turn, Point by) {
    const Point along = direction(turn.si());
    const auto move = [&](Ring& ring) {
        for (Point& point : ring) {
            point = by + point.x * along + point.y * Point{-along.y, along.x};
        }
    };
    MultiPolygon result = polygons;
    for (Polygon& polygon : result) {
        move(polygon.outer);
        std::ranges::for_each(polygon.holes, move);
    }
    return result;
}

FieldSource fieldSourceFromLocal(const MultiPolygon& polygons, GeoPoint centre) {
    const LocalFrame frame = LocalFrame::centredOn(centre).value();
    FieldSource source{
        .id = "generated", .name = "Generated", .origin = {}, .parts = {}, .obstacles = {}, .gates = {}};
    for (const Polygon& polygon : polygons) {
        source.parts.push_back(frame.toGeo(polygon));
    }
    return source;
}

}  // namespace furrow::test
