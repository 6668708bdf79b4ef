#pragma once

#include "planner/settings/method.h"
#include "planner/swaths/objective.h"
#include "planner/swaths/swath.h"

#include <array>

namespace furrow {

/// The overlap of neighbouring swaths.
extern const Parameter kOverlap;
/// The treatment of the remaining width.
extern const Parameter kLastPass;
extern const Parameter kStep;
extern const Parameter kAngle;
/// Guidance line: A and B, or A alone.
extern const Parameter kLine;
extern const Parameter kEdge;
/// A raster of heights.
extern const Parameter kElevation;
/// A file of rows, the place to drive, and the rows to skip.
extern const Parameter kRows;
extern const Parameter kRowsAt;
extern const Parameter kSkipRows;
/// How much worse than the best heading a preferred edge may be.
extern const Parameter kPreferEdge;
/// The ends of swaths: at the centre line, or where the full width is covered.
extern const Parameter kEnds;
/// Whether swaths go beyond a slanting edge, as far as it takes to work all of their width.
bool drawsOutEnds(const Settings& settings);

extern const Method<SwathGenerator> kExactMethod;
extern const Method<SwathGenerator> kBruteForceMethod;
extern const Method<SwathGenerator> kFixedHeadingMethod;
extern const Method<SwathGenerator> kAbLineMethod;
extern const Method<SwathGenerator> kAPlusMethod;
extern const Method<SwathGenerator> kLongestEdgeMethod;
extern const Method<SwathGenerator> kEdgeMethod;
extern const Method<SwathGenerator> kOksanenMethod;
extern const Method<SwathGenerator> kAbCurveMethod;
extern const Method<SwathGenerator> kPivotMethod;
extern const Method<SwathGenerator> kContourMethod;
extern const Method<SwathGenerator> kRowsMethod;

/// Every method of the stage, the default first.
inline constexpr std::array kSwathMethods{
    &kExactMethod,
    &kBruteForceMethod,
    &kFixedHeadingMethod,
    &kAbLineMethod,
    &kAPlusMethod,
    &kLongestEdgeMethod,
    &kEdgeMethod,
    &kOksanenMethod,
    // curves
    &kAbCurveMethod,
    &kContourMethod,
    &kPivotMethod,
    &kRowsMethod,
};

}  // namespace furrow
