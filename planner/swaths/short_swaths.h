#pragma once

#include "planner/swaths/swath.h"

#include <vector>

namespace furrow {

/// Below which length no swath is worth lowering the implement for.
extern const Parameter kMinLength;

/// As given; otherwise the implement's length.
Length minSwathLength(const Settings& settings, const Machine& machine);

/// Which swaths of a set are shorter than that. None where all are: then nothing better exists.
std::vector<bool> shortOnes(const SwathSet& set, Length least);

/// Takes swaths out of a set, and out of its coverage and overlap what only they covered and covered twice; says so in
/// a note. The others are numbered anew. Cost: a few GEOS operations with the lanes near the ones that go. Cancelled.
///
/// @param set  with flat ends, as its figures are
Result<void> leaveOut(const std::vector<bool>& shortOnes, Length least, const MultiPolygon& mainland, SwathSet& set,
                      const JobContext& job);

}  // namespace furrow
