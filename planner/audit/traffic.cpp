#include "planner/audit/traffic.h"

#include "planner/audit/convex.h"
#include "planner/audit/length.h"
#include "planner/audit/slotted_items.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace furrow {

namespace {

constexpr double kSquareM = 1.0;
constexpr double kMostSquares = 1e6;
constexpr double kMostCellsAcross = 500.0;
/// A wheel is followed at most 1000 squares outside its grid.
constexpr double kMostBeyond = 1000.0;
/// From the tractor's side to the middle of its wheels.
constexpr double kWheelInsetM = 0.25;

/// Pieces of lanes in square cells, whose rows lie in the main direction of the lanes.
class LaneIndex {
public:
    LaneIndex(const std::vector<SweptPiece>& pieces, Point along, double cellM)
        : pieces_{pieces}, along_{along}, cellM_{std::max(cellM, 0.1)} {
        Bounds all = kNothing;
        for (const SweptPiece& piece : pieces) {
            const Bounds box = boxOf(piece.ring);
            boxes_.push_back(box);
            all = joined(all, box);
        }
        if (pieces.empty()) {
            return;
        }
        // Limits the number of cells if a lane leads far away.
        cellM_ = std::max(cellM_, std::max(all.width(), all.height()) / kMostCellsAcross);
        corner_ = all.min;
        columns_ = placeOf(all.max.x - corner_.x) + 1;
        rows_ = placeOf(all.max.y - corner_.y) + 1;
        inCells_ = SlottedItems{columns_ * rows_, [&](const auto& take) {
                                    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
                                        forEachCell(boxes_[i], [&](std::size_t cell) { take(cell, i); });
                                    }
                                }};
    }

    /// Calls `visit(piece)` for every piece whose box meets that of the edge, for some more than once.
    template <class Visit>
    void visitNear(const Edge& edge, Visit&& visit) const {
        const Bounds box = boxOf({edge.from, edge.to});
        forEachCell(box, [&](std::size_t cell) {
            for (const std::uint32_t i : inCells_.in(cell)) {
                const Bounds& lane = boxes_[i];
                if (lane.min.x < box.max.x && box.min.x < lane.max.x && lane.min.y < box.max.y &&
                    box.min.y < lane.max.y) {
                    visit(pieces_[i]);
                }
            }
        });
    }

private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();
    static constexpr Bounds kNothing{.min = {kFar, kFar}, .max = {-kFar, -kFar}};

    Bounds boxOf(const Ring& ring) const {
        Bounds box = kNothing;
        for (const Point& point : ring) {
            const Point at{dot(point, along_), cross(along_, point)};
            box = joined(box, {at, at});
        }
        return box;
    }
    std::size_t placeOf(double away) const { return static_cast<std::size_t>(std::max(0.0, away / cellM_)); }

    template <class Visit>
    void forEachCell(const Bounds& box, const Visit& visit) const {
        if (box.max.x < corner_.x || box.max.y < corner_.y) {
            return;
        }
        const std::size_t right = placeOf(box.max.x - corner_.x);
        const std::size_t top = placeOf(box.max.y - corner_.y);
        for (std::size_t row = placeOf(box.min.y - corner_.y); row <= top && row < rows_; ++row) {
            for (std::size_t column = placeOf(box.min.x - corner_.x); column <= right && column < columns_;
                 ++column) {
                visit(row * columns_ + column);
            }
        }
    }

    const std::vector<SweptPiece>& pieces_;
    Point along_;
    double cellM_;
    Point corner_;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<Bounds> boxes_;
    SlottedItems inCells_;  ///< pieces
};

/// Parts of one step, from 0 to 1.
using Parts = std::vector<std::pair<double, double>>;

double lengthOf(Parts& parts) {
    std::ranges::sort(parts);
    double sum = 0.0;
    double end = 0.0;
    for (const auto& [from, to] : parts) {
        sum += std::max(0.0, to - std::max(from, end));
        end = std::max(end, to);
    }
    return sum;
}

class CrossedLanes {
public:
    CrossedLanes(const AuditInput& input, const std::vector<SegmentMotion>& motions, const LaneIndex& lanes)
        : input_{input}, motions_{motions}, lanes_{lanes} {}

