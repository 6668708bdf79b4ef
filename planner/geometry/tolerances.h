#pragma once

namespace furrow {

// How near is near enough, each value once and why it is that large. In metres, for planar geometry; data
// from files have tolerances of their own where they are read.

/// One place that two calculations give: the rounding of doubles at some kilometres from the origin is a
/// thousand times less.
inline constexpr double kRoundingM = 1e-9;

/// The same for stretches of offset guide lines, whose radii of some kilometres lose one more digit.
inline constexpr double kOffsetRoundingM = 1e-8;

/// Lines that begin where others end: what passes and ways add up over some hundred pieces. Nothing is
/// steered as finely.
inline constexpr double kMeetM = 1e-6;

/// A footprint that touches an edge is not beyond it. Chords of arcs and steps between samples are drawn
/// within this.
inline constexpr double kContactM = 1e-3;

/// The same for tracks of headland passes, so that a pass that just touches is inside for every check that
/// allows kContactM.
inline constexpr double kTrackContactM = 8e-4;

/// A machine gets through a neck of its own width: this much of it may be missing in the drawn boundary.
inline constexpr double kNeckContactM = 0.02;

}  // namespace furrow
