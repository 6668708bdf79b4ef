#include "ui/edit/inspector_text.h"

#include "planner/editing/outline_edits.h"
#include "planner/path/tank_levels.h"
#include "planner/path/turn_shape.h"
#include "planner/units/angle.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Inspector)
};

constexpr double kLongestEdgeM = 100000.0;

InspectorRow figure(const QString& label, const QString& text) {
    return {.label = label, .text = text};
}

InspectorRow numberRow(const QString& label, InspectorField field, double number, QuantityText::Kind quantity,
                       int decimals, double from, double to) {
    return {.label = label,
            .text = {},
            .field = field,
            .number = number,
            .quantity = quantity,
            .decimals = decimals,
            .from = from,
            .to = to};
}

InspectorRow nameRow(const std::string& name) {
    return {.label = Words::tr("Name"), .text = fromStd(name), .field = InspectorField::Name};
}

QString nameOf(const OutlineId& id) {
    switch (id.kind) {
        case OutlineKind::Boundary: return Words::tr("boundary");
        case OutlineKind::Hole: return Words::tr("hole");
        case OutlineKind::Obstacle: return Words::tr("obstacle");
        case OutlineKind::Split: return Words::tr("split line");
        case OutlineKind::Guide: break;
    }
    return Words::tr("guidance line");
}

double bearingDegOf(Point way) {
    const double bearing = std::atan2(way.x, way.y) * 180.0 / std::numbers::pi;
    return bearing < 0.0 ? bearing + 360.0 : bearing;
}

Area areaOf(const Outline& outline) {
    return Area::fromSi(std::abs(signedAreaM2(outline.points)));
}

InspectorText vertexText(const Outline& outline, std::size_t vertex) {
    InspectorText text;
    text.title = Words::tr("Point %1 of the %2").arg(vertex + 1).arg(nameOf(outline.id));
    const bool end = !outline.closed && (vertex == 0 || vertex + 1 == outline.points.size());
    text.sentence = Words::tr("Drag it on the map, move it by arrow keys, or type where it is.");
    text.rows = {numberRow(Words::tr("Latitude"), InspectorField::Latitude, outline.places[vertex].latDeg,
                           QuantityText::Angle, 8, -90.0, 90.0),
                 numberRow(Words::tr("Longitude"), InspectorField::Longitude, outline.places[vertex].lonDeg,
                           QuantityText::Angle, 8, -180.0, 180.0)};
    if (!end) {
        text.rows.push_back(figure(Words::tr("Angle"), Words::tr("%1°").arg(numberText(
                                                           inDegrees(cornerAngle(outline, vertex)), 1))));
    }
    return text;
}

QString splitSentence() {
    return Words::tr(
        "The field inside the headland is cut along it, where it runs right through. Drag it or its points, or delete it.");
}

/// How far the implement may stand over an edge or an obstacle.
InspectorRow overhangRow(InspectorField field, Length overhang) {
    return numberRow(Words::tr("Overhang"), field, overhang.si(), QuantityText::Length, 2, 0.0, 100.0);
}

/// How wide the headland along an edge of the field is: as said for it, or as wide as the plan has it.
std::optional<Length> headlandAlong(const Outline& outline, std::size_t edge, const FieldSource* source,
                                    const Plan* plan) {
    const OutlineId& id = outline.id;
    if (source == nullptr || (id.kind != OutlineKind::Boundary && id.kind != OutlineKind::Hole)) {
        return std::nullopt;
    }
    if (const EdgeWidth* own = findEdgeWidth(*source, &FieldSource::edgeHeadlands, id, edge)) {
        return own->width;
    }
    if (plan == nullptr) {
        return std::nullopt;
    }
    const LocalFrame& frame = plan->field().frame();
    const Point from = frame.toLocal(outline.places[edge]);
    const Point to = frame.toLocal(outline.places[(edge + 1) % outline.places.size()]);
    return widthBeside(plan->headland, 0.5 * (from + to));
}

