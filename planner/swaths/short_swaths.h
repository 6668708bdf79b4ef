#pragma once

#include "planner/swaths/swath.h"

#include <vector>

namespace furrow {

/// A shorter swath is not worth lowering the implement for.
extern const Parameter kMinLength;

/// The given length, or else the implement's length.
Length minSwathLength(const Settings& settings, const Machine& machine);

/// Marks the swaths of a set that are shorter. Marks none if all are: then nothing better exists.
std::vector<bool> shortOnes(const SwathSet& set, Length least);

/// Takes swaths out of a set. Coverage and overlap lose the area that only these swaths covered, or covered
/// twice. Adds a note. The others are numbered anew. Cost: a few GEOS operations with the lanes near the
/// removed ones. Cancelled.
///
/// @param set  with flat ends, like its figures
Result<void> leaveOut(const std::vector<bool>& shortOnes, Length least, const MultiPolygon& mainland,
                      SwathSet& set, const JobContext& job);

}  // namespace furrow
