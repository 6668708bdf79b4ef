#include "planner/audit/depth_sweep.h"

#include "planner/audit/region_tracer.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
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
    void prepare(const LayeredPolygons& polygons) {
        edges_.reserve(polygons.edges().size());
        heights_.reserve(2 * polygons.edges().size());
        for (const LayeredPolygons::Edge& edge : polygons.edges()) {
            const Point from{dot(edge.from, along_), cross(along_, edge.from)};
            const Point to{dot(edge.to, along_), cross(along_, edge.to)};
            // The inside is to the left of every edge. An edge that leads down is therefore entered from its
            // left.
            edges_.push_back(from.y > to.y
                                 ? SweepEdge{.low = to, .high = from, .step = 1, .layer = edge.layer}
                                 : SweepEdge{.low = from, .high = to, .step = -1, .layer = edge.layer});
            heights_.push_back(from.y);
            heights_.push_back(to.y);
        }
        std::ranges::sort(heights_);
        double last = -std::numeric_limits<double>::infinity();
        std::erase_if(heights_, [&last](double height) {
            const bool same = height - last < kSameHeightM;
            last = same ? last : height;
            return same;
        });
        const auto heightOf = [this](double y) {
            const auto above = std::ranges::upper_bound(heights_, y);
            return static_cast<std::uint32_t>(above - heights_.begin() - 1);
        };
        for (SweepEdge& edge : edges_) {
            edge.firstHeight = heightOf(edge.low.y);
            edge.lastHeight = heightOf(edge.high.y);
            edge.slope = (edge.high.x - edge.low.x) / (edge.high.y - edge.low.y);
        }
        // The remaining edges have a height and a slope.
        std::erase_if(edges_, [](const SweepEdge& edge) { return edge.firstHeight == edge.lastHeight; });
        std::ranges::stable_sort(edges_, {}, &SweepEdge::firstHeight);
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
        Depths depths{};
        std::uint32_t inside = 0;
        for (std::size_t i = 0; i < line_.size(); ++i) {
            depths[line_[i].edge->layer] += line_[i].edge->step;
            if (i + 1 < line_.size() && touch(line_[i], line_[i + 1])) {
                continue;
            }
            const std::uint32_t now = regionsAt_(depths);
            for (std::uint32_t changed = inside ^ now; changed != 0; changed &= changed - 1) {
                const int r = std::countr_zero(changed);
                enterOrLeave(regions_[static_cast<std::size_t>(r)], line_[i], (now >> r & 1U) != 0);
            }
            inside = now;
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

    static bool touch(const Crossed& left, const Crossed& right) {
        return std::abs(right.lowX - left.lowX) < kRoundingM &&
               std::abs(right.highX - left.highX) < kRoundingM;
    }

    struct Region {
        double area = 0.0;
        bool traced = false;
        RegionTracer tracer;
        // Of the current row.
        double width = 0.0;  ///< sum of low and high
        RegionTracer::Span begun;
        std::vector<RegionTracer::Span> spans;
    };

    std::uint32_t lineOf(const Crossed& edge) const {
        return static_cast<std::uint32_t>(edge.edge - edges_.data());
    }

    void enterOrLeave(Region& region, const Crossed& edge, bool inside) const {
        RegionTracer::Span& span = region.begun;
        if (inside) {
            span.leftLow = edge.lowX;
            span.leftHigh = edge.highX;
            span.leftLine = lineOf(edge);
            return;
        }
        // Edges that only touch may be in the other order by rounding.
        const bool isInOrder = edge.lowX >= span.leftLow && edge.highX >= span.leftHigh;
        span.rightLow = std::max(edge.lowX, span.leftLow);
        span.rightHigh = std::max(edge.highX, span.leftHigh);
        span.rightLine = isInOrder ? lineOf(edge) : RegionTracer::kNoLine;
        region.width += (span.rightLow - span.leftLow) + (span.rightHigh - span.leftHigh);
        if (region.traced) {
            region.spans.push_back(span);
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