    /// Adds a segment with the implement up, between two lanes.
    void follow(std::size_t segment, Traffic& traffic) {
        const std::size_t before = neighbour(segment, -1);
        const std::size_t after = neighbour(segment, 1);
        const std::vector<MotionState>& states = motions_[segment].states;
        double crossed = 0.0;
        Point place;
        for (std::size_t k = 1; k < states.size(); ++k) {
            const Edge step{states[k - 1].position, states[k].position};
            worked_.clear();
            any_.clear();
            lanes_.visitNear(step, [&](const SweptPiece& piece) {
                if (piece.segment == before || piece.segment == after) {
                    return;
                }
                if (const auto part = partInside(piece.ring, step)) {
                    any_.push_back(*part);
                    if (piece.segment < segment) {
                        worked_.push_back(*part);
                    }
                }
            });
            if (any_.empty()) {
                continue;
            }
            const double way = lengthOf(step.to - step.from);
            const double onAny = way * lengthOf(any_);
            const double onWorked = way * lengthOf(worked_);
            traffic.onWorkedM += onWorked;
            traffic.onUnworkedM += onAny - onWorked;
            place = crossed == 0.0 ? step.from : place;
            crossed += onAny;
        }
        if (crossed > traffic.longestM) {
            traffic.longestM = crossed;
            traffic.longestPlace = place;
            traffic.longestSegment = segment;
        }
    }

private:
    /// The nearest segment before or after it with the implement down.
    std::size_t neighbour(std::size_t segment, int step) const {
        auto at = static_cast<std::ptrdiff_t>(segment) + step;
        const auto count = std::ssize(input_.segments);
        while (at >= 0 && at < count && !input_.segments[static_cast<std::size_t>(at)].implementDown) {
            at += step;
        }
        return static_cast<std::size_t>(at);
    }

    const AuditInput& input_;
    const std::vector<SegmentMotion>& motions_;
    const LaneIndex& lanes_;
    Parts worked_;
    Parts any_;
};

/// Squares over the field, each with its number of wheel passages.
class WheelGrid {
public:
    explicit WheelGrid(const Bounds& box) : corner_{box.min} {
        const double areaM2 = std::max(box.width(), 1.0) * std::max(box.height(), 1.0);
        sizeM_ = std::max(kSquareM, std::ceil(std::sqrt(areaM2 / kMostSquares)));
        columns_ = static_cast<std::ptrdiff_t>(box.width() / sizeM_) + 1;
        rows_ = static_cast<std::ptrdiff_t>(box.height() / sizeM_) + 1;
        squares_.resize(static_cast<std::size_t>(columns_ * rows_));
    }

    double size() const { return sizeM_; }

    /// Rolls a wheel from one point to another. `wayM` is the distance that the machine has driven.
    void roll(Point from, Point to, double wayM) {
        const double lengthM = lengthOf(to - from);
        Point a = (1.0 / sizeM_) * (from - corner_);
        Point b = (1.0 / sizeM_) * (to - corner_);
        if (!isNear(a) || !isNear(b)) {
            const auto part = partInside(nearby(), {a, b});
            if (!part) {
                return;
            }
            const Point way = b - a;
            b = a + part->second * way;
            a = a + part->first * way;
            wayM += part->first * lengthM;
        }
        auto column = static_cast<std::ptrdiff_t>(std::floor(a.x));
        auto row = static_cast<std::ptrdiff_t>(std::floor(a.y));
        const auto lastColumn = static_cast<std::ptrdiff_t>(std::floor(b.x));
        const auto lastRow = static_cast<std::ptrdiff_t>(std::floor(b.y));
        const std::ptrdiff_t stepColumn = b.x > a.x ? 1 : -1;
        const std::ptrdiff_t stepRow = b.y > a.y ? 1 : -1;
        const Point perCell{1.0 / std::max(std::abs(b.x - a.x), 1e-12),
                            1.0 / std::max(std::abs(b.y - a.y), 1e-12)};
        // Shares of the way at which the next column and the next row begin.
        Point next{perCell.x * std::abs(static_cast<double>(column + (stepColumn > 0 ? 1 : 0)) - a.x),
                   perCell.y * std::abs(static_cast<double>(row + (stepRow > 0 ? 1 : 0)) - a.y)};
        const double partM = sizeM_ * lengthOf(b - a);
        std::ptrdiff_t left = std::abs(lastColumn - column) + std::abs(lastRow - row);
        double share = 0.0;
        for (;;) {
            visit(column, row, wayM + share * partM);
            if (left-- == 0) {
                return;
            }
            if (next.x < next.y) {
                share = next.x;
                column += stepColumn;
                next.x += perCell.x;
            } else {
                share = next.y;
                row += stepRow;
                next.y += perCell.y;
            }
        }
    }

