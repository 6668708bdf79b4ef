#include "ui/map/plan_scene.h"

#include "ui/map/finding_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace furrow {

namespace {

/// Arrows at most, so that a zoomed-out plan stays readable and quick.
constexpr std::size_t kMostArrows = 400;
constexpr std::size_t kMostPills = 120;
/// Swaths closer together than this run into a pattern of their own: they become an area.
constexpr double kFillBelowPx = 4.0;
constexpr double kLinesFromPx = 2.2;
/// Turns are drawn with an arrow from this zoom on.
constexpr double kTurnArrowPxPerM = 5.0;

LineStyle pathStyle(PathKind kind, const PlanStyle& style, double factor) {
    switch (kind) {
        case PathKind::Work: return {.color = style.swath, .widthPx = 1.5 * factor};
        case PathKind::HeadlandPass:
            return {.color = style.headland, .widthPx = 1.5 * factor, .dashPx = 6.0, .periodPx = 10.0};
        case PathKind::Turn: return {.color = style.turn, .widthPx = 1.7 * factor};
        case PathKind::Transfer:
            return {.color = style.turn, .widthPx = 1.7 * factor, .dashPx = 14.0, .periodPx = 20.0};
        case PathKind::Reverse:
            return {.color = style.turn, .widthPx = 2.6 * factor, .dashPx = 2.6, .periodPx = 6.5};
        case PathKind::Undrivable: break;
    }
    return {.color = style.finding, .widthPx = 2.2 * factor, .dashPx = 4.0, .periodPx = 7.0};
}

bool isShown(PathKind kind, const PlanStyle& style) {
    switch (kind) {
        case PathKind::Work: return false;  // lies on the swaths
        case PathKind::HeadlandPass: return style.showHeadland;
        case PathKind::Turn:
        case PathKind::Transfer:
        case PathKind::Reverse:
        case PathKind::Undrivable: break;
    }
    return style.showTurns;
}

float lengthOf(const DirectionMark& mark) {
    return std::hypot(mark.to.x - mark.from.x, mark.to.y - mark.from.y);
}

QColor faded(QColor color, double share) {
    color.setAlphaF(static_cast<float>(color.alphaF() * share));
    return color;
}

FindingShape shapeOf(Weight weight) {
    return weight == Weight::Blocks ? FindingShape::Full
           : weight == Weight::Look ? FindingShape::Outline
                                    : FindingShape::Disc;
}

void addArrow(LineMesh& mesh, QPointF tip, QPointF along) {
    constexpr double kLength = 6.0;
    constexpr double kHalfWidth = 3.6;
    const QPointF back = tip - along * kLength;
    const QPointF across{-along.y(), along.x()};
    const auto point = [](QPointF p) {
        return MapPoint{static_cast<float>(p.x()), static_cast<float>(p.y())};
    };
    mesh.add(std::array{point(back + across * kHalfWidth), point(tip), point(back - across * kHalfWidth)});
}

}  // namespace

int numberStep(const std::vector<NumberMark>& numbers, double pixelsPerUnit) {
    constexpr double kCellPx = 30.0;
    for (const int step : {1, 2, 4, 5, 10, 20, 50, 100, 200, 500}) {
        std::unordered_set<std::int64_t> taken;
        bool clear = true;
        for (std::size_t i = 0; i < numbers.size() && clear; i += static_cast<std::size_t>(step)) {
            const auto column =
                static_cast<std::int64_t>(std::floor(double{numbers[i].place.x} * pixelsPerUnit / kCellPx));
            const auto row =
                static_cast<std::int64_t>(std::floor(double{numbers[i].place.y} * pixelsPerUnit / kCellPx));
            // Neighbouring cells too, but for the corners: two numbers are then a cell apart.
            for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                clear = clear && !taken.contains((column + dx) * 4000037 + row + dy);
            }
            taken.insert(column * 4000037 + row);
        }
        if (clear) {
            return step;
        }
    }
    return 1000;
}

