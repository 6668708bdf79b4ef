#include "planner/audit/region_tracer.h"

#include "planner/audit/length.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace furrow {

namespace {

/// Ends that are closer are one node. This is far more than rounding and far less than visible.
constexpr double kSameNodeM = 1e-7;
/// A flatter bend is removed.
constexpr double kFlatM = 1e-7;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

Ring withoutFlatBends(const Ring& ring) {
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point before = kept.empty() ? ring.back() : kept.back();
        // Of two equal points, one at the end and one at the beginning, the first is gone already.
        const bool isLast = i + 1 == ring.size() && !kept.empty();
        const Point along = (isLast ? kept.front() : ring[(i + 1) % ring.size()]) - before;
        const double length = lengthOf(along);
        if (length > 0.0 && std::abs(cross(along, ring[i] - before)) > kFlatM * length) {
            kept.push_back(ring[i]);
        }
    }
    return kept;
}

/// Adds a hole to the smallest polygon around it. Pieces that are joined by less than rounding are not known
/// to be one, and a piece that touches itself has several outer rings.
/// @param polygons  largest first
void addHole(MultiPolygon& polygons, Ring hole) {
    const auto isAround = [&](const Polygon& polygon) {
        const auto inside =
            std::ranges::count_if(hole, [&](Point point) { return isInside(polygon.outer, point); });
        return 2 * inside > std::ssize(hole);
    };
    if (const auto around = std::ranges::find_last_if(polygons, isAround); !around.empty()) {
        around.front().holes.push_back(std::move(hole));
    }
}

bool isBetweenSameLines(const RegionTracer::Span& a, const RegionTracer::Span& b) {
    return a.leftLine != RegionTracer::kNoLine && a.leftLine == b.leftLine &&
           a.rightLine != RegionTracer::kNoLine && a.rightLine == b.rightLine;
}

}  // namespace

void RegionTracer::addRow(double low, double high, const std::vector<Span>& spans) {
    if (low != height_) {
        endAll();
    }
    if (goesOn(spans)) {
        height_ = high;
        return;
    }
    readRow(spans);
    join(low);
    for (Open& open : above_) {
        if (open.same == kNone) {
            continue;
        }
        const Open& before = below_[std::exchange(open.same, kNone)];
        open.leftNode = before.leftNode;
        open.rightNode = before.rightNode;
        open.piece = before.piece;
    }
    std::swap(below_, above_);
    height_ = high;
}

/// If nothing begins or ends, only the spans move on: that is most rows.
bool RegionTracer::goesOn(const std::vector<Span>& spans) {
    const auto isSame = [](const Open& open, const Span& span) {
        return isBetweenSameLines(open.span, span);
    };
    if (!std::ranges::equal(below_, spans, isSame)) {
        return false;
    }
    for (std::size_t i = 0; i < spans.size(); ++i) {
        below_[i].span = spans[i];
    }
    return true;
}

/// Takes the spans of a row, and links them to those that they continue from below.
void RegionTracer::readRow(const std::vector<Span>& spans) {
    above_.clear();
    std::uint32_t next = 0;
    for (const Span& span : spans) {
        std::uint32_t from = next;
        while (from < below_.size() && !isBetweenSameLines(below_[from].span, span)) {
            ++from;
        }
        above_.push_back(
            {.span = span, .leftNode = kNone, .rightNode = kNone, .piece = kNone, .same = kNone});
        if (from < below_.size()) {
            below_[from].same = static_cast<std::uint32_t>(above_.size() - 1);
            above_.back().same = from;
            next = from + 1;
        }
    }
    // A span that begins or ends at the side of another needs a node there. The other span then needs it,
    // too.
    const auto breakTouched = [](std::vector<Open>& these, std::vector<Open>& others, double Span::* left,
                                 double Span::* right) {
        bool broken = false;
        for (std::size_t i = 1; i < these.size(); ++i) {
            Open& a = these[i - 1];
            Open& b = these[i];
            if ((a.same == kNone) != (b.same == kNone) && b.span.*left - a.span.*right <= kSameNodeM) {
                others[std::exchange((a.same == kNone ? b : a).same, kNone)].same = kNone;
                broken = true;
            }
        }
        return broken;
    };
    bool broken = true;
    while (broken) {
        broken = breakTouched(above_, below_, &Span::leftLow, &Span::rightLow);
        broken = breakTouched(below_, above_, &Span::leftHigh, &Span::rightHigh) || broken;
    }
    for (Open& open : above_) {
        if (open.same == kNone) {
            open.piece = static_cast<std::uint32_t>(parents_.size());
            parents_.push_back(open.piece);
        }
    }
}

