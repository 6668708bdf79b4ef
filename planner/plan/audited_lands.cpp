#include "planner/plan/audited_lands.h"

namespace furrow {

Result<std::shared_ptr<const AuditedLand>> auditedLand(AuditedLands& known, const PlanRequest& request,
                                                       const std::shared_ptr<const Ground>& ground,
                                                       const AuditInput& input, const JobContext& job) {
    // What settings decide is in the ground.
    PlanRequest plain = request;
    plain.settings = {};
    return known.get(plain, {ground}, [&](const PlanRequest&) { return auditedLand(input, job); });
}

}  // namespace furrow
