#include "planner/io/content/plan_error.h"

#include <utility>

namespace furrow {

Error damagedPlan(Message where, Message what) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = std::move(where),
            .remedy = "write the plan again with furrow-cli plan"};
}

}  // namespace furrow
