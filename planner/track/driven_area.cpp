#include "planner/track/driven_area.h"

#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

// Shorter ones have no direction.
constexpr double kLeastStepM = 1e-3;
// A longer step is a break in the recording, unless both ends lie on one stretch of the plan.
constexpr double kLongestStepM = 25.0;
constexpr double kLeastPieceM2 = 1.0;

bool wasDown(const TrackSample& sample, const std::optional<TrackMatch>& match) {
    if (sample.implementDown) {
        return *sample.implementDown;
    }
    return match && (match->kind == SegmentKind::Swath || match->kind == SegmentKind::HeadlandPass);
}

Polygon counterClockwise(Ring ring) {
    if (signedAreaM2(ring) < 0.0) {
        std::ranges::reverse(ring);
    }
    return {.outer = std::move(ring), .holes = {}};
}

/// The strips of one track.
void addStrips(MultiPolygon& strips, const RecordedTrack& track, const Ring& places,
               const std::vector<std::optional<TrackMatch>>& matches, double halfM) {
    std::optional<std::pair<Point, Point>> before;  // where the last strip ended, and to its left
    Point from = places.front();
    for (std::size_t i = 1; i < places.size(); ++i) {
        const Point way = places[i] - from;
        const double length = std::hypot(way.x, way.y);
        if (length < kLeastStepM) {
            continue;
        }
        const bool down =
            wasDown(track.samples[i - 1], matches[i - 1]) && wasDown(track.samples[i], matches[i]);
        const bool oneStretch =
            matches[i - 1] && matches[i] && matches[i - 1]->segment == matches[i]->segment;
        if (!down || (length > kLongestStepM && !oneStretch)) {
            before.reset();
            from = places[i];
            continue;
        }
        const Point left{-way.y * halfM / length, way.x * halfM / length};
        strips.push_back(counterClockwise({from + left, from - left, places[i] - left, places[i] + left}));
        if (before) {
            for (const double side : {1.0, -1.0}) {
                Polygon wedge = counterClockwise({from, from + side * before->second, from + side * left});
                if (std::abs(signedAreaM2(wedge.outer)) > 1e-6) {
                    strips.push_back(std::move(wedge));
                }
            }
        }
        before = std::pair{places[i], left};
        from = places[i];
    }
}

}  // namespace

Result<DrivenArea> drivenArea(const MultiPolygon& workable, std::span<const RecordedTrack> tracks,
                              std::span<const Ring> places, const TrackComparison& matches, Length width,
                              const JobContext& job) {
    MultiPolygon strips;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        if (!places[i].empty()) {
            addStrips(strips, tracks[i], places[i], matches.matches[i], 0.5 * width.si());
        }
    }
    const auto worked = unionOf(strips, job.part(0.0, 0.7), kSnapGrid);
    if (!worked) {
        return std::unexpected(worked.error());
    }
    auto missed = difference(workable, *worked, job.part(0.7, 1.0), kSnapGrid);
    if (!missed) {
        return std::unexpected(missed.error());
    }
    DrivenArea driven{.covered = area(workable) - area(*missed), .missed = area(*missed), .places = {}};
    std::erase_if(*missed, [](const Polygon& piece) { return area(piece).si() < kLeastPieceM2; });
    std::ranges::sort(*missed, std::ranges::greater{}, [](const Polygon& piece) { return area(piece); });
    driven.places = *std::move(missed);
    return driven;
}

}  // namespace furrow
