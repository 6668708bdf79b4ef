#include "planner/headland/headland_passes.h"

namespace furrow {

namespace {

constexpr Choice kOrders[] = {
    {"outside-in", "From outside in", "The pass along the boundary first."},
    {"inside-out", "From inside out", "The innermost pass first."},
};
constexpr Choice kTimes[] = {
    {"before", "Before the swaths", "The headland is worked first."},
    {"after", "After the swaths", "The headland is worked last."},
};
constexpr Choice kDirections[] = {
    {"counter-clockwise", "Counter-clockwise", "Seen from above, turning left at corners."},
    {"clockwise", "Clockwise", "Seen from above, turning right at corners."},
};
constexpr Choice kCornerKinds[] = {
    {kQuickestCorner, "Quickest", "The kind below with which the whole plan takes the least time."},
    {kRoundedCorner, "Rounded",
     "The outermost pass goes round with the machine's radius where little is left; others reach into corners."},
    {kLoopCorner, "Loop", "Straight into the corner and on after a loop, where there is room for it."},
    {kReverseCorner, "Reverse", "Straight into the corner and back into it on the next side."},
};

}  // namespace

const Parameter kHeadlandDriven{.key = "headland.driven",
                                .name = "Work the headland",
                                .description = "Off: the strip is kept for turning only.",
                                .kind = ParameterKind::Flag,
                                .standard = 1.0,
                                .choices = {}};

bool drivesInsideOut(const Settings& settings) {
    return settings.choice(kHeadlandOrder) == "inside-out";
}

std::string plannedCorner(const Settings& settings) {
    std::string corner = settings.choice(kHeadlandCorner);
    return corner == kQuickestCorner ? std::string{kRoundedCorner} : corner;
}

bool drivesHeadlandFirst(const Settings& settings) {
    return settings.choice(kHeadlandWhen) == "before";
}

const Parameter kHeadlandOrder{.key = "headland.order",
                               .name = "Order",
                               .description = "In which order the headland passes are driven.",
                               .kind = ParameterKind::Choice,
                               .standard = 0.0,
                               .choices = kOrders};

const Parameter kHeadlandWhen{.key = "headland.when",
                              .name = "When",
                              .description = "Headland first or last.",
                              .kind = ParameterKind::Choice,
                              .standard = 0.0,
                              .choices = kTimes};

const Parameter kHeadlandDirection{.key = "headland.direction",
                                   .name = "Round the field",
                                   .description = "Which way round the headland passes are driven.",
                                   .kind = ParameterKind::Choice,
                                   .standard = 0.0,
                                   .choices = kDirections};

const Parameter kHeadlandCorner{.key = "headland.corner",
                                .name = "Corners",
                                .description = "How headland passes get round corners.",
                                .kind = ParameterKind::Choice,
                                .standard = 0.0,
                                .choices = kCornerKinds};

}  // namespace furrow
