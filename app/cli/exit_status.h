#pragma once

#include "planner/core/error.h"

namespace furrow::cli {

/// What the command line answers with; other programs rely on the numbers.
enum ExitStatus : int {
    kDrivable = 0,
    kBlockingFinding = 1,
    kWrongUsage = 2,
    kInputRefused = 3,
    kReadOrWriteFailed = 4,
    kCancelled = 130,
};

/// Prints the error in one line on standard error and says what to exit with.
ExitStatus failWith(const Error& error);

}  // namespace furrow::cli
