#pragma once

// What the readers of recorded drives share.

#include "planner/core/message.h"
#include "planner/core/result.h"
#include "planner/track/recorded_track.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace furrow {

/// A month of positions ten times a second is 26 million; a field day is under a million.
inline constexpr std::size_t kMostTrackSamples = 5'000'000;

Error trackRefused(Message where, Message what, Message remedy);
Error trackDamaged(Message where, Message what);
Error tooManySamples(Message where);

/// From degrees clockwise from north to radians counter-clockwise from east, in [0, 2 pi).
double headingFromBearing(double bearingDeg);
/// "2020-10-26T19:47:55.5Z", with a blank instead of the T, with "+02:00"; without a zone it is UTC.
std::optional<double> utcSeconds(std::string_view text);
/// Days from 1970-01-01 to a date of the Gregorian calendar, in seconds; nothing for no date.
std::optional<double> utcMidnight(int year, unsigned month, unsigned day);
/// Notes what was passed over, unless its count is 0.
void noteSkipped(TrackFile& file, std::size_t count, Message what, const Message& where);

}  // namespace furrow
