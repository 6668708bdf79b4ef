#pragma once

#include "planner/swaths/scan_line.h"

#include <optional>
#include <span>

namespace furrow {

/// Width, overlap and last pass from the settings. With an anchor, one of the tracks runs through that point.
/// InputRefused: the overlap is not below the operating width.
Result<SwathSpacing> spacingFor(const SwathTask& task, std::optional<Point> anchor = {});

/// Of one plan: twice what the narrowest machine makes of the largest fields.
inline constexpr std::size_t kMostSwaths = 10'000;

/// Told before the work begins. InputRefused: a land so broad would get over 10,000 tracks.
Result<void> checkTrackCount(const SwathSpacing& spacing, Length across);

/// Not one swath fits into the mainland.
Error noSwathFits();

/// The scan line for this task. With an anchor, one of its tracks runs through that point. InputRefused: the
/// overlap is not below the operating width, or the width would give over 10,000 tracks.
Result<ScanLine> scanLineFor(const SwathTask& task, std::optional<Point> anchor = {});

/// The best of some headings. All are tried in parallel. Of equal ones the first is kept, for any thread
/// count. Cancelled. Cost: one ScanLine::figures for each heading.
struct BestHeading {
    Angle heading;
    HeadingFigures figures;
};
Result<BestHeading> bestHeading(const ScanLine& scanLine, std::span<const Angle> headings,
                                SwathObjective objective, const JobContext& job);

/// The swaths of one heading as a method's result. InputRefused: no swath fits. Cancelled.
Result<SwathSet> swathsAlong(const ScanLine& scanLine, const SwathTask& task, Angle heading,
                             SwathObjective objective, const JobContext& job);

}  // namespace furrow
