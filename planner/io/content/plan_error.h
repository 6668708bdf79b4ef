#pragma once

#include "planner/core/error.h"

namespace furrow {

/// InputRefused: a file of a plan that is not as Furrow writes it.
Error damagedPlan(Message where, Message what);

}  // namespace furrow