PlanScene::PlanScene() {
    appendChildNode(transform_);
    transform_->appendChildNode(covered_);
    transform_->appendChildNode(headland_);
    transform_->appendChildNode(worked_);
    transform_->appendChildNode(overlap_);
    transform_->appendChildNode(missed_);
    transform_->appendChildNode(wheels_);
    transform_->appendChildNode(obstacles_);
    mainlandEdge_ = newLine(transform_);
    casing_ = newLine(transform_);
    boundary_ = newLine(transform_);
    obstacleEdges_ = newLine(transform_);
    swathCasing_ = newLine(transform_);
    swaths_ = newLine(transform_);
    beyondSwaths_ = newLine(transform_);
    tramlines_ = newLine(transform_);
    transform_->appendChildNode(chunkParent_);
    halo_ = newLine(transform_);
    selection_ = newLine(transform_);
    appendChildNode(directions_);
    appendChildNode(marks_);
}

LineNode* PlanScene::newLine(QSGNode* parent) {
    auto* node = new LineNode;
    parent->appendChildNode(node);
    lines_.push_back(node);
    return node;
}

void PlanScene::setGeometry(std::shared_ptr<const PlanGeometry> geometry) {
    if (geometry == geometry_) {
        return;
    }
    for (const ChunkNode& chunk : chunks_) {
        chunkParent_->removeChildNode(chunk.node);
        delete chunk.node;
    }
    chunks_.clear();
    geometry_ = std::move(geometry);
    static const PlanGeometry none;
    const PlanGeometry& shown = geometry_ ? *geometry_ : none;
    covered_->setMesh(shown.covered);
    overlap_->setMesh(shown.overlap);
    missed_->setMesh(shown.missed);
    wheels_->setMesh(shown.wheels);
    headland_->setMesh(shown.headland);
    worked_->setMesh(shown.mainland);
    obstacles_->setMesh(shown.obstacles);
    mainlandEdge_->setMesh(shown.mainlandEdge);
    casing_->setMesh(shown.boundary);
    boundary_->setMesh(shown.boundary);
    obstacleEdges_->setMesh(shown.obstacleEdges);
    swathCasing_->setMesh(shown.swaths);
    swaths_->setMesh(shown.swaths);
    beyondSwaths_->setMesh(shown.beyondSwaths);
    tramlines_->setMesh(shown.tramlines);
    for (const PathChunk& chunk : shown.chunks) {
        auto* node = new LineNode;
        chunkParent_->appendChildNode(node);
        chunks_.push_back({node, &chunk, PathChunk::kLevels});
        styleChunk(chunks_.back());
    }
    selected_ = {-1, -1};
    halo_->setShown(false);
    selection_->setShown(false);
}

void PlanScene::styleChunk(const ChunkNode& chunk) const {
    LineStyle style = pathStyle(chunk.chunk->kind, style_, style_.lineFactor * density_);
    style.color = faded(style.color, style_.restAlpha());
    chunk.node->setStyle(style);
}

void PlanScene::setStyle(const PlanStyle& style) {
    style_ = style;
    const double factor = style.lineFactor;
    const double rest = style.restAlpha();
    headland_->setStyle(faded(style.headland, 0.16 * rest));
    covered_->setStyle(faded(style.covered, 0.24 * rest));
    overlap_->setStyle(faded(style.overlap, 0.55 * rest));
    missed_->setStyle(style.missed, 5.0);
    wheels_->setStyle(faded(style.wheels, rest), 4.0);
    covered_->setShown(style.showCoverage);
    overlap_->setShown(style.showOverlap);
    missed_->setShown(style.showMissed);
    wheels_->setShown(style.showWheels);
    obstacles_->setStyle(style.obstacle, 7.0);
    mainlandEdge_->setStyle(
        {.color = faded(style.headland, rest), .widthPx = 1.1 * factor, .dashPx = 6.0, .periodPx = 10.0});
    casing_->setStyle({.color = style.casing, .widthPx = 4.6 * factor});
    boundary_->setStyle({.color = style.boundary, .widthPx = 2.4 * factor});
    obstacleEdges_->setStyle({.color = style.obstacle, .widthPx = 1.6 * factor});
    headland_->setShown(style.showHeadland);
    mainlandEdge_->setShown(style.showHeadland);
    casing_->setShown(style.showBoundary);
    boundary_->setShown(style.showBoundary);
    tramlines_->setShown(style.showSwaths);
    tramlines_->setStyle(
        {.color = faded(style.ink, rest), .widthPx = 2.6 * factor, .dashPx = 12.0, .periodPx = 18.0});
    directions_->setStyle({.color = faded(style.ink, rest), .widthPx = 1.5 * factor});
    styleDensity();
}

