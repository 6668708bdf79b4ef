#include "planner/headland/headland.h"

#include "planner/geometry/segment.h"

#include <algorithm>

namespace furrow {

Error nothingLeft(Length margin) {
    return {.code = ErrorCode::InputRefused,
            .what = message("{} m of margin leaves nothing of the field to work", margin.si()),
            .where = "field.margin_m",
            .remedy = "give a smaller margin or check the obstacles"};
}

Length HeadlandPass::length() const {
    Length sum;
    for (const PassStretch& stretch : stretches) {
        sum += stretch.line.length();
    }
    return sum;
}

Length widthBeside(const Headland& headland, Point place) {
    const auto nearest = std::ranges::min_element(headland.strips, {}, [place](const EdgeStrip& strip) {
        return distanceToSegment(place, strip.from, strip.to);
    });
    return nearest == headland.strips.end() ? headland.width : nearest->width;
}

Length narrowestWidth(const Headland& headland) {
    const auto narrowest = std::ranges::min_element(headland.strips, {}, &EdgeStrip::width);
    return narrowest == headland.strips.end() ? headland.width : narrowest->width;
}

}  // namespace furrow