InspectorText edgeText(const Outline& outline, std::size_t edge, const FieldSource* source,
                       const Plan* plan) {
    InspectorText text;
    const Point way = outline.to(edge) - outline.from(edge);
    if (outline.id.kind == OutlineKind::Guide && outline.points.size() == 2) {
        text.title = Words::tr("AB line");
        text.sentence = Words::tr(
            "One swath lies on it, the others beside it. Drag it or its ends, or type its direction.");
    } else if (outline.id.kind == OutlineKind::Split && outline.points.size() == 2) {
        text.title = Words::tr("Split line %1").arg(outline.id.item + 1);
        text.sentence = splitSentence();
    } else {
        text.title = Words::tr("Edge %1 of the %2").arg(edge + 1).arg(nameOf(outline.id));
        text.sentence = Words::tr("Drag it to move it sideways; the dot in its middle makes another point.");
    }
    text.isEdge = outline.id.kind != OutlineKind::Guide;
    text.rows = {numberRow(Words::tr("Length"), InspectorField::EdgeLength, norm(way), QuantityText::Length,
                           2, 0.01, kLongestEdgeM),
                 numberRow(Words::tr("Direction"), InspectorField::EdgeBearing, bearingDegOf(way),
                           QuantityText::Angle, 2, 0.0, 360.0)};
    if (const auto headland = headlandAlong(outline, edge, source, plan)) {
        text.rows.push_back(numberRow(Words::tr("Headland"), InspectorField::EdgeHeadland, headland->si(),
                                      QuantityText::Length, 2, 0.0, 500.0));
        text.hasOwnHeadland =
            findEdgeWidth(*source, &FieldSource::edgeHeadlands, outline.id, edge) != nullptr;
    }
    if (source != nullptr &&
        (outline.id.kind == OutlineKind::Boundary || outline.id.kind == OutlineKind::Hole)) {
        const EdgeWidth* own = findEdgeWidth(*source, &FieldSource::edgeOverhangs, outline.id, edge);
        text.rows.push_back(
            overhangRow(InspectorField::EdgeOverhang, own == nullptr ? Length{} : own->width));
    }
    return text;
}

InspectorText obstacleText(const Outline& outline, const Obstacle& obstacle) {
    InspectorText text;
    text.title = obstacle.name.empty() ? Words::tr("Obstacle") : fromStd(obstacle.name);
    text.sentence = obstacle.passable
                        ? Words::tr("It is not worked, but may be driven on.")
                        : Words::tr("It is not worked, and nothing drives nearer than its buffer.");
    text.rows = {nameRow(obstacle.name),
                 numberRow(Words::tr("Buffer"), InspectorField::Buffer, obstacle.buffer.si(),
                           QuantityText::Length, 2, 0.0, 1000.0),
                 figure(Words::tr("Area"), areaText(areaOf(outline)))};
    if (!obstacle.passable) {
        text.rows.insert(text.rows.end() - 1,
                         overhangRow(InspectorField::ObstacleOverhang, obstacle.overhang));
    }
    text.passable = obstacle.passable;
    return text;
}

/// The whole turn that a segment is a part of, as a driver would call it.
void addTurn(InspectorText& text, const Plan& plan, std::size_t index) {
    for (const DrivenTurn& turn : drivenTurns(plan.path)) {
        if (index < turn.firstSegment || index >= turn.firstSegment + turn.segmentCount) {
            continue;
        }
        text.rows.push_back(figure(Words::tr("Kind"), shown(nameOf(turn.shape))));
        if (turn.segmentCount > 1) {
            text.rows.push_back(
                figure(Words::tr("Whole turn"),
                       inOneLine({metresText(turn.length, 1), exactDurationText(turn.duration)})));
        }
        return;
    }
}

