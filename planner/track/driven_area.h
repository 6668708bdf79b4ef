#pragma once

#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/track/comparison.h"

#include <span>

namespace furrow {

/// What a recorded drive worked of a field.
struct DrivenArea {
    Area covered;         ///< of the workable area
    Area missed;          ///< of the workable area
    MultiPolygon places;  ///< those missed, pieces of 1 m² and more, largest first
};

/// The land that an implement of this width passed over with its middle on the recorded line, between
/// samples where it was down. Where the recorder does not say so, it was down where the sample belongs to a
/// swath or a headland pass of the plan. Between two samples the line is straight; more than 25 m between
/// two samples that do not lie on one stretch of the plan are a break in the recording. What lies between the
/// strips of a bend counts as worked.
///
/// @param places   of each track, as placesIn has them
/// @param matches  of the same tracks
/// @param width    > 0
/// Cost: a union of one strip for each sample, GEOS; a second for 10,000 samples. Cancelled.
Result<DrivenArea> drivenArea(const MultiPolygon& workable, std::span<const RecordedTrack> tracks,
                              std::span<const Ring> places, const TrackComparison& matches, Length width,
                              const JobContext& job = {});

}  // namespace furrow
