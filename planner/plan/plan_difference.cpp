#include "planner/plan/plan_difference.h"

#include "planner/geometry/box_tree.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/segment.h"
#include "planner/plan/method_registry.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// A boom is not steered more exactly than this.
constexpr double kSamePlaceM = 0.1;
// Smaller differences would read as none.
constexpr double kLeast = 1.0;

bool isNear(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y) <= kSamePlaceM;
}

bool isSame(const Swath& a, const Swath& b) {
    const bool ends = (isNear(a.start, b.start) && isNear(a.end, b.end)) ||
                      (isNear(a.start, b.end) && isNear(a.end, b.start));
    return ends && std::abs(lineOf(a).length().si() - lineOf(b).length().si()) <= kSamePlaceM;
}

std::vector<std::size_t> onlyIn(const SwathSet& set, const SwathSet& other) {
    std::vector<std::size_t> only;
    for (std::size_t i = 0; i < set.swaths.size(); ++i) {
        if (std::ranges::none_of(other.swaths,
                                 [&swath = set.swaths[i]](const Swath& its) { return isSame(swath, its); })) {
            only.push_back(i);
        }
    }
    return only;
}

struct Edge {
    Point from;
    Point to;
};

bool isWorkedPass(const PathSegment& segment) {
    return segment.kind == SegmentKind::HeadlandPass;
}

/// The headland passes of a path, or its ways between worked lines, to be asked what lies there.
class DrivenLines {
public:
    DrivenLines(const Path& path, bool worked) {
        std::vector<Bounds> boxes;
        for (const PathSegment& segment : path.segments) {
            if (segment.kind == SegmentKind::Swath || isWorkedPass(segment) != worked) {
                continue;
            }
            for (std::size_t i = 1; i < segment.samples.size(); ++i) {
                const Point a = segment.samples[i - 1].position;
                const Point b = segment.samples[i].position;
                if (distance(a, b) > 0.0) {
                    edges_.push_back({a, b});
                    boxes.push_back(bounds(a, b));
                }
            }
        }
        tree_ = BoxTree{boxes};
    }

    /// One of them lies here and runs along.
    bool has(Point place, Point way) const {
        // What crosses at more than this is another line. A bend's chords differ by less.
        constexpr double kSineOfAlong = 0.25;
        return tree_.any([place](const Bounds& box) { return distanceM(place, box) <= kSamePlaceM; },
                         [&](std::size_t i) {
                             const Edge& edge = edges_[i];
                             const Point along = edge.to - edge.from;
                             return distanceToSegment(place, edge.from, edge.to) <= kSamePlaceM &&
                                    std::abs(cross(along, way)) <= kSineOfAlong * norm(along) * norm(way);
                         });
    }

private:
    std::vector<Edge> edges_;
    BoxTree tree_;
};

/// Collects stretches as the path is gone along.
class Stretches {
public:
    void add(bool worked, Point from, Point to) {
        const bool goesOn = !all_.empty() && all_.back().worked == worked && all_.back().line.back() == from;
        if (!goesOn) {
            all_.push_back({.worked = worked, .line = {from}});
        }
        all_.back().line.push_back(to);
    }
    std::vector<DifferentStretch> take() {
        // Where two lines part, a hand's breadth of them is no difference.
        std::erase_if(all_, [](const DifferentStretch& each) { return each.length() < metres(kLeast); });
        return std::move(all_);
    }

private:
    std::vector<DifferentStretch> all_;
};

/// Adds what of an edge the lines do not have. It is looked at in steps; what parts from the lines does so to
/// within one.
void addMissing(Point from, Point to, bool worked, const DrivenLines& lines, Stretches& stretches) {
    constexpr double kStepM = 0.5;
    const Point way = to - from;
    const auto steps = static_cast<std::size_t>(std::ceil(norm(way) / kStepM));
    const auto at = [&](double step) { return from + (step / static_cast<double>(steps)) * way; };
    // Neighbouring steps that differ become one edge. Its ends as they are: the next edge goes on from there.
    std::size_t first = 0;
    const auto addUpTo = [&](std::size_t step) {
        if (first < step) {
            stretches.add(worked, first == 0 ? from : at(static_cast<double>(first)),
                          step == steps ? to : at(static_cast<double>(step)));
        }
        first = step + 1;
    };
    for (std::size_t step = 0; step < steps; ++step) {
        if (lines.has(at(static_cast<double>(step) + 0.5), way)) {
            addUpTo(step);
        }
    }
    addUpTo(steps);
}