void RegionTracer::endAll() {
    above_.clear();
    join(height_);
    below_.clear();
}

/// Makes the nodes at one height. Closes the spans that end there from below and begins those above.
void RegionTracer::join(double height) {
    ends_.clear();
    for (Open& open : below_) {
        if (open.same == kNone) {
            ends_.push_back({open.span.leftHigh, &open, false, true});
            ends_.push_back({open.span.rightHigh, &open, false, false});
        }
    }
    for (Open& open : above_) {
        if (open.same == kNone) {
            ends_.push_back({open.span.leftLow, &open, true, true});
            ends_.push_back({open.span.rightLow, &open, true, false});
        }
    }
    std::ranges::stable_sort(ends_, {}, &End::x);
    // The counts allow for rounding that puts the end of one span behind the start of the next. Nodes then
    // still have as many edges in as out.
    int under = 0;
    int over = 0;
    std::uint32_t pieceUnder = 0;
    std::uint32_t pieceOver = 0;
    std::uint32_t node = kNone;
    for (std::size_t i = 0; i < ends_.size();) {
        const std::uint32_t before = node;
        node = newNode({ends_[i].x, height});
        if (under > 0 && over > 0) {
            unite(pieceUnder, pieceOver);
        }
        for (int extra = under; extra > over; --extra) {
            addEdge(node, before, pieceUnder);
        }
        for (int extra = over; extra > under; --extra) {
            addEdge(before, node, pieceOver);
        }
        const double reach = ends_[i].x + kSameNodeM;
        for (; i < ends_.size() && ends_[i].x <= reach; ++i) {
            const End& end = ends_[i];
            if (end.isAbove) {
                (end.isLeft ? end.open->leftNode : end.open->rightNode) = node;
                over += end.isLeft ? 1 : -1;
                pieceOver = end.isLeft ? end.open->piece : pieceOver;
                continue;
            }
            // Inside lies to the left of every edge: down on the left side, up on the right.
            if (end.isLeft) {
                addEdge(node, end.open->leftNode, end.open->piece);
            } else {
                addEdge(end.open->rightNode, node, end.open->piece);
            }
            under += end.isLeft ? 1 : -1;
            pieceUnder = end.isLeft ? end.open->piece : pieceUnder;
        }
    }
}

