#include "planner/swaths/edge_preference.h"

#include "planner/geometry/simplify.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"
#include "planner/units/time_message.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>

namespace furrow {

namespace {

// Points within this distance of a line are on it: the accuracy of a hand survey or of clicks on an image.
constexpr Length kStraight = metres(0.15);
// Shorter edges, as a share of the longest, are no guide for work.
constexpr double kLongShare = 0.2;
// Only the longest edges are tried, at most this many.
constexpr std::size_t kMostLongEdges = 24;
constexpr double kEdgeCoverageSlack = 1e-9;
// Headings closer than this are equal. The candidates shown to choose from lie `kApartDeg` apart.
constexpr double kSameDeg = 1e-6;
// A smaller difference needs no note: it is less than two decimetres over a kilometre.
constexpr double kUnseenDeg = 0.01;
constexpr double kApartDeg = 1.0;
// Seconds or metres: nobody notices less on a field, and estimated turns are no more exact.
constexpr double kWorthTelling = 5.0;
constexpr std::size_t kMostCandidates = 4;

double apartDeg(Angle a, Angle b) {
    return inDegrees(angleBetweenLines(a, b));
}

/// The main direction of a line, with all of its length weighted equally.
Angle mainDirection(std::span<const Point> line) {
    double whole = 0.0;
    Point mean;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double part = distance(line[i], line[i + 1]);
        whole += part;
        mean = mean + 0.5 * part * (line[i] + line[i + 1]);
    }
    mean = (1.0 / whole) * mean;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point a = line[i] - mean;
        const Point b = line[i + 1] - mean;
        const double part = distance(a, b) / 3.0;
        xx += part * (a.x * a.x + a.x * b.x + b.x * b.x);
        yy += part * (a.y * a.y + a.y * b.y + b.y * b.y);
        xy += part * (a.x * a.y + 0.5 * (a.x * b.y + b.x * a.y) + b.x * b.y);
    }
    return radians(0.5 * std::atan2(2.0 * xy, xx - yy));
}

/// A ring that starts at a corner, so that no straight edge continues across its first point.
Ring fromCorner(const Ring& ring) {
    const auto corner =
        std::ranges::max_element(ring, {}, [&](const Point& point) { return norm(point - ring.front()); });
    Ring turned{corner, ring.end()};
    turned.insert(turned.end(), ring.begin(), corner);
    return turned;
}

void addEdges(const Ring& ring, std::vector<LongEdge>& edges) {
    Ring closed = fromCorner(ring);
    closed.push_back(closed.front());
    const Polyline corners = simplified(closed, kStraight);
    auto from = closed.begin();
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const auto to = std::find(from + 1, closed.end(), corners[i + 1]);
        const Angle heading = mainDirection({from, to + 1});
        edges.push_back({normalisedSwathHeading(heading), metres(distance(corners[i], corners[i + 1]))});
        from = to;
    }
}

bool isNoWorse(SwathObjective objective, const HeadingFigures& edge, const HeadingFigures& best,
               double share) {
    if (edge.count == 0) {
        return false;
    }
    if (objective == SwathObjective::Time) {
        return edge.time <= (1.0 + share) * best.time;
    }
    if (edge.coverage < best.coverage - kEdgeCoverageSlack) {
        return false;
    }
    return objective == SwathObjective::Length
               ? edge.length + edge.missed <= (1.0 + share) * (best.length + best.missed)
               : isAsGood(objective, edge, best);
}

/// Whether a heading may be no worse, by its lines alone where these decide. Areas take much longer.
bool mayBeNoWorse(const ScanLine& scanLine, Angle heading, SwathObjective objective,
                  const HeadingFigures& best) {
    return !isOfLines(objective) || isAsGood(objective, scanLine.lineFigures(heading, objective), best);
}

Note noteOf(const PreferredHeading& preferred, SwathObjective objective) {
    const bool isLongest =
        preferred.longestEdge && preferred.longestEdge->heading == preferred.chosen.heading;
    const Message along = isLongest ? message("along the longest edge") : message("along an edge");
    const HeadingFigures& chosen = preferred.chosen.figures;
    const HeadingFigures& best = preferred.best->figures;
    Message text = message("swaths run {}", along);
    if (objective == SwathObjective::Time) {
        const Duration slower = chosen.time - best.time;
        text = slower.si() >= kWorthTelling
                   ? message("swaths run {}; about {} slower than with the best heading", along,
                             timeMessage(slower))
                   : message("swaths run {}; as quick as with the best heading", along);
    } else if (objective == SwathObjective::Length) {
        const double moreM = (chosen.length + chosen.missed - best.length - best.missed).si();
        text = moreM >= kWorthTelling
                   ? message("swaths run {}; {:.0f} m more than with the best heading", along, moreM)
                   : message("swaths run {}; as short as with the best heading", along);
    }
    return {.text = text, .where = std::string{kPreferEdge.key}, .place = {}};
}

