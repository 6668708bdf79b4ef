#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/jobs/job.h"
#include "planner/path/path.h"
#include "planner/track/recorded_track.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// Where on the planned path a recorded sample belongs.
struct TrackMatch {
    double sM = 0.0;          ///< way from the start of the path, m
    std::size_t segment = 0;  ///< of the path, from 0
    SegmentKind kind = SegmentKind::Swath;
    Point foot;                ///< the point of the path
    double crossTrackM = 0.0;  ///< from there to the sample, m, positive to the left of the way of driving
};

/// Cross-track error over some of the samples. Quantiles interpolate between ranks (the usual type 7).
struct CrossTrackFigures {
    std::size_t samples = 0;
    Length median;  ///< of the absolute errors, as are the next two
    Length p95;
    Length largest;
    Length mean;                         ///< of the signed errors: a constant shift to one side
    std::optional<Speed> recordedSpeed;  ///< way by time between samples; nothing without times
    std::optional<Speed> plannedSpeed;   ///< of all that was planned of this kind
};

struct KindFigures {
    SegmentKind kind = SegmentKind::Swath;
    CrossTrackFigures figures;
};

struct TrackComparison {
    /// For each track, for each of its samples; nothing where it was too far from the path.
    std::vector<std::vector<std::optional<TrackMatch>>> matches;
    std::size_t samples = 0;
    std::size_t matched = 0;
    CrossTrackFigures overall;
    std::vector<KindFigures> kinds;  ///< those with samples, in the order of SegmentKind

    /// Nothing where no sample of that kind was matched.
    const CrossTrackFigures* of(SegmentKind kind) const;
    double matchedShare() const {
        return samples == 0 ? 0.0 : static_cast<double>(matched) / static_cast<double>(samples);
    }
};

/// Lays recorded tracks over a planned path.
///
/// Each sample has a candidate wherever the distance to the path has a local minimum within the radius, so
/// that a track which crosses other swaths or turns has one on each of them. Of all ways to choose one
/// candidate per sample the cheapest is taken (Viterbi, track by track): distance to the path squared, angle
/// between the way driven and the path, and the difference between the way driven since the sample before
/// and the way along the path between the two candidates. That last cost is bounded: a machine may skip a
/// part, or drive the swaths in another order or direction. The nearest candidate alone would do worse
/// where swaths are crossed. After Newson and Krumm, "Hidden Markov map matching through noise and
/// sparseness", 2009, doi 10.1145/1653771.1653818, with way along the path in place of road distance.
///
/// A shift of more than half the distance between swaths that are driven the same way cannot be told from
/// driving on the neighbour; between swaths driven in opposite directions it can up to two thirds.
/// Samples before the path's start and beyond its end are not matched.
///
/// @param path    at least one sample; positions in `frame`
/// @param radius  > 0; samples farther from the path than that are not matched. One and a half
///                operating widths tell neighbouring swaths apart best
/// @return Cancelled.
/// Cost: O(m + n k²) for m path samples, n recorded ones and k (at most 8) candidates at each; a grid of
/// cells as wide as the radius finds them. Pure; thread-safe.
Result<TrackComparison> compareWithPath(const Path& path, const LocalFrame& frame,
                                        std::span<const RecordedTrack> tracks, Length radius,
                                        const JobContext& job = {});

/// A recording beside a path.
struct LaidTracks {
    std::vector<RecordedTrack> tracks;  ///< those that come near the path at all
    std::vector<Note> notes;            ///< of the file, and of tracks that were left out
    Length radius;                      ///< as used
    TrackComparison comparison;
};

/// Compares what a file holds with a path. Of a recording of several fields or days only those tracks count
/// that come near it. The radius is one and a half widths. Errors: Cancelled. InputRefused: no track comes to
/// the path.
Result<LaidTracks> laidOver(const Path& path, const LocalFrame& frame, const TrackFile& file,
                            Length operatingWidth, const JobContext& job = {});

}  // namespace furrow
