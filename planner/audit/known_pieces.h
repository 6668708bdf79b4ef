#pragma once

#include "planner/geometry/polygon.h"

#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

/// What became of pieces of land, by their points. Plans of one field mostly miss the same pieces. May be
/// used by several threads at once.
class KnownPieces {
public:
    std::optional<MultiPolygon> find(const Polygon& piece) const {
        const std::scoped_lock lock{mutex_};
        const auto known = known_.find(keyOf(piece));
        return known != known_.end() ? std::optional{known->second} : std::nullopt;
    }

    void add(const Polygon& piece, MultiPolygon parts) {
        const std::scoped_lock lock{mutex_};
        if (known_.size() >= kMostKept) {
            known_.clear();
        }
        known_.emplace(keyOf(piece), std::move(parts));
    }

private:
    // Beyond this number all are forgotten: about a megabyte.
    static constexpr std::size_t kMostKept = 1000;
    using Key = std::vector<double>;

    static Key keyOf(const Polygon& piece) {
        Key key;
        const auto addRing = [&key](const Ring& ring) {
            key.push_back(static_cast<double>(ring.size()));
            for (const Point& point : ring) {
                key.push_back(point.x);
                key.push_back(point.y);
            }
        };
        addRing(piece.outer);
        for (const Ring& hole : piece.holes) {
            addRing(hole);
        }
        return key;
    }

    mutable std::mutex mutex_;
    std::map<Key, MultiPolygon> known_;
};

}  // namespace furrow
