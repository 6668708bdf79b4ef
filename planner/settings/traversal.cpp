#include "planner/settings/traversal.h"

#include "planner/settings/settings.h"

namespace furrow {

namespace {

constexpr Choice kTraversals[] = {
    {"interior", "Anywhere", "Ways may cross worked land."},
    {"headland", "Along the headland", "Ways keep to the headland; crop and seedbed are not driven over."},
    {"boundary", "Along the boundary", "Ways keep to the field's edge."},
};

}  // namespace

Traversal traversalOf(const Settings& settings) {
    const std::string id = settings.choice(kTraversal);
    return id == "boundary"   ? Traversal::Boundary
           : id == "headland" ? Traversal::Headland
                              : Traversal::Interior;
}

const Parameter kTraversal{
    .key = "route.traversal",
    .name = "Ways",
    .description = "Where the machine may drive from swath to swath; follows from the operation.",
    .kind = ParameterKind::Choice,
    .standard = 0.0,
    .choices = kTraversals};

}  // namespace furrow
