#pragma once

#include "planner/core/error.h"

#include <functional>

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

/// What a command comes to, also where it ran out of memory or its output did not arrive: on a full disk what
/// is printed would be cut off without a word.
int ranAndWritten(const std::function<int()>& run);

}  // namespace furrow::cli
