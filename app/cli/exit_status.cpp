#include "app/cli/exit_status.h"

#include <cstdio>
#include <print>

namespace furrow::cli {

ExitStatus failWith(const Error& error) {
    std::println(stderr, "furrow-cli: {}", error.line());
    switch (error.code) {
        case ErrorCode::Usage: return kWrongUsage;
        case ErrorCode::InputRefused: return kInputRefused;
        case ErrorCode::ReadFailed:
        case ErrorCode::WriteFailed: return kReadOrWriteFailed;
        case ErrorCode::Cancelled: return kCancelled;
    }
    return kInputRefused;
}

}  // namespace furrow::cli