    int most() const { return most_; }
    std::vector<Bounds> oftenRuns() const {
        std::vector<std::ptrdiff_t> squares = often_;
        std::ranges::sort(squares);
        std::vector<Bounds> runs;
        for (std::size_t i = 0; i < squares.size();) {
            const std::ptrdiff_t first = squares[i];
            const std::ptrdiff_t row = first / columns_;
            std::ptrdiff_t end = first;
            for (; i < squares.size() && squares[i] == end && end / columns_ == row; ++i) {
                ++end;
            }
            const Point low{static_cast<double>(first % columns_), static_cast<double>(row)};
            const Point high = low + Point{static_cast<double>(end - first), 1.0};
            runs.push_back({.min = corner_ + sizeM_ * low, .max = corner_ + sizeM_ * high});
        }
        return runs;
    }
    double areaOften() const { return sizeM_ * sizeM_ * static_cast<double>(often_.size()); }

private:
    struct Square {
        int passes = 0;
        float wayM = -std::numeric_limits<float>::infinity();  ///< at the last visit
    };

    bool isNear(Point square) const {
        return square.x > -kMostBeyond && square.y > -kMostBeyond &&
               square.x < static_cast<double>(columns_) + kMostBeyond &&
               square.y < static_cast<double>(rows_) + kMostBeyond;
    }
    Ring nearby() const {
        const Point high{static_cast<double>(columns_) + kMostBeyond,
                         static_cast<double>(rows_) + kMostBeyond};
        return {{-kMostBeyond, -kMostBeyond}, {high.x, -kMostBeyond}, high, {-kMostBeyond, high.y}};
    }

    void visit(std::ptrdiff_t column, std::ptrdiff_t row, double wayM) {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) {
            return;
        }
        const std::ptrdiff_t at = row * columns_ + column;
        Square& square = squares_[static_cast<std::size_t>(at)];
        // The other wheel, or the same one still there, is not another passage.
        if (wayM - square.wayM > 3.0 * sizeM_) {
            most_ = std::max(most_, ++square.passes);
            if (square.passes == kOftenPasses + 1) {
                often_.push_back(at);
            }
        }
        square.wayM = static_cast<float>(wayM);
    }

    Point corner_;
    double sizeM_ = kSquareM;
    std::ptrdiff_t columns_ = 1;
    std::ptrdiff_t rows_ = 1;
    std::vector<Square> squares_;
    int most_ = 0;                       ///< passages of a square
    std::vector<std::ptrdiff_t> often_;  ///< squares with more than kOftenPasses, as they came to it
};

double rollWheels(const SegmentMotion& motion, double asideM, double wayM, WheelGrid& grid) {
    for (std::size_t k = 1; k < motion.states.size(); ++k) {
        const MotionState& a = motion.states[k - 1];
        const MotionState& b = motion.states[k];
        const Point left{-a.nose.y, a.nose.x};
        const Point leftNext{-b.nose.y, b.nose.x};
        for (const double aside : {asideM, -asideM}) {
            grid.roll(a.position + aside * left, b.position + aside * leftNext, wayM);
        }
        wayM += lengthOf(b.position - a.position);
    }
    return wayM;
}

}  // namespace

Result<Traffic> measureTraffic(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                               const std::vector<SweptPiece>& pieces, Point along, const JobContext& job) {
    Traffic traffic;
    const LaneIndex lanes{pieces, along, input.passes.empty() ? 3.0 : input.passes.front().width.si()};
    CrossedLanes crossed{input, motions, lanes};
    WheelGrid grid{bounds(input.workable)};
    const double asideM =
        input.machine ? std::max(0.0, 0.5 * input.machine->spec().tractor.width.si() - kWheelInsetM) : 0.0;
    double wayM = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (!input.segments[i].implementDown) {
            crossed.follow(i, traffic);
        }
        wayM = rollWheels(motions[i], asideM, wayM, grid);
    }
    traffic.mostWheelPasses = grid.most();
    traffic.oftenDriven = grid.areaOften() / std::max(area(input.workable).si(), 1e-9);
    traffic.oftenSquares = grid.oftenRuns();
    traffic.squareM = grid.size();
    return traffic;
}

}  // namespace furrow
