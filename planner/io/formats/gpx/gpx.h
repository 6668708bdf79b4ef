#pragma once

#include "planner/io/content/format_parts.h"

#include <string>
#include <string_view>

namespace furrow {

/// path.gpx (version 1.1): the path as a track with a segment between two changes of gear, a route with a
/// point at each end of each swath, gates as waypoints. Fields alone are tracks that end where they begin.
FormatWriter writeGpx;
ContentFinder findGpx;

FormatRecogniser recogniseGpxTracks;
TrackReader readGpxTracks;

/// The same of the text itself; `where` names it in messages.
Result<TrackFile> gpxTracks(std::string_view text, const std::string& where, const JobContext& job);

}  // namespace furrow
