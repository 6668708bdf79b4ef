#include "planner/swaths/mainland_edges.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Lines are cut as chords that stay this close to them.
constexpr Length kChord = metres(0.0005);
// Shorter parts only touch.
constexpr Length kLeastPart = metres(0.01);

}  // namespace

MainlandEdges::MainlandEdges(const MultiPolygon& mainland) : box_{bounds(mainland)} {
    std::vector<Bounds> boxes;
    forEachEdge(mainland, [&](Point from, Point to) {
        edges_.push_back({from, to});
        boxes.push_back({{std::min(from.x, to.x), std::min(from.y, to.y)},
                         {std::max(from.x, to.x), std::max(from.y, to.y)}});
    });
    tree_ = BoxTree{boxes};
}

bool MainlandEdges::contains(Point point) const {
    bool inside = false;
    tree_.any(
        [&](const Bounds& box) {
            return box.min.y <= point.y && box.max.y >= point.y && box.max.x >= point.x;
        },
        [&](std::size_t i) {
            const auto [a, b] = edges_[i];
            if (meetsRay(point, a, b)) {
                inside = !inside;
            }
            return false;
        });
    return inside;
}

std::vector<Curve> MainlandEdges::partsInside(const Curve& line) const {
    const std::vector<CurveSample> samples = sampled(line, kChord);
    std::vector<double> crossings{0.0};
    for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
        const Point a = samples[k].pose.position;
        const Point b = samples[k + 1].pose.position;
        const Bounds chord = bounds(a, b);
        tree_.any([&](const Bounds& box) { return meet(box, chord); },
                  [&](std::size_t i) {
                      const auto [c, d] = edges_[i];
                      const double area = cross(b - a, d - c);
                      const double share = area == 0.0 ? -1.0 : cross(c - a, d - c) / area;
                      const double edgeShare = area == 0.0 ? -1.0 : cross(c - a, b - a) / area;
                      if (share >= 0.0 && share <= 1.0 && edgeShare >= 0.0 && edgeShare <= 1.0) {
                          crossings.push_back(
                              (samples[k].way + share * (samples[k + 1].way - samples[k].way)).si());
                      }
                      return false;
                  });
    }
    crossings.push_back(samples.back().way.si());
    std::ranges::sort(crossings);
    // The middle of each stretch decides whether it is inside. A line that touches a corner crosses there
    // twice or not at all.
    std::vector<Curve> parts;
    Length begin;
    bool open = false;
    const auto close = [&](Length end) {
        if (open && end - begin > kLeastPart) {
            parts.push_back(partOf(line, begin, end));
        }
        open = false;
    };
    Pose pose = line.start;
    Length passed;  // length of the line before `piece`
    std::size_t piece = 0;
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
        if (crossings[k + 1] - crossings[k] < 1e-6) {
            continue;
        }
        const Length middle = metres(0.5 * (crossings[k] + crossings[k + 1]));
        while (piece + 1 < line.pieces.size() && passed + line.pieces[piece].length < middle) {
            pose = advanced(pose, line.pieces[piece], line.pieces[piece].length);
            passed += line.pieces[piece].length;
            ++piece;
        }
        if (!contains(advanced(pose, line.pieces[piece], middle - passed).position)) {
            close(metres(crossings[k]));
        } else if (!open) {
            begin = metres(crossings[k]);
            open = true;
        }
    }
    close(metres(crossings.back()));
    return parts;
}

std::vector<Point> MainlandEdges::pointsAlong(Length apart) const {
    std::vector<Point> points;
    for (const auto& [from, to] : edges_) {
        const auto steps = std::max(1, static_cast<int>(std::ceil(distance(from, to) / apart.si())));
        for (int k = 0; k < steps; ++k) {
            points.push_back(from + (static_cast<double>(k) / steps) * (to - from));
        }
    }
    return points;
}

}  // namespace furrow
