#include "planner/track/recorded_track.h"

namespace furrow {

std::size_t TrackFile::sampleCount() const {
    std::size_t count = 0;
    for (const RecordedTrack& track : tracks) {
        count += track.samples.size();
    }
    return count;
}

Ring placesIn(const LocalFrame& frame, const RecordedTrack& track) {
    if (track.places == TrackPlaces::Local) {
        Ring places;
        places.reserve(track.samples.size());
        for (const TrackSample& sample : track.samples) {
            places.push_back(sample.local);
        }
        return places;
    }
    GeoRing places;
    places.reserve(track.samples.size());
    for (const TrackSample& sample : track.samples) {
        places.push_back(sample.geo);
    }
    return frame.toLocal(places);
}

Length lengthOf(const RecordedTrack& track) {
    if (track.samples.empty()) {
        return metres(0.0);
    }
    const auto frame = LocalFrame::centredOn(track.samples.front().geo);
    return frame ? metres(lengthM(placesIn(*frame, track))) : metres(0.0);
}

}  // namespace furrow