/// A part of the way to a refill point, or of the way back.
void addRefill(InspectorText& text, const Plan& plan, std::size_t index) {
    const PathSegment& segment = plan.path.segments[index];
    const bool unloads = plan.refill && plan.refill->work.gathers;
    text.title = sentence(tripName(plan.path.segments, index, unloads));
    text.sentence = Words::tr("%1 without working, in %2.")
                        .arg(metresText(segment.length(), 1), exactDurationText(segment.duration()));
    const auto& tank = plan.request.machine.spec().tank;
    if (const auto level = segment.samples.front().level; level && tank && tank->capacity > 0.0) {
        text.rows.push_back(figure(unloads ? Words::tr("In the bunker") : Words::tr("In the tank"),
                                   inOneLine({numberText(*level, 0), percentText(*level / tank->capacity)})));
    }
    if (segment.refills && tank) {
        text.rows.push_back(figure(Words::tr("Then stands"), exactDurationText(tank->fillTime())));
    }
}

InspectorText segmentText(const Plan& plan, std::size_t index) {
    const PathSegment& segment = plan.path.segments[index];
    const PathSegment* before = plan.path.workBefore(index);
    const PathSegment* after = plan.path.workAfter(index);
    const auto called = [](const PathSegment* work) {
        return work == nullptr                    ? Words::tr("the end")
               : work->kind == SegmentKind::Swath ? Words::tr("swath %1").arg(work->number)
                                                  : Words::tr("pass %1").arg(work->number);
    };
    const QString length = metresText(segment.length(), 1);
    const QString time = exactDurationText(segment.duration());
    InspectorText text;
    text.rows = {figure(Words::tr("Length"), length), figure(Words::tr("Time"), time)};
    switch (segment.kind) {
        case SegmentKind::Swath: {
            text.title = Words::tr("Swath %1").arg(segment.number);
            const auto order = std::ranges::count_if(
                plan.path.segments.begin(),
                plan.path.segments.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                [](const PathSegment& each) { return each.kind == SegmentKind::Swath; });
            text.sentence = Words::tr("Driven as number %1 of %2: %3 in %4.")
                                .arg(order)
                                .arg(plan.route.steps.size())
                                .arg(length, time);
            const Point way = segment.samples.back().position - segment.samples.front().position;
            text.rows.push_back(
                figure(Words::tr("Direction"), Words::tr("%1°").arg(numberText(bearingDegOf(way), 1))));
            text.rows.push_back(
                figure(Words::tr("Width"), metresText(plan.request.machine.operatingWidth(), 2)));
            break;
        }
        case SegmentKind::HeadlandPass:
            text.title = Words::tr("Headland pass %1").arg(segment.number);
            text.sentence =
                Words::tr("Counted from the outside; %1 are worked here in %2.").arg(length, time);
            break;
        case SegmentKind::Turn:
            text.title = Words::tr("Turn from %1 to %2").arg(called(before), called(after));
            text.sentence = segment.gear == Gear::Reverse
                                ? Words::tr("%1 in reverse, in %2.").arg(length, time)
                                : Words::tr("%1 with the implement up, in %2.").arg(length, time);
            addTurn(text, plan, index);
            break;
        case SegmentKind::Refill: addRefill(text, plan, index); break;
        case SegmentKind::Transfer:
        case SegmentKind::Wait:
            text.title = Words::tr("Way from %1 to %2").arg(called(before), called(after));
            text.sentence = Words::tr("%1 without working, in %2.").arg(length, time);
            break;
    }
    if (segment.folded) {
        text.sentence = Words::tr("%1 with the implement folded, in %2.").arg(length, time);
    }
    if (!segment.drivable) {
        text.sentence = Words::tr("It cannot be driven like this: %1.").arg(shown(segment.reason));
    }
    return text;
}

InspectorText cellText(const Plan& plan, std::size_t index) {
    const Cell& cell = plan.cells.cells[index];
    InspectorText text;
    text.title = Words::tr("Block %1").arg(index + 1);
    text.sentence = Words::tr("A piece of the field whose %n swath(s) are driven together.", nullptr,
                              static_cast<int>(cell.swaths.size()));
    text.rows = {figure(Words::tr("Area"), areaText(area(cell.outline))),
                 figure(Words::tr("Swaths"), QString::number(cell.swaths.size()))};
    return text;
}

