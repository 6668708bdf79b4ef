#include "ui/map/plan_scene.h"

#include <QLineF>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

namespace furrow {

namespace {

/// Arrows at most, so that a zoomed-out plan stays readable and quick.
constexpr std::size_t kMostArrows = 400;
constexpr std::size_t kMostPills = 120;
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
        case PathKind::Undrivable: break;
    }
    return style.showTurns;
}

float lengthOf(const DirectionMark& mark) {
    return std::hypot(mark.to.x - mark.from.x, mark.to.y - mark.from.y);
}

/// Those in view that have room beside the ones before them and the selected one, the last first.
std::vector<int> shownFindings(const std::vector<MapPoint>& findings, const PlanView& view, int selected) {
    constexpr double kRoomPx = 22.0;
    std::vector<QPointF> taken;
    if (selected >= 0 && selected < static_cast<int>(findings.size())) {
        taken.push_back(view.toItem(findings[static_cast<std::size_t>(selected)]));
    }
    std::vector<int> shown;
    for (int i = 0; i < static_cast<int>(findings.size()); ++i) {
        const MapPoint place = findings[static_cast<std::size_t>(i)];
        const QPointF pixel = view.toItem(place);
        if (i == selected || !view.visible.contains(QPointF{double{place.x}, double{place.y}}) ||
            std::ranges::any_of(taken,
                                [&](QPointF other) { return QLineF{other, pixel}.length() < kRoomPx; })) {
            continue;
        }
        taken.push_back(pixel);
        shown.push_back(i);
    }
    std::ranges::reverse(shown);
    return shown;
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

QPointF PlanView::toItem(MapPoint place) const {
    return {double{matrix(0, 3)} + double{place.x} * pixelsPerUnit,
            double{matrix(1, 3)} + double{place.y} * pixelsPerUnit};
}

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
    tramlines_ = newLine(transform_);
    transform_->appendChildNode(chunkParent_);
    appendChildNode(directions_);
    startEdge_ = newLine(transform_);
    startFace_ = newLine(transform_);
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
    obstacles_->setMesh(shown.obstacles);
    mainlandEdge_->setMesh(shown.mainlandEdge);
    casing_->setMesh(shown.boundary);
    boundary_->setMesh(shown.boundary);
    obstacleEdges_->setMesh(shown.obstacleEdges);
    swathCasing_->setMesh(shown.swaths);
    swaths_->setMesh(shown.swaths);
    tramlines_->setMesh(shown.tramlines);
    for (const PathChunk& chunk : shown.chunks) {
        auto* node = new LineNode;
        chunkParent_->appendChildNode(node);
        chunks_.push_back({node, &chunk, PathChunk::kLevels});
        styleChunk(chunks_.back());
    }
    LineMesh disc;
    if (shown.start) {
        disc.add(std::span{&*shown.start, 1});
    }
    startEdge_->setMesh(disc);
    startFace_->setMesh(disc);
}

void PlanScene::styleChunk(const ChunkNode& chunk) const {
    chunk.node->setStyle(pathStyle(chunk.chunk->kind, style_, style_.lineFactor * density_));
}

void PlanScene::setStyle(const PlanStyle& style) {
    style_ = style;
    const double factor = style.lineFactor;
    QColor strip = style.headland;
    strip.setAlphaF(0.16F);
    headland_->setStyle(strip);
    QColor worked = style.covered;
    worked.setAlphaF(0.24F);
    covered_->setStyle(worked);
    QColor twice = style.overlap;
    twice.setAlphaF(0.55F);
    overlap_->setStyle(twice);
    missed_->setStyle(style.missed, 5.0);
    wheels_->setStyle(style.wheels, 4.0);
    covered_->setShown(style.showCoverage);
    overlap_->setShown(style.showOverlap);
    missed_->setShown(style.showMissed);
    wheels_->setShown(style.showWheels);
    obstacles_->setStyle(style.obstacle, 7.0);
    mainlandEdge_->setStyle(
        {.color = style.headland, .widthPx = 1.1 * factor, .dashPx = 6.0, .periodPx = 10.0});
    casing_->setStyle({.color = style.casing, .widthPx = 4.6 * factor});
    boundary_->setStyle({.color = style.boundary, .widthPx = 2.4 * factor});
    obstacleEdges_->setStyle({.color = style.obstacle, .widthPx = 1.6 * factor});
    headland_->setShown(style.showHeadland);
    mainlandEdge_->setShown(style.showHeadland);
    casing_->setShown(style.showBoundary);
    boundary_->setShown(style.showBoundary);
    swathCasing_->setShown(style.showSwaths && style.onImagery);
    swaths_->setShown(style.showSwaths);
    tramlines_->setShown(style.showSwaths);
    tramlines_->setStyle({.color = style.ink, .widthPx = 2.6 * factor, .dashPx = 12.0, .periodPx = 18.0});
    directions_->setStyle({.color = style.ink, .widthPx = 1.5 * factor});
    styleDensity();
    startEdge_->setStyle({.color = style.ground, .widthPx = 19.0});
    startFace_->setStyle({.color = style.start, .widthPx = 14.5});
}

