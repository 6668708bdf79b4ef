#pragma once

#include "planner/geometry/polygon.h"

#include <optional>
#include <utility>

namespace furrow {

/// Where the parts of a machine may be. The area of the implement holds that of the tractor.
class AllowedAreas {
public:
    AllowedAreas() = default;
    /// One area for everything.
    AllowedAreas(MultiPolygon both) : tractor_{std::move(both)} {}
    /// @param implement  empty: the same
    AllowedAreas(MultiPolygon tractor, std::optional<MultiPolygon> implement)
        : tractor_{std::move(tractor)}, implement_{std::move(implement)} {}

    /// For the tractor and every wheel.
    const MultiPolygon& tractor() const { return tractor_; }
    /// For the implement's width, at work and raised.
    const MultiPolygon& implement() const { return implement_ ? *implement_ : tractor_; }
    /// Whether an implement may stand over more than the tractor.
    bool hasOverhang() const { return implement_.has_value(); }

    friend bool operator==(const AllowedAreas&, const AllowedAreas&) = default;

private:
    MultiPolygon tractor_;
    std::optional<MultiPolygon> implement_;
};

}  // namespace furrow