InspectorText gateText(const Gate& gate) {
    InspectorText text;
    text.title = gate.name.empty() ? Words::tr("Gate") : fromStd(gate.name);
    text.sentence = Words::tr("Here the machine may enter and leave the field. Drag it along the boundary.");
    text.rows = {nameRow(gate.name), numberRow(Words::tr("Width"), InspectorField::GateWidth, gate.width.si(),
                                               QuantityText::Length, 2, 0.0, 100.0)};
    return text;
}

InspectorText lineText(const Outline& outline) {
    if (outline.points.size() == 2) {
        return edgeText(outline, 0, nullptr, nullptr);
    }
    const bool split = outline.id.kind == OutlineKind::Split;
    InspectorText text;
    text.title = split ? Words::tr("Split line %1").arg(outline.id.item + 1) : Words::tr("Guidance curve");
    text.sentence =
        split ? splitSentence() : Words::tr("The swaths lie beside it. Drag its points, or delete it.");
    text.rows = {figure(Words::tr("Length"), lengthText(metres(lengthM(outline.points)))),
                 figure(Words::tr("Points"), QString::number(outline.points.size()))};
    return text;
}

}  // namespace

std::optional<InspectorText> inspectorText(const Selection& selection, const FieldShape* shape,
                                           const FieldSource* source, const Plan* plan) {
    const Outline* outline = shape == nullptr ? nullptr : shape->find(selection.outline);
    const std::size_t index = selection.index;
    switch (selection.kind) {
        case Selection::Kind::None: break;
        case Selection::Kind::Vertex:
            return outline != nullptr && index < outline->points.size()
                       ? std::optional{vertexText(*outline, index)}
                       : std::nullopt;
        case Selection::Kind::Edge:
            return outline != nullptr && index < outline->edgeCount()
                       ? std::optional{edgeText(*outline, index, source, plan)}
                       : std::nullopt;
        case Selection::Kind::Hole:
            if (outline != nullptr) {
                InspectorText text;
                text.title = Words::tr("Hole");
                text.sentence = Words::tr("It is no part of the field. Drag it, or its points and edges.");
                text.rows = {figure(Words::tr("Area"), areaText(areaOf(*outline)))};
                return text;
            }
            break;
        case Selection::Kind::Obstacle:
            return outline != nullptr && source != nullptr && outline->id.item < source->obstacles.size()
                       ? std::optional{obstacleText(*outline, source->obstacles[outline->id.item])}
                       : std::nullopt;
        case Selection::Kind::Gate:
            return source != nullptr && index < source->gates.size()
                       ? std::optional{gateText(source->gates[index])}
                       : std::nullopt;
        case Selection::Kind::Guide:
        case Selection::Kind::Split:
            return outline != nullptr ? std::optional{lineText(*outline)} : std::nullopt;
        case Selection::Kind::Segment:
            return plan != nullptr && index < plan->path.segments.size()
                       ? std::optional{segmentText(*plan, index)}
                       : std::nullopt;
        case Selection::Kind::Cell:
            return plan != nullptr && index < plan->cells.cells.size() ? std::optional{cellText(*plan, index)}
                                                                       : std::nullopt;
        case Selection::Kind::Finding: break;  // its row in the list says all of it
    }
    return std::nullopt;
}

void addOptions(InspectorText& text, const TurnOptions& options) {
    text.rows.push_back(figure(Words::tr("From the edge"), metresText(options.clearance, 2)));
    for (const TurnOption& other : options.others) {
        text.rows.push_back(figure(Words::tr("Instead: %1").arg(shown(other.name)),
                                   other.fits ? Words::tr("about %1").arg(exactDurationText(other.duration))
                                              : Words::tr("no room")));
    }
}

}  // namespace furrow
