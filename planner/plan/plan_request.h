#pragma once

#include "planner/field/field.h"
#include "planner/machine/machine.h"
#include "planner/route/driven_swath.h"
#include "planner/settings/settings.h"
#include "planner/swaths/guide_data.h"

#include <memory>
#include <vector>

namespace furrow {

/// Everything a plan follows from.
struct PlanRequest {
    std::shared_ptr<const Field> field;
    Machine machine;
    Settings settings;
    /// What swaths.rows and swaths.elevation name, read.
    std::shared_ptr<const GuideData> guides = {};
    /// Only to be looked at: the path is not audited. See draftOf.
    bool draft = false;
    /// For a draft: the swaths of the last plan in the order in which they were driven.
    std::vector<DrivenSwath> earlier = {};
};

/// Field, machine and guides are the same.
inline bool isSameButSettings(const PlanRequest& a, const PlanRequest& b) {
    return (a.field == b.field || a.field->source() == b.field->source()) && a.machine == b.machine &&
           a.guides == b.guides;
}

}  // namespace furrow
