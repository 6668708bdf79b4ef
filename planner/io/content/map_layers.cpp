#include "planner/io/content/map_layers.h"

#include "planner/plan/plan.h"
#include "planner/units/angle.h"

#include <utility>

namespace furrow {

namespace {

using Kind = VectorLayer::Kind;
using Shape = VectorLayer::Shape;

const VectorLayer::Column kKind{"kind", Kind::Text, 16};
const VectorLayer::Column kName{"name", Kind::Text, 64};

VectorLayer boundaryLayer(const ExportJob& job) {
    VectorLayer layer{
        "boundary", Shape::Polygons, {kKind, {"id", Kind::Text, 64}, kName, {"area_m2", Kind::Real}}, {}};
    for (const FieldContent& content : job.fields) {
        layer.features.push_back(
            {.polygons = content.field.parts,
             .values = {"field", content.field.id, content.field.name, content.statedArea().si()}});
    }
    return layer;
}

VectorLayer obstacleLayer(const ExportJob& job) {
    VectorLayer layer{
        "obstacles",
        Shape::Polygons,
        {kKind, kName, {"passable", Kind::Whole, 1}, {"buffer_m", Kind::Real}, {"overhang_m", Kind::Real}},
        {}};
    for (const FieldContent& content : job.fields) {
        for (const Obstacle& obstacle : content.field.obstacles) {
            layer.features.push_back(
                {.polygons = {obstacle.outline},
                 .values = {"obstacle", obstacle.name, std::int64_t{obstacle.passable ? 1 : 0},
                            obstacle.buffer.si(), obstacle.overhang.si()}});
        }
    }
    return layer;
}

VectorLayer gateLayer(const ExportJob& job) {
    VectorLayer layer{"gates", Shape::Point, {kKind, kName, {"width_m", Kind::Real}}, {}};
    for (const FieldContent& content : job.fields) {
        for (const Gate& gate : content.field.gates) {
            layer.features.push_back(
                {.line = {gate.position}, .values = {"gate", gate.name, gate.width.si()}});
        }
    }
    return layer;
}

VectorLayer mainlandLayer(const ExportJob& job) {
    VectorLayer layer{"mainland", Shape::Polygons, {kKind}, {}};
    for (const FieldContent& content : job.fields) {
        if (!content.mainland.empty()) {
            layer.features.push_back({.polygons = content.mainland, .values = {"mainland"}});
        }
    }
    return layer;
}

VectorLayer guidanceLayer(const ExportJob& job) {
    VectorLayer layer{
        "guidance",
        Shape::Line,
        {kKind, kName, {"guidance", Kind::Text, 12}, {"width_m", Kind::Real}, {"bearing", Kind::Real}},
        {}};
    for (const FieldContent& content : job.fields) {
        for (const GuidanceLine& line : content.lines) {
            GeoRing points = drawn(line, metres(100.0));
            if (points.size() >= 2) {
                layer.features.push_back(
                    {.line = std::move(points),
                     .values = {"guidance", line.name, std::string{guidanceKindId(line.kind)},
                                line.width.value_or(Length{}).si(),
                                line.bearing ? inDegrees(*line.bearing) : 0.0}});
            }
        }
    }
    return layer;
}

VectorLayer swathLayer(const Plan& plan) {
    VectorLayer layer{"swaths",
                      Shape::Line,
                      {kKind, {"number", Kind::Whole, 9}, {"order", Kind::Whole, 9}, {"width_m", Kind::Real}},
                      {}};
    for (std::size_t order = 0; order < plan.route.steps.size(); ++order) {
        const RouteStep& step = plan.route.steps[order];
        const Swath& swath = plan.swaths.swaths[step.swath];
        layer.features.push_back({.line = swathLine(plan, step),
                                  .values = {"swath", std::int64_t{swath.number},
                                             static_cast<std::int64_t>(order), swath.width.si()}});
    }
    return layer;
}

VectorLayer pathLayer(const Plan& plan) {
    VectorLayer layer{"path",
                      Shape::Line,
                      {kKind,
                       {"order", Kind::Whole, 9},
                       {"segment", Kind::Text, 16},
                       {"gear", Kind::Whole, 2},
                       {"down", Kind::Whole, 1},
                       {"drivable", Kind::Whole, 1}},
                      {}};
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const PathSegment& segment = plan.path.segments[i];
        layer.features.push_back(
            {.line = pathLine(plan, i),
             .values = {"path", static_cast<std::int64_t>(i), std::string{segmentKindId(segment.kind)},
                        std::int64_t{static_cast<int>(segment.gear)},
                        std::int64_t{segment.implementDown ? 1 : 0},
                        std::int64_t{segment.drivable ? 1 : 0}}});
    }
    return layer;
}

}  // namespace

GeoRing swathLine(const Plan& plan, const RouteStep& step) {
    return plan.field().frame().toGeo(drivenMiddle(step, plan.swaths));
}

GeoRing pathLine(const Plan& plan, std::size_t segment) {
    Polyline line;
    for (const PathSample& sample : plan.path.segments[segment].samples) {
        line.push_back(sample.position);
    }
    return plan.field().frame().toGeo(line);
}

std::vector<VectorLayer> mapLayers(const ExportJob& job) {
    std::vector<VectorLayer> layers{boundaryLayer(job), obstacleLayer(job), gateLayer(job),
                                    mainlandLayer(job)};
    if (job.plan != nullptr) {
        layers.push_back(swathLayer(*job.plan));
        layers.push_back(pathLayer(*job.plan));
    } else {
        layers.push_back(guidanceLayer(job));
    }
    std::erase_if(layers, [](const VectorLayer& layer) { return layer.features.empty(); });
    return layers;
}

}  // namespace furrow
