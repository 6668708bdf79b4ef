#include "planner/audit/depth_sweep.h"

#include "planner/audit/region_tracer.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace furrow {

namespace {

/// Heights with a smaller difference are one.
constexpr double kSameHeightM = 1e-9;
constexpr double kLeastPieceM2 = 1e-3;
constexpr std::size_t kRowsBetweenStopChecks = 256;

/// An edge from low to high, in the frame of the sweep. Lines of equal y run along it.
struct SweepEdge {
    Point low;
    Point high;
    std::uint32_t firstHeight = 0;  ///< index of its beginning in the heights
    std::uint32_t lastHeight = 0;
    std::int8_t step = 1;  ///< of the depth, from its left to its right
    std::uint8_t layer = 0;
    double slope = 0.0;  ///< x by y

    double at(double y) const {
        return y <= low.y ? low.x : y >= high.y ? high.x : low.x + slope * (y - low.y);
    }
};

/// An edge on the moving line, between two heights.
struct Crossed {
    const SweepEdge* edge;
    double lowX;
    double highX;

    double middle() const { return lowX + highX; }
};

class Sweep {
public:
    Sweep(const LayeredPolygons& polygons, Point along, const DepthRegions& wanted)
        : along_{along}, regionsAt_{wanted.at}, regions_(wanted.count) {
        for (std::size_t i = 0; i < wanted.count; ++i) {
            regions_[i].traced = (wanted.traced >> i & 1U) != 0;
        }
        prepare(polygons);
    }

