#pragma once

#include "planner/io/content/format_parts.h"

#include <string>
#include <string_view>

namespace furrow {

/// A gpsd JSON log (TPV) or an NMEA 0183 log (RMC, or GGA where there is none), by its first lines.
FormatRecogniser recogniseLog;
TrackReader readLog;

/// The same of the text itself; `where` names it in messages.
Result<TrackFile> gpsdTracks(std::string_view text, const std::string& where, const JobContext& job);
Result<TrackFile> nmeaTracks(std::string_view text, const std::string& where, const JobContext& job);

/// Whether the text looks like one of these, told by its first kilobytes.
bool looksLikeGpsd(std::string_view start);
bool looksLikeNmea(std::string_view start);
/// Whether there is a position among its bytes whose checksum is right, whatever stands before it.
bool holdsNmea(std::string_view start);

}  // namespace furrow