/// The quickest headings that are apart from each other, and always the chosen one and those of the longest
/// edges.
std::vector<HeadingCandidate> candidatesOf(std::vector<BestHeading> tried, const BestHeading& chosen,
                                           const std::vector<BestHeading>& alongLongest) {
    std::ranges::stable_sort(tried, {}, [](const BestHeading& heading) { return heading.figures.time; });
    tried.insert(tried.begin(), chosen);
    std::vector<HeadingCandidate> candidates;
    const auto add = [&](const BestHeading& heading, double apart) {
        const bool isNew = std::ranges::none_of(candidates, [&](const HeadingCandidate& other) {
            return apartDeg(other.heading, heading.heading) < apart;
        });
        if (isNew) {
            const bool isLongest = std::ranges::any_of(alongLongest, [&](const BestHeading& edge) {
                return apartDeg(edge.heading, heading.heading) < kSameDeg;
            });
            candidates.push_back({heading.heading, heading.figures, isLongest});
        }
    };
    for (std::size_t i = 0; i < tried.size() && candidates.size() < kMostCandidates; ++i) {
        add(tried[i], kApartDeg);
    }
    // First that of the field, which people see. An edge takes the place of a heading that lies close by, but
    // not of the chosen one.
    for (const BestHeading& edge : alongLongest) {
        std::erase_if(candidates, [&](const HeadingCandidate& other) {
            return !other.alongLongestEdge && apartDeg(other.heading, chosen.heading) >= kSameDeg &&
                   apartDeg(other.heading, edge.heading) < kApartDeg;
        });
        add(edge, kUnseenDeg);
    }
    std::ranges::stable_sort(candidates, {},
                             [](const HeadingCandidate& candidate) { return candidate.figures.time; });
    return candidates;
}

}  // namespace

std::vector<LongEdge> longEdges(const MultiPolygon& boundary, Length least) {
    std::vector<LongEdge> edges;
    for (const Polygon& polygon : boundary) {
        addEdges(polygon.outer, edges);
        std::ranges::for_each(polygon.holes, [&](const Ring& hole) { addEdges(hole, edges); });
    }
    std::ranges::stable_sort(edges, std::ranges::greater{}, &LongEdge::length);
    const Length shortest = edges.empty() ? least : std::max(least, kLongShare * edges.front().length);
    std::erase_if(edges, [shortest](const LongEdge& edge) { return edge.length < shortest; });
    return edges;
}

Angle longestEdgeHeading(const SwathTask& task) {
    double longestM = -1.0;
    Point edge;
    forEachEdge(task.mainland, [&](Point from, Point to) {
        if (const double lengthM = distance(from, to); lengthM > longestM) {
            longestM = lengthM;
            edge = to - from;
        }
    });
    const Angle own = radians(std::atan2(edge.y, edge.x));
    const std::vector<LongEdge> fences = longEdges(task.field.boundary(), task.machine.operatingWidth());
    const auto beside = std::ranges::find_if(
        fences, [own](const LongEdge& fence) { return apartDeg(fence.heading, own) < kApartDeg; });
    return beside != fences.end() ? beside->heading : own;
}

PreferredHeading preferEdges(const ScanLine& scanLine, const SwathTask& task, SwathObjective objective,
                             const BestHeading& best) {
    PreferredHeading preferred{.chosen = best};
    const double share = 0.01 * *task.settings.percent(kPreferEdge);
    const std::vector<LongEdge> edges = longEdges(task.field.boundary(), task.machine.operatingWidth());
    const auto along = [&](Angle heading) {
        return BestHeading{heading, scanLine.figures(heading, objective)};
    };
    if (!edges.empty()) {
        preferred.longestEdge = along(edges.front().heading);
    }
    const std::size_t tried = share > 0.0 ? std::min(edges.size(), kMostLongEdges) : 0;
    for (std::size_t i = 0; i < tried; ++i) {
        const Angle heading = edges[i].heading;
        const double offDeg = apartDeg(heading, best.heading);
        if (offDeg < kSameDeg) {
            break;
        }
        if (i > 0 && !mayBeNoWorse(scanLine, heading, objective, best.figures)) {
            continue;
        }
        const BestHeading edge = i == 0 ? *preferred.longestEdge : along(heading);
        if (isNoWorse(objective, edge.figures, best.figures, share)) {
            preferred.chosen = edge;
            preferred.best = offDeg > kUnseenDeg ? std::optional{best} : std::nullopt;
            break;
        }
    }
    return preferred;
}

Result<SwathSet> swathsOfBest(const ScanLine& scanLine, const SwathTask& task, SwathObjective objective,
                              const BestHeading& best, std::vector<BestHeading> tried,
                              const JobContext& job) {
    const PreferredHeading preferred = preferEdges(scanLine, task, objective, best);
    return swathsAlong(scanLine, task, preferred.chosen.heading, objective, job).transform([&](SwathSet set) {
        if (preferred.best) {
            set.notes.push_back(noteOf(preferred, objective));
        }
        if (objective == SwathObjective::Time) {
            tried.push_back(best);
            // The longest edge of the mainland may be another one than that of the field.
            const Angle longest = normalisedSwathHeading(longestEdgeHeading(task));
            std::vector<BestHeading> edges{{longest, scanLine.figures(longest, objective)}};
            if (preferred.longestEdge) {
                edges.insert(edges.begin(), *preferred.longestEdge);
            }
            set.candidates = candidatesOf(std::move(tried), preferred.chosen, edges);
        }
        return set;
    });
}

const Parameter kPreferEdge{
    .key = "swaths.prefer_edge_percent",
    .name = "Prefer edges within (%)",
    .description =
        "Swaths run along the field's longest edge, or another long one, where that takes no more than this "
        "above the best heading; 0 takes the best whatever its direction.",
    .kind = ParameterKind::Percent,
    .standard = 0.5,
    .min = 0.0,
    .max = 100.0,
    .step = 0.5,
    .choices = {}};

}  // namespace furrow
