#include "planner/track/comparison.h"

#include "planner/track/path_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace furrow {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The costs, all relative to each other. A sample a fifth of the radius beside the path costs 1; driving
// against the path's direction costs 4, at right angles 2; jumping to elsewhere on the path costs 8, once.
// With a radius of one and a half operating widths w, a sample between two swaths that are driven in
// opposite directions belongs to the one with its direction up to 0.68 w from it, while a swath that was
// driven the wrong way round is still itself (4 < 11, the cost of its neighbour).
constexpr double kScaleOfRadius = 0.2;
constexpr double kDirectionCost = 2.0;
constexpr double kJumpCost = 8.0;
// Way along the path and way driven differ by noise, and by the arc that sparse samples cut short.
constexpr double kWayNoiseM = 1.0;
constexpr double kWayNoiseShare = 0.25;

// Below this the direction between samples is noise of the receiver.
constexpr double kShortestCourseM = 0.2;
// A longer step is a pause or a break of the recording, unless the machine drove on meanwhile.
constexpr double kLongestStepS = 30.0;
constexpr double kSlowestDrivingMps = 0.5;

constexpr std::size_t kMostCandidates = 8;

struct Candidate {
    std::uint32_t edge = 0;
    std::int16_t before = -1;  ///< of the sample before, its chosen candidate; -1: a new beginning
};

struct Scored {
    std::uint32_t edge = 0;
    Foot foot;
};

class Matcher {
public:
    Matcher(std::vector<PathEdge> edges, const Path& path, double radiusM)
        : edges_{std::move(edges)}, path_{path}, radiusM_{radiusM}, grid_{edges_, radiusM} {}

    Result<std::vector<std::optional<TrackMatch>>> match(const RecordedTrack& track, const Ring& places,
                                                         const JobContext& job) {
        candidates_.clear();
        std::vector<std::size_t> begin{0};
        std::vector<double> costs;
        std::vector<Scored> before;
        std::vector<std::size_t> chainEnds(places.size(), SIZE_MAX);
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (i % 1024 == 0 && job.stopRequested()) {
                return std::unexpected(cancelled());
            }
            const std::vector<Scored> now = candidatesAt(places[i]);
            const double moved = i == 0 ? 0.0 : distance(places[i - 1], places[i]);
            const Course course = courseAt(places, i);
            std::vector<double> nowCosts;
            for (const Scored& scored : now) {
                double best = before.empty() ? 0.0 : kInfinity;
                int from = -1;
                for (std::size_t k = 0; k < before.size(); ++k) {
                    const double cost = costs[k] + stepCost(before[k], scored, moved);
                    if (cost < best) {
                        best = cost;
                        from = static_cast<int>(k);
                    }
                }
                nowCosts.push_back(best + placeCost(scored, course, track.samples[i]));
                candidates_.push_back({scored.edge, static_cast<std::int16_t>(from)});
            }
            begin.push_back(candidates_.size());
            // Where a chain ends, its cheapest candidate says where it came from.
            if (now.empty() && !before.empty()) {
                chainEnds[i - 1] = cheapest(costs);
            }
            // Costs only matter relative to each other; kept small, they never lose their digits.
            if (!nowCosts.empty()) {
                const double least = std::ranges::min(nowCosts);
                std::ranges::for_each(nowCosts, [least](double& cost) { cost -= least; });
            }
            before = now;
            costs = std::move(nowCosts);
        }
        if (!before.empty()) {
            chainEnds[places.size() - 1] = cheapest(costs);
        }
        return traced(places, begin, chainEnds);
    }