void PlanScene::styleDensity() {
    const double rest = style_.restAlpha();
    for (LineNode* const lines : {swaths_, beyondSwaths_}) {
        lines->setStyle(
            {.color = faded(style_.swath, rest * asLines_), .widthPx = 1.5 * style_.lineFactor * density_});
        lines->setShown(style_.showSwaths && asLines_ > 0.0);
    }
    swathCasing_->setStyle({.color = faded(style_.ground, 0.75 * rest * asLines_),
                            .widthPx = (1.5 * style_.lineFactor + 1.8) * density_});
    worked_->setStyle(faded(style_.swath, 0.4 * rest * (1.0 - asLines_)));
    worked_->setShown(style_.showSwaths && asLines_ < 1.0);
    swathCasing_->setShown(style_.showSwaths && style_.onImagery && asLines_ > 0.0);
    for (const ChunkNode& chunk : chunks_) {
        styleChunk(chunk);
    }
}

void PlanScene::setView(const PlanView& view, QQuickWindow* window) {
    transform_->setMatrix(view.matrix);
    // Lines a few pixels apart would run into one area at their full width, and into a pattern of their own
    // closer than that: what their distance leaves of the lines, an area takes.
    const double spacingPx = geometry_ ? geometry_->swathSpacing * view.pixelsPerUnit : 10.0;
    const double density = std::clamp(spacingPx / 5.0, 0.45, 1.0);
    const double asLines = std::clamp((spacingPx - kLinesFromPx) / (kFillBelowPx - kLinesFromPx), 0.0, 1.0);
    if (density != density_ || asLines != asLines_) {
        density_ = density;
        asLines_ = asLines;
        styleDensity();
    }
    showSelection();
    for (FillNode* fill : {covered_, headland_, worked_, overlap_, missed_, wheels_, obstacles_}) {
        fill->setScale(view.pixelsPerUnit, view.devicePixelRatio);
    }
    for (LineNode* line : lines_) {
        line->setScale(view.pixelsPerUnit, view.devicePixelRatio);
    }
    showChunks(view);
    showDirections(view);
    showMarks(view, window);
}

LineMesh PlanScene::selectedLines() const {
    LineMesh lines;
    if (!geometry_) {
        return lines;
    }
    const auto segment = static_cast<std::size_t>(style_.selectedSegment);
    const auto cell = static_cast<std::size_t>(style_.selectedCell);
    if (style_.selectedSegment >= 0 && segment < geometry_->segments.size()) {
        lines.add(geometry_->segments[segment].points);
    } else if (style_.selectedCell >= 0 && cell < geometry_->cells.size()) {
        for (const auto& ring : geometry_->cells[cell]) {
            lines.add(ring, true);
        }
    }
    return lines;
}

void PlanScene::showSelection() {
    const std::pair wanted{style_.selectedSegment, style_.selectedCell};
    if (wanted != selected_) {
        selected_ = wanted;
        const LineMesh lines = selectedLines();
        halo_->setMesh(lines);
        selection_->setMesh(lines);
        halo_->setShown(!lines.isEmpty());
        selection_->setShown(!lines.isEmpty());
    }
    const double factor = style_.lineFactor;
    const auto segment = static_cast<std::size_t>(style_.selectedSegment);
    // Of its own kind's colour, whole: dashes of a short piece would hide where it begins.
    const QColor color = geometry_ && segment < geometry_->segments.size()
                             ? pathStyle(geometry_->segments[segment].kind, style_, factor).color
                             : style_.swath;
    halo_->setStyle({.color = style_.ground, .widthPx = 10.0 * factor});
    selection_->setStyle({.color = color, .widthPx = 4.0 * factor});
}

void PlanScene::showChunks(const PlanView& view) {
    const double unitsPerMetre = geometry_ ? geometry_->unitsPerMetre : 1.0;
    // The coarsest level that is off by less than half a pixel.
    std::size_t level = 0;
    double tolerancePx = PathChunk::kToleranceM * unitsPerMetre * view.pixelsPerUnit;
    while (level + 1 < PathChunk::kLevels && tolerancePx < 0.5) {
        ++level;
        tolerancePx *= 4.0;
    }
    for (ChunkNode& chunk : chunks_) {
        const QRectF box = chunk.chunk->box.adjusted(-1.0, -1.0, 1.0, 1.0);
        const bool shown = isShown(chunk.chunk->kind, style_) && box.intersects(view.visible);
        chunk.node->setShown(shown);
        if (shown && chunk.level != level) {
            chunk.node->setMesh(chunk.chunk->levels[level]);
            chunk.level = level;
        }
        chunk.node->setScale(view.pixelsPerUnit, view.devicePixelRatio);
    }
}

