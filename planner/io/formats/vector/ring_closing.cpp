#include "planner/io/formats/vector/ring_closing.h"

#include "planner/io/content/geo_ring.h"

#include <cstddef>
#include <utility>

namespace furrow {

namespace {

// A track that comes back to within this share of its length was driven round something.
constexpr double kRoundTripShare = 0.05;

double lengthM(const GeoRing& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        sum += roughDistanceM(line[i - 1], line[i]);
    }
    return sum;
}

}  // namespace

std::optional<Note> noteOfOpenRings(const VectorFeature& feature, Message where) {
    const std::size_t count = feature.openRings.size();
    if (count == 0) {
        return std::nullopt;
    }
    return Note{.text = counted("{} ring did not end where it began and was closed",
                                "{} rings did not end where they began and were closed", count),
                .where = std::move(where),
                .place = feature.openRings.front()};
}

void closeLines(VectorFeature& feature) {
    for (GeoRing& line : feature.closedLines) {
        feature.polygons.push_back({.outer = std::move(line), .holes = {}});
    }
    feature.closedLines.clear();
}

void closeTracks(VectorFeature& feature, std::vector<Note>& notes, const std::string& name) {
    constexpr std::size_t kFewestPoints = 8;
    std::erase_if(feature.openLines, [&](GeoRing& line) {
        const double gap = line.size() < kFewestPoints ? 0.0 : roughDistanceM(line.front(), line.back());
        if (line.size() < kFewestPoints || gap > kRoundTripShare * lengthM(line)) {
            return false;
        }
        notes.push_back(
            {message("a track that ended {:.1f} m from where it began was closed", gap), name, line.front()});
        feature.polygons.push_back({.outer = std::move(line), .holes = {}});
        return true;
    });
}

}  // namespace furrow