private:
    static std::size_t cheapest(const std::vector<double>& costs) {
        return static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin());
    }

    /// One for each local minimum of the distance along the path, nearest first, then in driving order.
    std::vector<Scored> candidatesAt(Point place) {
        near_.clear();
        grid_.near(place, [this](std::uint32_t edge) { near_.push_back(edge); });
        std::ranges::sort(near_);
        near_.erase(std::ranges::unique(near_).begin(), near_.end());
        feet_.clear();
        for (const std::uint32_t edge : near_) {
            if (const Foot foot = footOn(edges_[edge], place); foot.offM <= radiusM_) {
                feet_.push_back({edge, foot});
            }
        }
        std::vector<Scored> found;
        for (std::size_t i = 0; i < feet_.size(); ++i) {
            const bool farAfter = i + 1 == feet_.size() || feet_[i + 1].edge != feet_[i].edge + 1 ||
                                  feet_[i].foot.offM <= feet_[i + 1].foot.offM;
            const bool farBefore = i == 0 || feet_[i - 1].edge + 1 != feet_[i].edge ||
                                   feet_[i].foot.offM < feet_[i - 1].foot.offM;
            if (farAfter && farBefore) {
                found.push_back(feet_[i]);
            }
        }
        if (found.size() > kMostCandidates) {
            std::ranges::stable_sort(found, {}, [](const Scored& scored) { return scored.foot.offM; });
            found.resize(kMostCandidates);
            std::ranges::sort(found, {}, &Scored::edge);
        }
        return found;
    }

    /// Unit vectors of the way driven around a sample. Where the machine changes gear there are two, to the
    /// sample and on from it: what lies between them is nobody's course.
    struct Course {
        std::optional<Point> onward;  ///< nothing where the machine hardly moved
        std::optional<Point> before;
    };

    static std::optional<Point> unit(Point step, double shortestM) {
        const double length = norm(step);
        return length >= shortestM && std::isfinite(length) ? std::optional{(1.0 / length) * step}
                                                            : std::nullopt;
    }

    static Course courseAt(const Ring& places, std::size_t i) {
        // Where one segment of a plan ends and the next begins its place is there twice.
        const std::size_t last = places.size() - 1;
        Point before = places[i] - places[i - std::min<std::size_t>(i, 1)];
        if (before == Point{}) {
            before = places[i] - places[i - std::min<std::size_t>(i, 2)];
        }
        Point after = places[std::min(i + 1, last)] - places[i];
        if (after == Point{}) {
            after = places[std::min(i + 2, last)] - places[i];
        }
        if (dot(before, after) < 0.0 && std::max(norm(before), norm(after)) >= kShortestCourseM) {
            return {.onward = unit(after, 0.0), .before = unit(before, 0.0)};
        }
        return {.onward = unit(before + after, kShortestCourseM), .before = std::nullopt};
    }

    double placeCost(const Scored& scored, const Course& course, const TrackSample& sample) const {
        const PathEdge& edge = edges_[scored.edge];
        const double off = scored.foot.offM / (kScaleOfRadius * radiusM_);
        double cost = off * off;
        if (course.onward) {
            double along = dot(*course.onward, edge.along);
            if (course.before) {
                along = std::max(along, dot(*course.before, edge.along));
            }
            cost += kDirectionCost * (1.0 - along);
        } else if (sample.headingRad) {
            // Standing, the nose says where it would drive; backwards in reverse gear.
            const double way = path_.segments[edge.segment].gear == Gear::Reverse ? -1.0 : 1.0;
            cost += kDirectionCost * (1.0 - way * dot(direction(*sample.headingRad), edge.along));
        }
        return cost;
    }

    double sOf(const Scored& scored) const {
        const PathEdge& edge = edges_[scored.edge];
        return edge.sM + scored.foot.alongM * edge.sPerM;
    }

    double stepCost(const Scored& from, const Scored& to, double moved) const {
        const double difference = std::abs(std::abs(sOf(to) - sOf(from)) - moved);
        return std::min(kJumpCost, difference / (kWayNoiseM + kWayNoiseShare * moved));
    }

    std::vector<std::optional<TrackMatch>> traced(const Ring& places, const std::vector<std::size_t>& begin,
                                                  const std::vector<std::size_t>& chainEnds) const {
        std::vector<std::optional<TrackMatch>> matches(places.size());
        int chosen = -1;
        for (std::size_t i = places.size(); i-- > 0;) {
            if (chainEnds[i] != SIZE_MAX) {
                chosen = static_cast<int>(chainEnds[i]);
            }
            if (chosen < 0 || begin[i] == begin[i + 1]) {
                chosen = -1;
                continue;
            }
            const Candidate& candidate = candidates_[begin[i] + static_cast<std::size_t>(chosen)];
            matches[i] = matchOn(candidate.edge, places[i]);
            chosen = candidate.before;
        }
        return matches;
    }

    TrackMatch matchOn(std::uint32_t index, Point place) const {
        const PathEdge& edge = edges_[index];
        const Foot foot = footOn(edge, place);
        const Point at = edge.from + foot.alongM * edge.along;
        return {.sM = edge.sM + foot.alongM * edge.sPerM,
                .segment = edge.segment,
                .kind = path_.segments[edge.segment].kind,
                .foot = at,
                .crossTrackM = std::copysign(foot.offM, cross(edge.along, place - at))};
    }

    std::vector<PathEdge> edges_;
    const Path& path_;
    double radiusM_;
    PathEdgeGrid grid_;
    std::vector<Candidate> candidates_;
    std::vector<std::uint32_t> near_;
    std::vector<Scored> feet_;
};

