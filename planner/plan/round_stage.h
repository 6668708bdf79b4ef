#pragma once

#include "planner/plan/swath_stage.h"

#include <span>
#include <vector>

namespace furrow {

/// The largest size of obstacles that swaths go round.
extern const Parameter kRoundUpTo;

/// The given size, or the operating width, at least 1.5 m.
Length roundUpTo(const Settings& settings, const Machine& machine);

/// The obstacles that lie inside a mainland, clear of the headland passes beside it.
std::vector<Ring> insideMainland(const std::vector<Ring>& obstacles, const MultiPolygon& mainland,
                                 Length margin, const Machine& machine);

/// Leads swaths round obstacles that headland and swaths were laid without, and measures their coverage
/// again. If swaths cannot get round an obstacle, it is refused: the headland has to be laid again, round it.
/// Cancelled.
Result<RoundedSwaths> roundStage(LaidSwaths laid, std::span<const Ring> obstacles, const LayTask& task,
                                 const JobContext& job);

/// Polygons without the obstacles that swaths go round. Cancelled.
Result<MultiPolygon> withoutGoneRound(const MultiPolygon& polygons, const SwathSet& swaths,
                                      const JobContext& job);

/// The obstacles that swaths go round, without those close to a blocking finding. All of them if none is
/// close.
std::vector<Ring> awayFromBlocking(const SwathSet& swaths, std::span<const Finding> findings,
                                   const Machine& machine);

}  // namespace furrow
