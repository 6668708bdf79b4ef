#include "planner/decomposition/decomposition.h"

#include "planner/decomposition/history.h"
#include "planner/decomposition/joining.h"
#include "planner/decomposition/ledges.h"
#include "planner/geometry/box_tree.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace furrow {

namespace {

// Distance above or below a ledge at which its surroundings are tested.
constexpr double kProbeM = 1e-6;
// Edges shorter than this, or than half a width, belong to a bend. Arcs of up to 100 m are drawn in such
// edges.
constexpr Length kBend = metres(3.0);
// Cuts reach this far across the edges at their ends, so that the edges are cut through.
constexpr double kAcrossM = 1e-4;
// Largest distance on the next line of an edge that leaves a corner almost along the heading.
constexpr double kBesideM = 1e-3;

/// A frame in which the swaths are level.
class LevelFrame {
public:
    explicit LevelFrame(Angle heading) : along_{direction(heading.si())} {}

    Point to(Point point) const { return {dot(along_, point), cross(along_, point)}; }
    Point from(Point point) const { return point.x * along_ + point.y * Point{-along_.y, along_.x}; }

    MultiPolygon to(const MultiPolygon& polygons) const {
        MultiPolygon turned = polygons;
        const auto turn = [this](Ring& ring) {
            std::ranges::transform(ring, ring.begin(), [this](Point p) { return to(p); });
        };
        for (Polygon& polygon : turned) {
            turn(polygon.outer);
            std::ranges::for_each(polygon.holes, turn);
        }
        return turned;
    }
    MultiPolygon from(MultiPolygon polygons) const {
        const auto turn = [this](Ring& ring) {
            std::ranges::transform(ring, ring.begin(), [this](Point p) { return from(p); });
        };
        for (Polygon& polygon : polygons) {
            turn(polygon.outer);
            std::ranges::for_each(polygon.holes, turn);
        }
        return polygons;
    }

private:
    Point along_;
};

/// The edges of a mainland, for the crossings of level lines.
class EdgesByHeight {
public:
    explicit EdgesByHeight(const MultiPolygon& mainland) {
        std::vector<Bounds> boxes;
        forEachEdge(mainland, [&](Point a, Point b) {
            edges_.emplace_back(a, b);
            boxes.push_back(bounds(a, b));
        });
        tree_ = BoxTree{boxes};
    }

    std::vector<double> crossings(double y) const {
        std::vector<double> found;
        tree_.any([y](const Bounds& box) { return box.min.y <= y && y <= box.max.y; },
                  [&](std::size_t i) {
                      const auto& [a, b] = edges_[i];
                      if ((a.y > y) != (b.y > y)) {
                          found.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
                      }
                      return false;
                  });
        return found;
    }

private:
    std::vector<std::pair<Point, Point>> edges_;
    BoxTree tree_;
};

/// Adds cuts from a ledge to the nearest edges on its left and right, on the side where the mainland is open:
/// above it, or below if `side` is -1.
void addCuts(const EdgesByHeight& mainland, const Ledge& ledge, double side, std::vector<Polyline>& cuts) {
    const double probe = 0.5 * (ledge.left.y + ledge.right.y) + side * kProbeM;
    std::vector<double> crossings = mainland.crossings(probe);
    std::ranges::sort(crossings);
    for (std::size_t i = 1; i < crossings.size(); i += 2) {
        const double left = crossings[i - 1];
        const double right = crossings[i];
        // The stretch of mainland that contains the ledge, or ends at it.
        if (left > ledge.left.x + kBesideM || right < ledge.right.x - kBesideM) {
            continue;
        }
        if (ledge.left.x - left > kBesideM) {
            cuts.push_back({{left - kAcrossM, ledge.left.y}, ledge.left});
        }
        if (right - ledge.right.x > kBesideM) {
            cuts.push_back({ledge.right, {right + kAcrossM, ledge.right.y}});
        }
    }
}

/// @param bend  shorter edges belong to one corner
std::vector<Polyline> cutsOf(const MultiPolygon& mainland, bool atEveryCorner, Length bend,
                             const JobContext& job) {
    const EdgesByHeight edges{mainland};
    std::vector<Polyline> cuts;
    const auto visit = [&](const Ring& ring) {
        for (const Ledge& ledge : ledgesOf(ring, bend)) {
            if (job.stopRequested()) {
                return;
            }
            if (ledge.isInward && (ledge.isValley || ledge.isPeak)) {
                // Below a valley that points inwards, for example the lower end of an obstacle, and above a
                // peak.
                addCuts(edges, ledge, ledge.isValley ? -1.0 : 1.0, cuts);
            } else if (atEveryCorner && ledge.isCorner) {
                addCuts(edges, ledge, 1.0, cuts);
                addCuts(edges, ledge, -1.0, cuts);
            }
        }
    };
    for (const Polygon& polygon : mainland) {
        visit(polygon.outer);
        std::ranges::for_each(polygon.holes, visit);
    }
    return cuts;
}

double distanceTo(const Polygon& polygon, Point point) {
    double nearest = std::numeric_limits<double>::infinity();
    forEachEdge({polygon},
                [&](Point a, Point b) { nearest = std::min(nearest, distanceToSegment(point, a, b)); });
    return nearest;
}

/// Level cells, lowest first.
struct LevelCells {
    MultiPolygon cells;
    std::vector<Polyline> cuts;
};

Result<LevelCells> levelCells(const MultiPolygon& mainland, bool atEveryCorner, Length bend,
                              const JobContext& job) {
    LevelCells level{.cells = {}, .cuts = cutsOf(mainland, atEveryCorner, bend, job)};
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (level.cuts.empty()) {
        level.cells = mainland;
    } else {
        auto cells = cutAlong(mainland, level.cuts, job);
        if (!cells) {
            return std::unexpected(cells.error());
        }
        level.cells = std::move(*cells);
    }
    std::ranges::sort(level.cells, {}, [](const Polygon& cell) {
        const Bounds box = bounds(cell);
        return std::tuple{box.min.y, box.min.x};
    });
    return level;
}

/// The cell in which a place lies; on an edge, or outside, the nearest cell.
std::size_t homeOf(Point place, const MultiPolygon& cells, const std::vector<Bounds>& boxes) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (distanceM(place, boxes[i]) == 0.0 && isInside(cells[i], place)) {
            return i;
        }
    }
    std::size_t nearest = 0;
    double leastM = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (distanceM(place, boxes[i]) < leastM) {
            if (const double awayM = distanceTo(cells[i], place); awayM < leastM) {
                leastM = awayM;
                nearest = i;
            }
        }
    }
    return nearest;
}

