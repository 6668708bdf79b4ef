#pragma once

#include "planner/core/error.h"
#include "planner/core/geo_point.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/units/quantity.h"

#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// What the places of a track are given in.
enum class TrackPlaces {
    Wgs84,  ///< longitude and latitude
    Local,  ///< metres in the frame of the plan that was driven, x to the east, y to the north
};

/// One recorded instant. What the recorder did not say is left out.
struct TrackSample {
    GeoPoint geo;                       ///< where the track is in WGS84
    Point local;                        ///< where the track is in local metres
    std::optional<double> timeS;        ///< UTC since 1970, s; of files without a date, since their start
    std::optional<double> speedMps;     ///< over ground, not negative
    std::optional<double> headingRad;   ///< counter-clockwise from east, in [0, 2 pi)
    std::optional<bool> implementDown;  ///< at work

    friend bool operator==(const TrackSample&, const TrackSample&) = default;
};

/// A machine's way without a break, as a receiver, a terminal or a robot recorded it. Every place is finite
/// and, in WGS84, in its ranges; times may stand still or jump.
struct RecordedTrack {
    std::string source;  ///< "field.gpx, segment 2", "TLG00001 (Plant crop)"
    TrackPlaces places = TrackPlaces::Wgs84;
    std::vector<TrackSample> samples;

    friend bool operator==(const RecordedTrack&, const RecordedTrack&) = default;
};

/// A file of tracks, in the order of recording, and what should be known about the reading of it.
struct TrackFile {
    std::string format;  ///< "GPX", "ISOXML time log", "rosbag2 (MCAP)" ...
    std::vector<RecordedTrack> tracks;
    std::vector<Note> notes;

    std::size_t sampleCount() const;
};

/// The places in a plan's frame. Cost: linear, through PROJ where they are in WGS84.
Ring placesIn(const LocalFrame& frame, const RecordedTrack& track);

/// Way from sample to sample. Cost: linear.
Length lengthOf(const RecordedTrack& track);

}  // namespace furrow
