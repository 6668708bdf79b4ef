#pragma once

#include "planner/settings/method.h"
#include "planner/swaths/objective.h"
#include "planner/swaths/swath.h"

namespace furrow {

/// How much neighbouring swaths overlap.
extern const Parameter kOverlap;
/// What becomes of the width that is left over.
extern const Parameter kLastPass;
extern const Parameter kStep;
extern const Parameter kAngle;
/// Guidance line: A and B, or A alone.
extern const Parameter kLine;
extern const Parameter kEdge;
/// A raster of heights.
extern const Parameter kElevation;
/// A file of rows, where to drive, and which of them not.
extern const Parameter kRows;
extern const Parameter kRowsAt;
extern const Parameter kSkipRows;
/// How much worse than the best a heading along an edge of the field may be to be preferred.
extern const Parameter kPreferEdge;
/// Where swaths end: on the centre line or once the full width is covered.
extern const Parameter kEnds;

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

}  // namespace furrow
