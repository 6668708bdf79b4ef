#include "planner/io/check/read_back.h"

#include "planner/geodesy/local_frame.h"
#include "planner/io/content/geo_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

constexpr double kSlackM2 = 1.0;
constexpr double kReadAreaShare = 0.001;
constexpr double kPlaceM = 0.1;

/// Same area, and corners of the one beside the other.
bool sameOutline(const GeoRing& meant, const GeoRing& read) {
    const Area wanted = geodesicArea({.outer = meant, .holes = {}});
    const Area got = geodesicArea({.outer = read, .holes = {}});
    if (std::abs((wanted - got).si()) > kSlackM2 + kReadAreaShare * wanted.si()) {
        return false;
    }
    // Each corner that was meant is among those read; a few are enough to tell fields apart.
    constexpr std::size_t kCornersTried = 16;
    const std::size_t step = std::max<std::size_t>(1, meant.size() / kCornersTried);
    for (std::size_t i = 0; i < meant.size(); i += step) {
        const bool there = std::ranges::any_of(
            read, [corner = meant[i]](GeoPoint point) { return roughDistanceM(point, corner) < kPlaceM; });
        if (!there) {
            return false;
        }
    }
    return true;
}

bool isThere(const GeoRing& hole, const std::vector<const FieldContent*>& fields) {
    return std::ranges::any_of(fields, [&hole](const FieldContent* content) {
        const bool asHole = std::ranges::any_of(content->field.parts, [&hole](const GeoPolygon& part) {
            return std::ranges::any_of(part.holes,
                                       [&hole](const GeoRing& other) { return sameOutline(hole, other); });
        });
        return asHole || std::ranges::any_of(content->field.obstacles, [&hole](const Obstacle& obstacle) {
                   return sameOutline(hole, obstacle.outline.outer);
               });
    });
}

}  // namespace

std::vector<Message> contentDifferences(std::span<const FieldContent> meant, const ImportedFields& read) {
    std::vector<Message> differences;
    for (const FieldContent& content : meant) {
        std::vector<const FieldContent*> found;
        for (const GeoPolygon& part : content.field.parts) {
            const auto same = std::ranges::find_if(read.fields, [&part](const FieldContent& other) {
                return std::ranges::any_of(other.field.parts, [&part](const GeoPolygon& otherPart) {
                    return sameOutline(part.outer, otherPart.outer);
                });
            });
            if (same == read.fields.end()) {
                differences.push_back(
                    message("a part of the boundary of '{}' is missing or another", content.field.name));
            } else if (!std::ranges::contains(found, &*same)) {
                found.push_back(&*same);
            }
        }
        for (const GeoPolygon& part : content.field.parts) {
            for (const GeoRing& hole : part.holes) {
                if (!isThere(hole, found)) {
                    differences.push_back(
                        message("a hole of '{}' is missing or another", content.field.name));
                }
            }
        }
        std::size_t most = 0;
        for (const FieldContent* other : found) {
            most = std::max(most,
                            static_cast<std::size_t>(std::ranges::count_if(
                                other->lines, [](const GuidanceLine& line) { return !line.name.empty(); })));
        }
        if (!found.empty() && most < content.lines.size()) {
            differences.push_back(message("{} of {} guidance lines of '{}' are there", most,
                                          content.lines.size(), content.field.name));
        }
    }
    return differences;
}

}  // namespace furrow
