#include "planner/headland/headland.h"


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

}  // namespace furrow