void PlanScene::styleDensity() {
    swaths_->setStyle({.color = style_.swath, .widthPx = 1.5 * style_.lineFactor * density_});
    QColor casing = style_.ground;
    casing.setAlphaF(0.75F);
    swathCasing_->setStyle({.color = casing, .widthPx = (1.5 * style_.lineFactor + 1.8) * density_});
    for (const ChunkNode& chunk : chunks_) {
        styleChunk(chunk);
    }
}

void PlanScene::setView(const PlanView& view, QQuickWindow* window) {
    transform_->setMatrix(view.matrix);
    // Swaths a few pixels apart would run into one area at their full width.
    const double spacingPx = geometry_ ? geometry_->swathSpacing * view.pixelsPerUnit : 10.0;
    const double density = std::clamp(spacingPx / 5.0, 0.45, 1.0);
    if (density != density_) {
        density_ = density;
        styleDensity();
    }
    for (FillNode* fill : {covered_, headland_, overlap_, missed_, wheels_, obstacles_}) {
        fill->setScale(view.pixelsPerUnit, view.devicePixelRatio);
    }
    for (LineNode* line : lines_) {
        line->setScale(view.pixelsPerUnit, view.devicePixelRatio);
    }
    showChunks(view);
    showDirections(view);
    showMarks(view, window);
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
        // Every n-th swath, so that neighbours' arrows are apart; never more than one in 200 px of a swath.
        const int every = std::clamp(numberStep(geometry_->numbers, view.pixelsPerUnit * 1.4), 1, 1000);
        std::size_t count = 0;
        for (const DirectionMark& mark : geometry_->directions) {
            const double lengthPx = double{lengthOf(mark)} * view.pixelsPerUnit;
            const bool wanted = mark.onSwath
                                    ? lengthPx > 70.0 && (mark.order - 1) % every == 0
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
                   .end = style_.end},
                  view.devicePixelRatio);
    if (geometry_ && style_.showNumbers) {
        const int step = numberStep(geometry_->numbers, view.pixelsPerUnit);
        std::size_t count = 0;
        for (std::size_t i = 0; i < geometry_->numbers.size() && count < kMostPills;
             i += static_cast<std::size_t>(step)) {
            const NumberMark& mark = geometry_->numbers[i];
            if (view.visible.contains(QPointF{double{mark.place.x}, double{mark.place.y}})) {
                marks_->addPill(mark.number, view.toItem(mark.place));
                ++count;
            }
        }
    }
    if (geometry_ && geometry_->end) {
        marks_->addSquare(view.toItem(*geometry_->end));
    }
    if (geometry_ && style_.showFindings) {
        const int count = static_cast<int>(geometry_->findings.size());
        const auto placeOf = [&](int i) {
            return view.toItem(geometry_->findings[static_cast<std::size_t>(i)]);
        };
        for (const int i : shownFindings(geometry_->findings, view, style_.selectedFinding)) {
            marks_->addDiamond(i + 1, placeOf(i), false);
        }
        if (style_.selectedFinding >= 0 && style_.selectedFinding < count) {
            marks_->addDiamond(style_.selectedFinding + 1, placeOf(style_.selectedFinding), true);
        }
    }
    marks_->end();
}

}  // namespace furrow
