#include "planner/editing/field_shape.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

Outline outlineOf(OutlineId id, bool closed, const GeoRing& places, const LocalFrame& frame,
                  const FieldShape* before) {
    Outline outline{.id = id, .closed = closed, .places = places, .points = {}};
    const Outline* old = before == nullptr ? nullptr : before->find(id);
    if (old == nullptr || old->places.size() != places.size()) {
        outline.points = frame.toLocal(places);
        return outline;
    }
    outline.points = old->points;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] != old->places[i]) {
            outline.points[i] = frame.toLocal(places[i]);
        }
    }
    return outline;
}

}  // namespace

Result<FieldShape> FieldShape::of(const FieldSource& source, const DrawnLines& lines,
                                  const FieldShape* before) {
    Result<LocalFrame> frame =
        before != nullptr ? before->frame : LocalFrame::centredOn(middleOf(source.parts));
    if (!frame) {
        return std::unexpected(frame.error());
    }
    FieldShape shape{.frame = *frame, .outlines = {}, .gates = {}};
    const auto add = [&](OutlineId id, bool closed, const GeoRing& places) {
        shape.outlines.push_back(outlineOf(id, closed, places, *frame, before));
    };
    for (std::size_t part = 0; part < source.parts.size(); ++part) {
        add({OutlineKind::Boundary, part, 0}, true, source.parts[part].outer);
        for (std::size_t hole = 0; hole < source.parts[part].holes.size(); ++hole) {
            add({OutlineKind::Hole, part, hole}, true, source.parts[part].holes[hole]);
        }
    }
    for (std::size_t i = 0; i < source.obstacles.size(); ++i) {
        add({OutlineKind::Obstacle, i, 0}, true, source.obstacles[i].outline.outer);
    }
    if (!lines.guide.empty()) {
        add({OutlineKind::Guide, 0, 0}, false, lines.guide);
    }
    for (std::size_t i = 0; i < lines.splits.size(); ++i) {
        add({OutlineKind::Split, i, 0}, false, lines.splits[i]);
    }
    for (const Gate& gate : source.gates) {
        shape.gates.push_back(frame->toLocal(gate.position));
    }
    return shape;
}

const Outline* FieldShape::find(const OutlineId& id) const {
    const auto found = std::ranges::find(outlines, id, &Outline::id);
    return found == outlines.end() ? nullptr : &*found;
}

namespace {

/// Widths of edges stay with their edges when points are added or removed. Both halves of a divided edge keep
/// its width.
void renumber(std::vector<EdgeWidth>& widths, std::size_t part, std::size_t ring, const GeoRing& before,
              const GeoRing& after) {
    if (before.size() == after.size()) {
        return;
    }
    const auto same = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
    const bool grows = after.size() > before.size();
    const std::size_t by = grows ? after.size() - before.size() : before.size() - after.size();
    std::vector<EdgeWidth> kept;
    for (EdgeWidth width : widths) {
        const bool isOther = width.part != part || width.ring != ring || width.edge + 1 < same;
        const std::size_t edge = width.edge;
        if (isOther) {
            kept.push_back(width);
        } else if (grows) {
            // The edge before the first new point was divided.
            for (std::size_t i = edge + 1 == same ? edge : edge + by; i <= edge + by; ++i) {
                width.edge = i;
                kept.push_back(width);
            }
        } else if (edge < same || edge >= same + by) {
            width.edge = edge < same ? edge : edge - by;
            kept.push_back(width);
        }
    }
    widths = std::move(kept);
}

/// The same for all that edges may have.
void renumber(FieldSource& source, std::size_t part, std::size_t ring, const GeoRing& before,
              const GeoRing& after) {
    for (const EdgeWidths widths : {&FieldSource::edgeHeadlands, &FieldSource::edgeOverhangs}) {
        renumber(source.*widths, part, ring, before, after);
    }
}

/// The number of its ring: 0 for the outer one.
std::size_t ringOf(const OutlineId& id) {
    return id.kind == OutlineKind::Hole ? id.hole + 1 : 0;
}

}  // namespace

const EdgeWidth* findEdgeWidth(const FieldSource& source, EdgeWidths widths, const OutlineId& id,
                               std::size_t edge) {
    if (id.kind != OutlineKind::Boundary && id.kind != OutlineKind::Hole) {
        return nullptr;
    }
    const std::vector<EdgeWidth>& all = source.*widths;
    const auto found = std::ranges::find_if(all, [&](const EdgeWidth& own) {
        return own.part == id.item && own.ring == ringOf(id) && own.edge == edge;
    });
    return found == all.end() ? nullptr : &*found;
}

FieldSource withEdgeWidth(FieldSource source, EdgeWidths widths, const OutlineId& id, std::size_t edge,
                          std::optional<Length> width) {
    std::vector<EdgeWidth>& all = source.*widths;
    if (const EdgeWidth* own = findEdgeWidth(source, widths, id, edge)) {
        all.erase(all.begin() + (own - all.data()));
    }
    if (width && (id.kind == OutlineKind::Boundary || id.kind == OutlineKind::Hole)) {
        all.push_back({.part = id.item, .ring = ringOf(id), .edge = edge, .width = *width});
    }
    return source;
}

FieldSource withOutline(FieldSource source, const OutlineId& id, GeoRing places) {
    switch (id.kind) {
        case OutlineKind::Boundary:
            if (id.item < source.parts.size()) {
                renumber(source, id.item, ringOf(id), source.parts[id.item].outer, places);
                source.parts[id.item].outer = std::move(places);
            }
            break;
        case OutlineKind::Hole:
            if (id.item < source.parts.size() && id.hole < source.parts[id.item].holes.size()) {
                GeoRing& hole = source.parts[id.item].holes[id.hole];
                renumber(source, id.item, ringOf(id), hole, places);
                hole = std::move(places);
            }
            break;
        case OutlineKind::Obstacle:
            if (id.item < source.obstacles.size()) {
                source.obstacles[id.item].outline.outer = std::move(places);
            }
            break;
        case OutlineKind::Guide:
        case OutlineKind::Split: break;
    }
    return source;
}

}  // namespace furrow
