#include "planner/gdal/feature_shapes.h"

#include <cmath>
#include <memory>
#include <utility>

namespace furrow {

namespace {

// Two chords per 2 degrees of arc: 1.5 cm beside the circle of a centre pivot of 400 m radius.
constexpr double kArcStepDeg = 1.0;

// A millimetre on the ground.
constexpr double kSamePointDeg = 1e-8;

bool isClosed(const OGRSimpleCurve& line) {
    const int last = line.getNumPoints() - 1;
    return last >= 1 && line.getX(0) == line.getX(last) && line.getY(0) == line.getY(last);
}

GeoRing openRing(const OGRSimpleCurve& line, const ToWgs84& toWgs84) {
    GeoRing ring = toWgs84.points(line);
    if (isClosed(line)) {
        ring.pop_back();
    }
    return ring;
}

/// Of a polygon, whose rings have to end where they begin.
GeoRing polygonRing(const OGRLinearRing& line, const ToWgs84& toWgs84, VectorFeature& feature) {
    GeoRing ring = openRing(line, toWgs84);
    const bool ends = isClosed(line) || (std::abs(ring.back().lonDeg - ring.front().lonDeg) < kSamePointDeg &&
                                         std::abs(ring.back().latDeg - ring.front().latDeg) < kSamePointDeg);
    if (!ends) {
        feature.openRings.push_back(ring.front());
    }
    return ring;
}

void addPolygon(const OGRPolygon& polygon, const ToWgs84& toWgs84, VectorFeature& feature) {
    const OGRLinearRing* outer = polygon.getExteriorRing();
    if (outer == nullptr || outer->getNumPoints() == 0) {
        return;
    }
    GeoPolygon added{.outer = polygonRing(*outer, toWgs84, feature), .holes = {}};
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
        if (polygon.getInteriorRing(i)->getNumPoints() > 0) {
            added.holes.push_back(polygonRing(*polygon.getInteriorRing(i), toWgs84, feature));
        }
    }
    feature.polygons.push_back(std::move(added));
}

void addGeometry(const OGRGeometry& geometry, const ToWgs84& toWgs84, VectorFeature& feature) {
    if (geometry.hasCurveGeometry() != 0) {
        const std::unique_ptr<OGRGeometry> chords{geometry.getLinearGeometry(kArcStepDeg)};
        if (chords) {
            addGeometry(*chords, toWgs84, feature);
        }
        return;
    }
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPolygon:
        case wkbTriangle: addPolygon(*geometry.toPolygon(), toWgs84, feature); break;
        case wkbMultiPolygon:
        case wkbMultiLineString:
        case wkbMultiPoint:
        case wkbGeometryCollection:
            for (const OGRGeometry* member : *geometry.toGeometryCollection()) {
                addGeometry(*member, toWgs84, feature);
            }
            break;
        case wkbPolyhedralSurface:
        case wkbTIN:
            for (const OGRPolygon* member : *geometry.toPolyhedralSurface()) {
                addPolygon(*member, toWgs84, feature);
            }
            break;
        case wkbLineString: {
            const OGRLineString& line = *geometry.toLineString();
            if (line.getNumPoints() >= 4 && isClosed(line)) {
                feature.closedLines.push_back(openRing(line, toWgs84));
            } else if (line.getNumPoints() > 1) {
                feature.openLines.push_back(toWgs84.points(line));
            }
            break;
        }
        case wkbPoint:
            if (geometry.IsEmpty() == 0) {
                feature.points.push_back(toWgs84.point(*geometry.toPoint()));
            }
            break;
        default: break;
    }
}

}  // namespace

Result<void> addShapes(const OGRGeometry& geometry, const ToWgs84& toWgs84, VectorFeature& feature,
                       const std::string& where) {
    addGeometry(geometry, toWgs84, feature);
    return toWgs84.known() ? Result<void>{} : checkDegrees(feature, where);
}

}  // namespace furrow