std::vector<DifferentStretch> drivenOnlyIn(const Path& path, const Path& other) {
    const DrivenLines passes{other, true};
    const DrivenLines ways{other, false};
    Stretches stretches;
    for (const PathSegment& segment : path.segments) {
        if (segment.kind == SegmentKind::Swath) {
            continue;
        }
        const bool worked = isWorkedPass(segment);
        const DrivenLines& lines = worked ? passes : ways;
        for (std::size_t i = 1; i < segment.samples.size(); ++i) {
            addMissing(segment.samples[i - 1].position, segment.samples[i].position, worked, lines,
                       stretches);
        }
    }
    return stretches.take();
}

std::optional<double> squareMetresOf(const std::optional<Area>& area) {
    return area.transform([](Area measured) { return measured.si(); });
}

}  // namespace

Length DifferentStretch::length() const {
    return metres(lengthM(line));
}

Length lengthOf(const std::vector<DifferentStretch>& stretches, bool worked) {
    Length sum;
    for (const DifferentStretch& stretch : stretches) {
        sum = stretch.worked == worked ? sum + stretch.length() : sum;
    }
    return sum;
}

Better betterOf(Figure figure) {
    switch (figure) {
        case Figure::Covered: return Better::More;
        case Figure::Working:
        case Figure::Mainland:
        case Figure::Swaths: return Better::Neither;
        default: return Better::Less;
    }
}

std::optional<double> figureOf(const Plan& plan, Figure figure) {
    switch (figure) {
        case Figure::Time: return plan.path.duration().si();
        case Figure::Path: return plan.path.length().si();
        case Figure::Working: return plan.path.workedLength().si();
        case Figure::Turning: return (plan.path.length() - plan.path.workedLength()).si();
        case Figure::Mainland: return area(plan.headland.mainland).si();
        case Figure::Swaths: return static_cast<double>(plan.swaths.swaths.size());
        case Figure::Covered: return squareMetresOf(plan.audit.covered);
        case Figure::Missed: return squareMetresOf(plan.audit.missed);
        case Figure::Overlap: return squareMetresOf(plan.audit.overlap);
        case Figure::Outside: return squareMetresOf(plan.audit.outside);
        case Figure::Reversed: return plan.audit.reversed.si();
        case Figure::Problems: break;
    }
    return static_cast<double>(plan.blockingCount());
}

int better(Figure figure, std::optional<double> first, std::optional<double> second) {
    const Better wanted = betterOf(figure);
    if (wanted == Better::Neither || !first || !second || std::abs(*first - *second) < kLeast) {
        return 0;
    }
    return (*first < *second) == (wanted == Better::Less) ? -1 : 1;
}

PlanDifference differenceOf(const Plan& first, const Plan& second) {
    PlanDifference difference{.machine = first.request.machine != second.request.machine,
                              .settings = {},
                              .onlyInFirst = onlyIn(first.swaths, second.swaths),
                              .onlyInSecond = onlyIn(second.swaths, first.swaths),
                              .drivenOnlyInFirst = drivenOnlyIn(first.path, second.path),
                              .drivenOnlyInSecond = drivenOnlyIn(second.path, first.path)};
    for (const Parameter* parameter : allParameters()) {
        const SettingValue mine = first.request.settings.value(*parameter);
        const SettingValue its = second.request.settings.value(*parameter);
        if (mine != its) {
            difference.settings.push_back({.parameter = parameter, .first = mine, .second = its});
        }
    }
    return difference;
}

}  // namespace furrow