/// Between the ranks around it, as R's type 7 and numpy do.
double quantile(const std::vector<double>& sorted, double share) {
    const double rank = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Collects the samples of one kind.
class Sum {
public:
    void add(double crossTrackM) { errors_.push_back(crossTrackM); }
    void addStep(double wayM, double timeS) {
        wayM_ += wayM;
        timeS_ += timeS;
    }

    CrossTrackFigures figures(Length planned, Duration duration) const {
        CrossTrackFigures figures;
        figures.samples = errors_.size();
        if (!errors_.empty()) {
            std::vector<double> sorted;
            double total = 0.0;
            for (const double error : errors_) {
                sorted.push_back(std::abs(error));
                total += error;
            }
            std::ranges::sort(sorted);
            figures.median = metres(quantile(sorted, 0.5));
            figures.p95 = metres(quantile(sorted, 0.95));
            figures.largest = metres(sorted.back());
            figures.mean = metres(total / static_cast<double>(errors_.size()));
        }
        if (timeS_ > 0.0) {
            figures.recordedSpeed = metresPerSecond(wayM_ / timeS_);
        }
        if (duration > seconds(0.0)) {
            figures.plannedSpeed = metresPerSecond(planned.si() / duration.si());
        }
        return figures;
    }

    bool empty() const { return errors_.empty(); }

private:
    std::vector<double> errors_;
    double wayM_ = 0.0;
    double timeS_ = 0.0;
};

constexpr std::array kKinds = {SegmentKind::Swath,    SegmentKind::Turn,   SegmentKind::HeadlandPass,
                               SegmentKind::Transfer, SegmentKind::Refill, SegmentKind::Wait};

/// The time of a step that tells of driving.
std::optional<double> stepS(const TrackSample& before, const TrackSample& now, double wayM) {
    if (!before.timeS || !now.timeS) {
        return std::nullopt;
    }
    const double step = *now.timeS - *before.timeS;
    const bool driving = step <= kLongestStepS || wayM >= kSlowestDrivingMps * step;
    return step > 0.0 && driving ? std::optional{step} : std::nullopt;
}

}  // namespace

const CrossTrackFigures* TrackComparison::of(SegmentKind kind) const {
    const auto found = std::ranges::find(kinds, kind, &KindFigures::kind);
    return found == kinds.end() ? nullptr : &found->figures;
}

Result<TrackComparison> compareWithPath(const Path& path, const LocalFrame& frame,
                                        std::span<const RecordedTrack> tracks, Length radius,
                                        const JobContext& job) {
    TrackComparison comparison;
    std::vector<PathEdge> edges = edgesOf(path);
    const bool comparable = !edges.empty();
    Sum overall;
    std::array<Sum, kKinds.size()> sums;
    std::optional<Matcher> matcher;
    if (comparable) {
        matcher.emplace(std::move(edges), path, radius.si());
    }
    for (const RecordedTrack& track : tracks) {
        comparison.samples += track.samples.size();
        if (!matcher || track.samples.empty()) {
            comparison.matches.emplace_back(track.samples.size());
            continue;
        }
        const Ring places = placesIn(frame, track);
        auto matches = matcher->match(track, places, job);
        if (!matches) {
            return std::unexpected(matches.error());
        }
        for (std::size_t i = 0; i < matches->size(); ++i) {
            if (!(*matches)[i]) {
                continue;
            }
            const TrackMatch& match = *(*matches)[i];
            Sum& sum = sums[static_cast<std::size_t>(match.kind)];
            ++comparison.matched;
            overall.add(match.crossTrackM);
            sum.add(match.crossTrackM);
            if (i > 0 && (*matches)[i - 1]) {
                const double way = distance(places[i - 1], places[i]);
                if (const auto step = stepS(track.samples[i - 1], track.samples[i], way)) {
                    overall.addStep(way, *step);
                    sum.addStep(way, *step);
                }
            }
        }
        comparison.matches.push_back(std::move(*matches));
    }
    comparison.overall = overall.figures(path.length(), path.duration());
    for (const SegmentKind kind : kKinds) {
        const Sum& sum = sums[static_cast<std::size_t>(kind)];
        if (!sum.empty()) {
            comparison.kinds.push_back({kind, sum.figures(path.length(kind), path.duration(kind))});
        }
    }
    return comparison;
}

namespace {

// Tells neighbouring swaths apart best.
constexpr double kRadiusInWidths = 1.5;

std::vector<RecordedTrack> tracksNear(const Path& path, const LocalFrame& frame,
                                      const std::vector<RecordedTrack>& tracks, Length radius) {
    Ring all;
    for (const PathSegment& segment : path.segments) {
        std::ranges::transform(segment.samples, std::back_inserter(all), &PathSample::position);
    }
    const Bounds room = widened(bounds(all), radius.si());
    std::vector<RecordedTrack> near;
    std::ranges::copy_if(tracks, std::back_inserter(near), [&](const RecordedTrack& track) {
        return std::ranges::any_of(placesIn(frame, track),
                                   [&](Point place) { return contains(room, place); });
    });
    return near;
}

}  // namespace

Result<LaidTracks> laidOver(const Path& path, const LocalFrame& frame, const TrackFile& file,
                            Length operatingWidth, const JobContext& job) {
    const Length radius = kRadiusInWidths * operatingWidth;
    LaidTracks laid{.tracks = tracksNear(path, frame, file.tracks, radius),
                    .notes = file.notes,
                    .radius = radius,
                    .comparison = {}};
    auto comparison = compareWithPath(path, frame, laid.tracks, radius, job);
    if (!comparison) {
        return std::unexpected(comparison.error());
    }
    if (comparison->matched == 0) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "the track does not come to the plan anywhere",
                                     .where = {},
                                     .remedy = "give a plan and a track of the same field"});
    }
    if (laid.tracks.size() < file.tracks.size()) {
        laid.notes.push_back({.text = message("{} of {} tracks are of another place and were left out",
                                              file.tracks.size() - laid.tracks.size(), file.tracks.size()),
                              .where = {}});
    }
    laid.comparison = *std::move(comparison);
    return laid;
}

}  // namespace furrow