/// The cell of the middle of each swath. Cancelled.
Result<std::vector<std::size_t>> homesOf(const SwathSet& swaths, const LevelFrame& frame,
                                         const MultiPolygon& cells, const JobContext& job) {
    std::vector<Bounds> boxes;
    for (const Polygon& cell : cells) {
        boxes.push_back(bounds(cell));
    }
    std::vector<std::size_t> homes;
    for (const Swath& swath : swaths.swaths) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        homes.push_back(homeOf(frame.to(0.5 * (swath.start + swath.end)), cells, boxes));
    }
    return homes;
}

Result<Decomposition> onePiece(const DecompositionTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    Decomposition whole{
        .cells = {{.outline = task.mainland, .swaths = {}}},
        .altitude = metres(bounds(LevelFrame{task.swaths.heading}.to(task.mainland)).height())};
    whole.cells.front().swaths.resize(task.swaths.swaths.size());
    std::iota(whole.cells.front().swaths.begin(), whole.cells.front().swaths.end(), std::size_t{0});
    return whole;
}

/// The figures of the cells in one state.
DecompositionStep stepOf(const MultiPolygon& levelPieces, const Groups& groups, const CellCost& cost) {
    DecompositionStep step{.joins = {}, .cells = 0, .altitude = {}, .cost = cost.of(groups)};
    std::vector<std::optional<Bounds>> boxes(levelPieces.size());
    for (std::size_t piece = 0; piece < levelPieces.size(); ++piece) {
        const Bounds box = bounds(levelPieces[piece]);
        std::optional<Bounds>& cell = boxes[groups[piece]];
        if (!cell) {
            ++step.cells;
            cell = box;
        }
        cell->min.y = std::min(cell->min.y, box.min.y);
        cell->max.y = std::max(cell->max.y, box.max.y);
    }
    for (const std::optional<Bounds>& cell : boxes) {
        step.altitude += metres(cell ? cell->height() : 0.0);
    }
    return step;
}

/// The steps: first the cut pieces, then one for every join of two driven cells, and one for the other joins
/// between two of these.
std::vector<DecompositionStep> stepsOf(const MultiPolygon& levelPieces, const std::vector<Join>& joins,
                                       const CellCost& cost) {
    Groups groups(levelPieces.size());
    std::iota(groups.begin(), groups.end(), std::size_t{0});
    std::vector<bool> isDriven(levelPieces.size());
    for (std::size_t piece = 0; piece < isDriven.size(); ++piece) {
        isDriven[piece] = !cost.isEmpty(piece);
    }
    std::vector<DecompositionStep> steps{stepOf(levelPieces, groups, cost)};
    std::vector<Join> pending;
    for (std::size_t i = 0; i < joins.size(); ++i) {
        const auto counts = [&](const Join& join) { return isDriven[join.kept] && isDriven[join.gone]; };
        const bool alone = counts(joins[i]);
        pending.push_back(joins[i]);
        apply(joins[i], groups);
        isDriven[joins[i].kept] = isDriven[joins[i].kept] || isDriven[joins[i].gone];
        if (alone || i + 1 == joins.size() || counts(joins[i + 1])) {
            steps.push_back(stepOf(levelPieces, groups, cost));
            steps.back().joins = std::exchange(pending, {});
        }
    }
    return steps;
}

