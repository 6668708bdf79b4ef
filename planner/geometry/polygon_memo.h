#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

/// What was made of polygons, by their points. Plans of one field mostly leave the same pieces of land. May
/// be used by several threads at once. Cost: some comparisons of the points of polygons.
template <class Value>
class PolygonMemo {
public:
    /// @param most  beyond this number of polygons all are forgotten
    explicit PolygonMemo(std::size_t most) : most_{most} {}

    /// Empty for a polygon that was not added, or is forgotten.
    std::optional<Value> find(const Polygon& polygon) const {
        const Key key = keyOf(polygon);
        const std::scoped_lock lock{mutex_};
        const auto known = known_.find(key);
        return known != known_.end() ? std::optional{known->second} : std::nullopt;
    }

    /// Of a polygon that was added before the first value stays.
    void add(const Polygon& polygon, Value value) {
        Key key = keyOf(polygon);
        const std::scoped_lock lock{mutex_};
        if (known_.size() >= most_) {
            known_.clear();
        }
        known_.emplace(std::move(key), std::move(value));
    }

    /// What was added for this polygon, or what `make(polygon)` makes of it now, which is added. Errors:
    /// those of `make`; they are not kept.
    template <class Make>
    Result<Value> get(const Polygon& polygon, const Make& make) {
        if (auto known = find(polygon)) {
            return *std::move(known);
        }
        Result<Value> made = make(polygon);
        if (made) {
            add(polygon, *made);
        }
        return made;
    }

private:
    using Key = std::vector<double>;

    static Key keyOf(const Polygon& polygon) {
        Key key;
        const auto addRing = [&key](const Ring& ring) {
            key.push_back(static_cast<double>(ring.size()));
            for (const Point& point : ring) {
                key.push_back(point.x);
                key.push_back(point.y);
            }
        };
        addRing(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            addRing(hole);
        }
        return key;
    }

    std::size_t most_;
    mutable std::mutex mutex_;
    std::map<Key, Value> known_;
};

}  // namespace furrow