std::uint32_t RegionTracer::newNode(Point place) {
    nodes_.push_back(place);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void RegionTracer::addEdge(std::uint32_t from, std::uint32_t to, std::uint32_t piece) {
    edges_.push_back({from, to, piece});
}

std::uint32_t RegionTracer::pieceOf(std::uint32_t piece) {
    while (parents_[piece] != piece) {
        parents_[piece] = parents_[parents_[piece]];
        piece = parents_[piece];
    }
    return piece;
}

void RegionTracer::unite(std::uint32_t a, std::uint32_t b) {
    a = pieceOf(a);
    b = pieceOf(b);
    parents_[std::max(a, b)] = std::min(a, b);
}

/// Takes the loop at the end of a way off it.
std::pair<std::uint32_t, Ring> RegionTracer::takeLoop(std::vector<std::uint32_t>& way, std::size_t begin,
                                                      std::vector<std::uint32_t>& placeOnWay) {
    Ring ring;
    for (std::size_t i = begin; i < way.size(); ++i) {
        ring.push_back(nodes_[edges_[way[i]].from]);
        placeOnWay[edges_[way[i]].from] = kNone;
    }
    const std::uint32_t piece = pieceOf(edges_[way.back()].piece);
    way.resize(begin);
    return {piece, std::move(ring)};
}

/// Walks along the edges, to the left at forks. A loop is closed as soon as a node repeats, so no ring
/// touches itself.
std::vector<std::pair<std::uint32_t, Ring>> RegionTracer::closeRings() {
    std::vector<std::uint32_t> first(nodes_.size() + 1, 0);
    for (const Edge& edge : edges_) {
        ++first[edge.from + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Edge> byNode(edges_.size());
    for (std::vector<std::uint32_t> next = first; const Edge& edge : edges_) {
        byNode[next[edge.from]++] = edge;
    }
    edges_ = std::move(byNode);
    std::vector<char> used(edges_.size(), 0);
    std::vector<std::uint32_t> placeOnWay(nodes_.size(), kNone);
    const auto headingOf = [this](const Edge& edge) {
        const Point way = nodes_[edge.to] - nodes_[edge.from];
        return std::atan2(way.y, way.x);
    };
    const auto nextFrom = [&](std::uint32_t node, const Edge& arrived) {
        std::uint32_t best = kNone;
        double sharpest = -10.0;
        for (std::uint32_t i = first[node]; i < first[node + 1]; ++i) {
            if (used[i] != 0) {
                continue;
            }
            if (best == kNone && i + 1 == first[node + 1]) {
                return i;
            }
            const double turn =
                std::remainder(headingOf(edges_[i]) - headingOf(arrived), 2.0 * std::numbers::pi);
            if (turn > sharpest) {
                sharpest = turn;
                best = i;
            }
        }
        return best;
    };
    std::vector<std::pair<std::uint32_t, Ring>> rings;
    std::vector<std::uint32_t> way;  // edges
    for (std::uint32_t start = 0; start < edges_.size(); ++start) {
        if (used[start] != 0) {
            continue;
        }
        way = {start};
        used[start] = 1;
        placeOnWay[edges_[start].from] = 0;
        while (!way.empty()) {
            const std::uint32_t node = edges_[way.back()].to;
            if (placeOnWay[node] != kNone) {
                rings.push_back(takeLoop(way, placeOnWay[node], placeOnWay));
                if (way.empty()) {
                    break;
                }
            }
            const std::uint32_t next = nextFrom(node, edges_[way.back()]);
            placeOnWay[node] = static_cast<std::uint32_t>(way.size());
            used[next] = 1;
            way.push_back(next);
        }
    }
    return rings;
}

MultiPolygon RegionTracer::finish(double leastAreaM2) {
    endAll();
    auto rings = closeRings();
    // The outer rings of each piece first, then its holes.
    std::ranges::stable_sort(rings, [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first < b.first : signedAreaM2(a.second) > signedAreaM2(b.second);
    });
    MultiPolygon polygons;
    std::vector<Ring> apart;
    std::uint32_t piece = kNone;
    std::size_t outerRings = 0;  // of this piece
    for (auto& [of, points] : rings) {
        Ring ring = withoutFlatBends(points);
        const double areaM2 = ring.size() < 3 ? 0.0 : signedAreaM2(ring);
        if (areaM2 > leastAreaM2) {
            polygons.push_back({.outer = std::move(ring), .holes = {}});
            outerRings = of == piece ? outerRings + 1 : 1;
            piece = of;
        } else if (areaM2 < -leastAreaM2) {
            (of == piece && outerRings == 1 ? polygons.back().holes : apart).push_back(std::move(ring));
        }
    }
    std::ranges::stable_sort(polygons, std::ranges::greater{},
                             [](const Polygon& polygon) { return area(polygon); });
    for (Ring& hole : apart) {
        addHole(polygons, std::move(hole));
    }
    return polygons;
}

}  // namespace furrow
