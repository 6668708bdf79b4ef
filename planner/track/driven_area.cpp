#include "planner/track/driven_area.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/track/driven_strips.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

// A longer step is a break in the recording, unless both ends lie on one stretch of the plan.
constexpr double kLongestStepM = 25.0;
constexpr double kLeastMissedM2 = 1.0;

bool wasDown(const TrackSample& sample, const std::optional<TrackMatch>& match) {
    if (sample.implementDown) {
        return *sample.implementDown;
    }
    return match && (match->kind == SegmentKind::Swath || match->kind == SegmentKind::HeadlandPass);
}

/// The strips of one track.
void addStrips(MultiPolygon& strips, const RecordedTrack& track, const Ring& places,
               const std::vector<std::optional<TrackMatch>>& matches, double halfM) {
    Polyline worked{places.front()};  // without a break
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double length = distance(worked.back(), places[i]);
        if (length < kShortestStepM) {
            continue;
        }
        const bool down =
            wasDown(track.samples[i - 1], matches[i - 1]) && wasDown(track.samples[i], matches[i]);
        const bool oneStretch =
            matches[i - 1] && matches[i] && matches[i - 1]->segment == matches[i]->segment;
        if (!down || (length > kLongestStepM && !oneStretch)) {
            addStripsAlong(strips, worked, halfM);
            worked.clear();
        }
        worked.push_back(places[i]);
    }
    addStripsAlong(strips, worked, halfM);
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
    std::erase_if(*missed, [](const Polygon& piece) { return area(piece).si() < kLeastMissedM2; });
    std::ranges::sort(*missed, std::ranges::greater{}, [](const Polygon& piece) { return area(piece); });
    driven.places = *std::move(missed);
    return driven;
}

}  // namespace furrow