void PlanScene::showDirections(const PlanView& view) {
    directions_->setShown(style_.showDirections);
    LineMesh arrows;
    if (style_.showDirections && geometry_) {
        // Every n-th swath, so that neighbours' arrows are apart. An odd n: swaths are mostly driven to and
        // fro, and every second one would show one way only.
        const int every = numberStep(geometry_->numbers, view.pixelsPerUnit * 1.4) | 1;
        std::size_t count = 0;
        for (const DirectionMark& mark : geometry_->directions) {
            const double lengthPx = double{lengthOf(mark)} * view.pixelsPerUnit;
            const bool wanted = mark.onSwath
                                    ? lengthPx > 70.0 && (mark.number - 1) % every == 0
                                    : view.pixelsPerUnit * geometry_->unitsPerMetre > kTurnArrowPxPerM;
            const bool layerShown = mark.onSwath ? style_.showSwaths : style_.showTurns;
            if (!wanted || !layerShown || lengthPx <= 0.0) {
                continue;
            }
            const QPointF from = view.toItem(mark.from);
            const QPointF to = view.toItem(mark.to);
            const QPointF along = (to - from) / lengthPx;
            const int parts = mark.onSwath ? std::clamp(static_cast<int>(lengthPx / 320.0), 1, 6) : 1;
            for (int part = 0; part < parts && count < kMostArrows; ++part) {
                const double share = (part + 0.5) / parts;
                const QPointF tip = from + (to - from) * share + along * 3.0;
                if (QRectF{QPointF{}, view.size}.adjusted(-8, -8, 8, 8).contains(tip)) {
                    addArrow(arrows, tip, along);
                    ++count;
                }
            }
        }
    }
    directions_->setMesh(arrows);
    directions_->setScale(1.0, view.devicePixelRatio);
}

void PlanScene::showMarks(const PlanView& view, QQuickWindow* window) {
    marks_->begin(window,
                  {.pill = style_.ground,
                   .pillText = style_.ink,
                   .pillLine = style_.swath,
                   .finding = style_.finding,
                   .findingText = style_.ground,
                   .start = style_.start,
                   .end = style_.end,
                   .refill = style_.swath},
                  view.devicePixelRatio);
    if (geometry_) {
        addNumbers(view);
        if (style_.showFindings) {
            addFindings(view);
        }
        for (const MapPoint& point : geometry_->refillPoints) {
            marks_->addRefill(view.toItem(point));
        }
        if (geometry_->end) {
            marks_->addEnd(view.toItem(*geometry_->end));
        }
        if (geometry_->start) {
            marks_->addStart(view.toItem(*geometry_->start));
        }
    }
    marks_->end();
}

void PlanScene::addNumbers(const PlanView& view) {
    if (!style_.showNumbers && !style_.showOrder) {
        return;
    }
    const auto step = static_cast<std::size_t>(numberStep(geometry_->numbers, view.pixelsPerUnit));
    std::size_t count = 0;
    for (std::size_t i = 0; i < geometry_->numbers.size() && count < kMostPills; i += step) {
        const NumberMark& mark = geometry_->numbers[i];
        if (style_.showNumbers && view.shows(mark.place)) {
            marks_->addPill(mark.number, view.toItem(mark.place));
            ++count;
        }
        if (style_.showOrder && view.shows(mark.begin)) {
            marks_->addOrder(mark.order, view.toItem(mark.begin));
            ++count;
        }
    }
}

void PlanScene::addFindings(const PlanView& view) {
    const auto add = [this](const FindingMark& mark, bool selected) {
        const Weight weight = geometry_->findings[static_cast<std::size_t>(mark.finding)].weight;
        marks_->addFinding(mark.finding + 1, mark.more, shapeOf(weight), mark.middle, selected);
    };
    const std::vector<FindingMark> marks = findingMarks(*geometry_, view, style_.selectedFinding);
    // The first ones last: they lie over the others, the selected one over all.
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
        if (mark->finding != style_.selectedFinding) {
            add(*mark, false);
        }
    }
    for (const FindingMark& mark : marks) {
        if (mark.finding == style_.selectedFinding) {
            add(mark, true);
        }
    }
}

}  // namespace furrow
