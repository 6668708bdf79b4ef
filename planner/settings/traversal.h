#pragma once

#include "planner/settings/parameter.h"

namespace furrow {

class Settings;

/// Where ways between swaths may lead.
enum class Traversal {
    Interior,  ///< everywhere in the field
    Headland,  ///< not over the mainland, apart from the swath that was just left or comes next
    Boundary,  ///< along the field's edge only
};

/// Where ways may lead; what the operation says where it is not given.
extern const Parameter kTraversal;

Traversal traversalOf(const Settings& settings);

}  // namespace furrow
