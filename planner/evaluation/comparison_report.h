#pragma once

#include "planner/io/plan_files/written_path.h"
#include "planner/track/comparison.h"
#include "planner/track/recorded_track.h"

#include <span>
#include <string>

namespace furrow {

/// The contents of a report about a comparison. Refers to its sources.
struct ComparisonReport {
    const WrittenPath& plan;
    std::string format;  ///< of the track's file
    std::span<const RecordedTrack> tracks;
    const TrackComparison& comparison;
    std::span<const Note> notes;
    Length radius;
};

/// One row for each recorded sample, with a header. Unknown values are empty cells.
std::string comparisonCsv(const ComparisonReport& report);

/// The recorded track over the plan, coloured by its distance from it.
std::string comparisonSvg(const ComparisonReport& report);

/// One JSON object; figures in metres and metres per second.
std::string comparisonJson(const ComparisonReport& report);

/// A table for people.
std::string comparisonText(const ComparisonReport& report);

}  // namespace furrow