Result<Decomposition> decomposed(const DecompositionTask& task, bool atEveryCorner, bool merge,
                                 const JobContext& job) {
    if (task.swaths.isCurved()) {
        return onePiece(task, job);
    }
    const LevelFrame frame{task.swaths.heading};
    const auto level = levelCells(frame.to(task.mainland), atEveryCorner,
                                  std::max(kBend, 0.5 * task.machine.operatingWidth()), job);
    if (!level) {
        return std::unexpected(level.error());
    }
    const MultiPolygon& pieces = level->cells;
    std::vector<std::vector<std::size_t>> dealt(pieces.size());
    const auto homes = homesOf(task.swaths, frame, pieces, job);
    if (!homes) {
        return std::unexpected(homes.error());
    }
    for (std::size_t swath = 0; swath < homes->size(); ++swath) {
        dealt[(*homes)[swath]].push_back(swath);
    }
    const CellCost cost{task.swaths, task.machine, dealt};
    const auto joins =
        merge ? joinsWhereQuicker(bordersOf(pieces), cost, pieces.size(), job) : std::vector<Join>{};
    if (!joins) {
        return std::unexpected(joins.error());
    }
    Decomposition result;
    result.history = {.pieces = frame.from(pieces), .steps = stepsOf(pieces, *joins, cost)};
    result.altitude = result.history.steps.back().altitude;
    const Groups groups = cellsAt(result.history, result.history.steps.size() - 1);
    auto outlines = outlinesOf(pieces, groups, job);
    if (!outlines) {
        return std::unexpected(outlines.error());
    }
    std::vector<std::size_t> cellOf(pieces.size());
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        if (groups[piece] == piece) {
            cellOf[piece] = result.cells.size();
            result.cells.push_back(
                {.outline = frame.from(std::move((*outlines)[result.cells.size()])), .swaths = {}});
        }
        std::vector<std::size_t>& swaths = result.cells[cellOf[groups[piece]]].swaths;
        swaths.insert(swaths.end(), dealt[piece].begin(), dealt[piece].end());
    }
    for (Cell& cell : result.cells) {
        std::ranges::sort(cell.swaths);
    }
    return result;
}

constexpr Choice kHeadings[] = {
    {"common", "One for all", "Swaths go on from block to block."},
    {"per-cell", "Each its own", "A block gets a heading of its own where that saves time."},
};

}  // namespace

const Parameter kSplit{
    .key = "decomposition.split",
    .name = "Split lines",
    .description =
        "Lines along which the field inside the headland is cut; they run right through it, or end no farther than an operating width "
        "from its edge.",
    .kind = ParameterKind::Lines,
    .standard = {},
    .choices = {}};

bool hasHeadingPerCell(const Settings& settings) {
    return settings.choice(kCellHeading) == "per-cell";
}

const Parameter kCellHeading{.key = "decomposition.heading",
                             .name = "Heading",
                             .description = "Whether blocks have a heading of their own.",
                             .kind = ParameterKind::Choice,
                             .standard = 0.0,
                             .choices = kHeadings};

const Method<Decomposer> kOnePieceMethod{
    .info = {.id = "none",
             .name = "One piece",
             .description = "Swath after swath over all of the field, whatever cuts them.",
             .parameters = {}},
    .run = onePiece};

const Method<Decomposer> kTrapezoidalMethod{
    .info = {.id = "trapezoidal",
             .name = "Trapezoids",
             .description = "Cut along the swaths at every corner, sharp or rounded.",
             .parameters = {}},
    .run = [](const DecompositionTask& task, const JobContext& job) {
        return decomposed(task, true, false, job);
    }};

const Method<Decomposer> kBoustrophedonCellsMethod{
    .info = {.id = "boustrophedon",
             .name = "At obstacles",
             .description = "Cut along the swaths where an obstacle or a bay begins or ends.",
             .parameters = {}},
    .run = [](const DecompositionTask& task, const JobContext& job) {
        return decomposed(task, false, false, job);
    }};

const Method<Decomposer> kMergedCellsMethod{
    .info =
        {.id = "merged",
         .name = "Joined where that is quicker",
         .description =
             "Cut where an obstacle or a bay begins or ends, and joined again where that saves turns and ways.",
         .parameters = {}},
    .run = [](const DecompositionTask& task,
              const JobContext& job) { return decomposed(task, false, true, job); },
    .traits = {.joinsCells = true}};

}  // namespace furrow