    Result<std::vector<MeasuredRegion>> run(const JobContext& job) {
        std::size_t next = 0;
        for (std::size_t row = 0; row + 1 < heights_.size(); ++row) {
            if (row % kRowsBetweenStopChecks == 0 && job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            if (row == nextEnd_) {
                dropEnded(row);
            }
            for (; next < edges_.size() && edges_[next].firstHeight == row; ++next) {
                line_.push_back({&edges_[next], 0.0, edges_[next].at(heights_[row])});
                nextEnd_ = std::min<std::size_t>(nextEnd_, edges_[next].lastHeight);
            }
            if (!line_.empty()) {
                sweepRow(heights_[row], heights_[row + 1]);
            }
        }
        return results();
    }

private:
    /// One of the two ends of an edge.
    struct EdgeEnd {
        double y;
        std::uint32_t edge;
        bool isHigh;
    };

    void prepare(const LayeredPolygons& polygons) {
        std::vector<SweepEdge> edges;
        std::vector<EdgeEnd> ends;
        edges.reserve(polygons.edges().size());
        ends.reserve(2 * polygons.edges().size());
        for (const LayeredPolygons::Edge& edge : polygons.edges()) {
            const Point from{dot(edge.from, along_), cross(along_, edge.from)};
            const Point to{dot(edge.to, along_), cross(along_, edge.to)};
            // The inside is to the left of every edge. An edge that leads down is therefore entered from its
            // left.
            const bool leadsDown = from.y > to.y;
            const auto index = static_cast<std::uint32_t>(edges.size());
            edges.push_back(leadsDown ? SweepEdge{.low = to, .high = from, .step = 1, .layer = edge.layer}
                                      : SweepEdge{.low = from, .high = to, .step = -1, .layer = edge.layer});
            ends.push_back({edges.back().low.y, index, false});
            ends.push_back({edges.back().high.y, index, true});
        }
        std::ranges::sort(ends, {}, &EdgeEnd::y);
        heights_.reserve(ends.size());
        for (const EdgeEnd& end : ends) {
            if (heights_.empty() || !(end.y - heights_.back() < kSameHeightM)) {
                heights_.push_back(end.y);
            }
            const auto height = static_cast<std::uint32_t>(heights_.size() - 1);
            SweepEdge& edge = edges[end.edge];
            (end.isHigh ? edge.lastHeight : edge.firstHeight) = height;
        }
        // Edges that begin at the same height stay in their order.
        std::vector<std::uint32_t> places(heights_.size() + 1, 0);
        for (const SweepEdge& edge : edges) {
            ++places[edge.firstHeight + 1];
        }
        std::partial_sum(places.begin(), places.end(), places.begin());
        edges_.resize(edges.size());
        for (SweepEdge& edge : edges) {
            edge.slope = (edge.high.x - edge.low.x) / (edge.high.y - edge.low.y);
            edges_[places[edge.firstHeight]++] = edge;
        }
        // The remaining edges have a height and a slope.
        std::erase_if(edges_, [](const SweepEdge& edge) { return edge.firstHeight == edge.lastHeight; });
    }

    /// Takes the edges that end at this height off the line.
    void dropEnded(std::size_t row) {
        nextEnd_ = heights_.size();
        std::erase_if(line_, [&](const Crossed& each) {
            const std::size_t ends = each.edge->lastHeight;
            nextEnd_ = ends > row ? std::min(nextEnd_, ends) : nextEnd_;
            return ends <= row;
        });
    }

    /// Between two heights only crossings break the straight row.
    void sweepRow(double low, double high) {
        for (Crossed& each : line_) {
            each.lowX = each.highX;
        }
        place(high);
        findCrossings(low, high);
        if (crossings_.empty()) {
            measure(low, high);
            return;
        }
        double from = low;
        for (const double to : crossings_) {
            place(to);
            measure(from, to);
            for (Crossed& each : line_) {
                each.lowX = each.highX;
            }
            from = to;
        }
        place(high);
        measure(from, high);
    }

    /// Moves the upper side of the row, and sorts the edges by their order in the middle. From row to row it
    /// hardly changes.
    void place(double high) {
        for (Crossed& each : line_) {
            each.highX = each.edge->at(high);
        }
        for (std::size_t i = 1; i < line_.size(); ++i) {
            const Crossed moving = line_[i];
            std::size_t k = i;
            for (; k > 0 && line_[k - 1].middle() > moving.middle(); --k) {
                line_[k] = line_[k - 1];
            }
            line_[k] = moving;
        }
    }

    void findCrossings(double low, double high) {
        crossings_.clear();
        const auto note = [&](const Crossed& left, const Crossed& right) {
            const double before = left.lowX - right.lowX;
            const double after = left.highX - right.highX;
            if ((before > kRoundingM && after < -kRoundingM) ||
                (before < -kRoundingM && after > kRoundingM)) {
                crossings_.push_back(low + (high - low) * (before / (before - after)));
            }
        };
        // Two edges that cross are out of order, low or high, and so are all edges in between.
        double farthestLow = -std::numeric_limits<double>::infinity();
        double farthestHigh = farthestLow;
        for (std::size_t i = 0; i < line_.size(); ++i) {
            if (line_[i].lowX < farthestLow - kRoundingM || line_[i].highX < farthestHigh - kRoundingM) {
                for (std::size_t k = 0; k < i; ++k) {
                    note(line_[k], line_[i]);
                }
            }
            farthestLow = std::max(farthestLow, line_[i].lowX);
            farthestHigh = std::max(farthestHigh, line_[i].highX);
        }
        std::ranges::sort(crossings_);
        double last = low;
        std::erase_if(crossings_, [&](double height) {
            const bool same = height - last < kSameHeightM || high - height < kSameHeightM;
            last = same ? last : height;
            return same;
        });
    }

    void measure(double low, double high) {
        if (!hasLayoutOfBefore()) {
            layOut();
        }
        for (const Inside& inside : insides_) {
            addSpan(regions_[inside.region], line_[inside.left], line_[inside.right]);
        }
        for (Region& region : regions_) {
            region.area += 0.5 * region.width * (high - low);
            region.width = 0.0;
            if (!region.spans.empty()) {
                region.tracer.addRow(low, high, region.spans);
                region.spans.clear();
            }
        }
    }

    /// Notes the layers of the row from left to right. Where one edge follows another, they are those of the
    /// row before.
    bool hasLayoutOfBefore() {
        bool isSame = layout_.size() == line_.size();
        layout_.resize(line_.size());
        for (std::size_t i = 0; i < line_.size(); ++i) {
            const LayoutEdge now{.layer = line_[i].edge->layer,
                                 .step = line_[i].edge->step,
                                 .touchesNext = i + 1 < line_.size() && touch(line_[i], line_[i + 1])};
            isSame = isSame && layout_[i] == now;
            layout_[i] = now;
        }
        return isSame;
    }

    /// Finds which edges of the row begin and end which regions.
    void layOut() {
        insides_.clear();
        Depths depths{};
        std::uint32_t inside = 0;
        for (std::uint32_t i = 0; i < layout_.size(); ++i) {
            depths[layout_[i].layer] += layout_[i].step;
            if (layout_[i].touchesNext) {
                continue;
            }
            const std::uint32_t now = regionsAt_(depths);
            for (std::uint32_t changed = inside ^ now; changed != 0; changed &= changed - 1) {
                const auto r = static_cast<std::uint32_t>(std::countr_zero(changed));
                if ((now >> r & 1U) != 0) {
                    regions_[r].begin = i;
                } else {
                    insides_.push_back({.region = r, .left = regions_[r].begin, .right = i});
                }
            }
            inside = now;
        }
    }

    static bool touch(const Crossed& left, const Crossed& right) {
        return std::abs(right.lowX - left.lowX) < kRoundingM &&
               std::abs(right.highX - left.highX) < kRoundingM;
    }

    struct Region {
        double area = 0.0;
        bool traced = false;
        RegionTracer tracer;
        std::uint32_t begin = 0;  ///< edge of the row, while it is laid out
        // Of the current row.
        double width = 0.0;  ///< sum of low and high
        std::vector<RegionTracer::Span> spans;
    };

    /// What the depths on the two sides of an edge follow from.
    struct LayoutEdge {
        std::uint8_t layer = 0;
        std::int8_t step = 0;
        bool touchesNext = false;
        bool operator==(const LayoutEdge&) const = default;
    };

    /// A region between two edges of the row.
    struct Inside {
        std::uint32_t region;
        std::uint32_t left;
        std::uint32_t right;
    };

    std::uint32_t lineOf(const Crossed& edge) const {
        return static_cast<std::uint32_t>(edge.edge - edges_.data());
    }

    void addSpan(Region& region, const Crossed& left, const Crossed& right) const {
        // Edges that only touch may be in the other order by rounding.
        const double rightLow = std::max(right.lowX, left.lowX);
        const double rightHigh = std::max(right.highX, left.highX);
        region.width += (rightLow - left.lowX) + (rightHigh - left.highX);
        if (region.traced) {
            const bool isInOrder = right.lowX >= left.lowX && right.highX >= left.highX;
            region.spans.push_back({.leftLow = left.lowX,
                                    .leftHigh = left.highX,
                                    .rightLow = rightLow,
                                    .rightHigh = rightHigh,
                                    .leftLine = lineOf(left),
                                    .rightLine = isInOrder ? lineOf(right) : RegionTracer::kNoLine});
        }
    }

    Result<std::vector<MeasuredRegion>> results() {
        std::vector<MeasuredRegion> found(regions_.size());
        for (std::size_t i = 0; i < regions_.size(); ++i) {
            found[i].area = squareMetres(regions_[i].area);
            found[i].polygons = regions_[i].tracer.finish(kLeastPieceM2);
            for (Polygon& polygon : found[i].polygons) {
                turnBack(polygon.outer);
                std::ranges::for_each(polygon.holes, [this](Ring& hole) { turnBack(hole); });
            }
        }
        return found;
    }

    void turnBack(Ring& ring) const {
        for (Point& point : ring) {
            point = point.x * along_ + point.y * Point{-along_.y, along_.x};
        }
    }

    Point along_;
    std::uint32_t (*regionsAt_)(const Depths&);
    std::vector<Region> regions_;
    std::vector<SweepEdge> edges_;                                   ///< in the order of their beginnings
    std::vector<double> heights_;                                    ///< of the beginnings and ends of edges
    std::size_t nextEnd_ = std::numeric_limits<std::size_t>::max();  ///< of an edge on the line
    std::vector<Crossed> line_;  ///< the edges that the line crosses now, from left to right
    std::vector<double> crossings_;
    std::vector<LayoutEdge> layout_;  ///< of the row
    std::vector<Inside> insides_;     ///< the same, by their right edges
};

}  // namespace

void LayeredPolygons::add(std::size_t layer, std::span<const Point> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        edges_.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], static_cast<std::uint8_t>(layer)});
    }
}

void LayeredPolygons::add(std::size_t layer, const MultiPolygon& polygons) {
    for (const Polygon& polygon : polygons) {
        add(layer, polygon.outer);
        for (const Ring& hole : polygon.holes) {
            add(layer, hole);
        }
    }
}

void LayeredPolygons::addNext(std::size_t layer, std::span<const Point> ring) {
    const auto first = static_cast<std::ptrdiff_t>(std::min(last_, edges_.size()));
    added_.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Edge edge{ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], static_cast<std::uint8_t>(layer)};
        const auto shared = std::find_if(edges_.begin() + first, edges_.end(), [&](const Edge& other) {
            return other.layer == edge.layer && other.from == edge.to && other.to == edge.from;
        });
        if (shared == edges_.end()) {
            added_.push_back(edge);
        } else {
            edges_.erase(shared);
        }
    }
    last_ = edges_.size();
    edges_.insert(edges_.end(), added_.begin(), added_.end());
}

Result<std::vector<MeasuredRegion>> measureRegions(const LayeredPolygons& polygons, Point along,
                                                   const DepthRegions& regions, const JobContext& job) {
    return Sweep{polygons, along, regions}.run(job);
}

}  // namespace furrow
