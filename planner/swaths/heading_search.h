#pragma once

#include "planner/swaths/scan_line.h"

#include <span>
#include <string_view>

namespace furrow {

/// What makes one heading better than another; the paper's three.
enum class SwathObjective { Count, Length, Coverage };

/// Whether a is strictly better than b; ties are broken by coverage, then by fewer metres.
bool isBetter(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b);

/// The scan line for these settings. InputRefused: the overlap is not below the operating width, or the
/// width is so small that there would be over a million tracks.
Result<ScanLine> scanLineFor(const MultiPolygon& mainland, const Machine& machine, const Settings& settings);

/// The objective that the settings name.
SwathObjective objectiveOf(const Settings& settings);

/// Tries all headings in parallel; of equally good ones the first is kept, whatever the thread count.
/// Cancelled. Cost: one ScanLine::figures for each heading.
Result<Angle> bestHeading(const ScanLine& scanLine, std::span<const Angle> headings, SwathObjective objective,
                          const JobContext& job);

/// The swaths of one heading as a method's result. InputRefused: not one fits.
Result<SwathSet> swathsAlong(const ScanLine& scanLine, Angle heading);

}  // namespace furrow
