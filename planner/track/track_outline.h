#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/geodesy/local_frame.h"
#include "planner/jobs/job.h"
#include "planner/track/recorded_track.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace furrow {

/// How a recorded track tells where a field is.
enum class TrackKind {
    Round,   ///< it was driven or walked around the field
    Worked,  ///< the field was worked along it
};

/// What the receiver does not record.
struct TrackOutlineOptions {
    /// Nothing: as the track itself tells.
    std::optional<TrackKind> kind;
    /// Operating width, over 0 and up to 100 m. The middle of the implement ran on the recorded line.
    Length width;
    /// Of a track around the field: how far the edge lies outside of the line, -50 to 50 m. Half a width
    /// where the implement ran along the edge.
    Length beyond;
    /// Of worked land: what lies between strips that are not farther apart belongs to the field. 0 to 100 m;
    /// nothing: one width.
    std::optional<Length> gap;
    /// Of worked land: smaller pieces that were driven around belong to the field. Nothing: 100 m², or a
    /// square of one width where that is more.
    std::optional<Area> smallestHole;
    /// Of the plan that was driven, for tracks in its metres.
    std::optional<LocalFrame> frame;
};

/// A boundary that follows from recorded tracks.
struct TrackOutline {
    TrackKind kind = TrackKind::Round;
    std::vector<GeoPolygon> pieces;  ///< that do not touch each other, largest first; at least one
    Area area;                       ///< of all pieces, on the ellipsoid
    std::vector<GeoRing> lines;      ///< the tracks without what was left out
    std::vector<Note> notes;         ///< what was left out, and where
};

/// The boundary of the field that these tracks were recorded on. Positions that jump away and back are left
/// out first, with a note.
///
/// Round: each track that comes back to its beginning (within a twentieth of its way, or two widths) encloses
/// land; where none does, all of them together in their order. A track inside another one is the edge of a
/// hole. Of several rounds the outermost counts, and the way to the field and back is no part of it.
///
/// Worked: the land within half a width of the line, where the implement was down, as far as the recorder
/// tells it; closed over gaps. Without word of the implement, stretches of one strip that are longer than
/// three widths, as the way to the field and back, are left out, with a note. Steps far longer than the
/// others are breaks in the recording, unless much of the way consists of them.
///
/// Without a kind, a track that goes around nothing was worked along. One that does was driven around, unless
/// its strips cover half of the land inside and its way is over 1.6 times as long as the edge.
///
/// @return InputRefused: fewer than 4 positions, positions that jump throughout, no land enclosed (with how
///         much is missing), strips that nowhere lie beside each other, tracks in metres without a frame,
///         options out of range. Each with what to do. Cancelled.
/// Cost: a union of one strip for each bend of the track, GEOS; 2 s for a day of 100,000 positions.
Result<TrackOutline> outlineOfTracks(std::span<const RecordedTrack> tracks,
                                     const TrackOutlineOptions& options, const JobContext& job = {});

/// A field for each piece: `name`, or "name 1", "name 2" ... where there are several.
///
/// @param origin  the recording's file, for messages
std::vector<FieldSource> fieldsOf(const TrackOutline& outline, const std::string& name,
                                  const std::string& origin);

}  // namespace furrow
