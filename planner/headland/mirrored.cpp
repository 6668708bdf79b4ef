#include "planner/headland/mirrored.h"

#include "planner/units/angle.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

Point mirroredPoint(Point point) {
    return {point.x, -point.y};
}

Ring mirroredRing(const Ring& ring) {
    Ring turned;
    turned.reserve(ring.size());
    std::ranges::transform(ring.rbegin(), ring.rend(), std::back_inserter(turned), mirroredPoint);
    return turned;
}

}  // namespace

MultiPolygon mirrored(const MultiPolygon& polygons) {
    MultiPolygon all;
    for (const Polygon& polygon : polygons) {
        all.push_back({.outer = mirroredRing(polygon.outer), .holes = {}});
        std::ranges::transform(polygon.holes, std::back_inserter(all.back().holes), mirroredRing);
    }
    return all;
}

AllowedAreas mirrored(const AllowedAreas& areas) {
    return {mirrored(areas.tractor()),
            areas.hasOverhang() ? std::optional{mirrored(areas.implement())} : std::nullopt};
}

Machine mirrored(const Machine& machine) {
    MachineSpec spec = machine.spec();
    spec.implement.lateralOffset = -spec.implement.lateralOffset;
    // The rules for a machine do not depend on the side, so the value exists.
    return Machine::create(spec).value();
}

Curve mirrored(const Curve& turn) {
    Curve other = turn;
    other.start = {.position = mirroredPoint(turn.start.position),
                   .heading = normalisedPoseHeading(-turn.start.heading)};
    for (CurvePiece& piece : other.pieces) {
        piece.curvature = -piece.curvature;
        piece.endCurvature = -piece.endCurvature;
    }
    return other;
}

std::vector<EdgeStrip> mirrored(const std::vector<EdgeStrip>& strips) {
    std::vector<EdgeStrip> others = strips;
    for (EdgeStrip& strip : others) {
        strip.from = mirroredPoint(strip.from);
        strip.to = mirroredPoint(strip.to);
        std::swap(strip.from, strip.to);
    }
    return others;
}

std::vector<HeadlandPass> mirrored(const std::vector<HeadlandPass>& passes) {
    std::vector<HeadlandPass> others = passes;
    for (HeadlandPass& pass : others) {
        for (PassStretch& stretch : pass.stretches) {
            stretch.line = mirrored(stretch.line);
        }
    }
    return others;
}

}  // namespace furrow
