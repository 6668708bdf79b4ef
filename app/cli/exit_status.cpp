#include "app/cli/exit_status.h"

#include "app/cli/terminal.h"

#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

namespace furrow::cli {

ExitStatus failWith(const Error& error) {
    say(stderr, "furrow-cli: {}", error.line());
    switch (error.code) {
        case ErrorCode::Usage: return kWrongUsage;
        case ErrorCode::InputRefused: return kInputRefused;
        case ErrorCode::ReadFailed:
        case ErrorCode::WriteFailed: return kReadOrWriteFailed;
        case ErrorCode::Cancelled: return kCancelled;
    }
    return kInputRefused;
}

int ranAndWritten(const std::function<int()>& run) {
    try {
        const int status = run();
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            throw std::system_error{errno, std::generic_category()};
        }
        return status;
    } catch (const std::bad_alloc&) {
        say(stderr,
            "furrow-cli: there is not enough memory for this; give a smaller field or file, or free some "
            "memory");
        return kInputRefused;
    } catch (const std::filesystem::filesystem_error& error) {
        say(stderr, "furrow-cli: {}: {}; check the path", error.path1().string(), error.code().message());
        return kReadOrWriteFailed;
    } catch (const std::system_error& error) {
        say(stderr, "furrow-cli: standard output: could not be written: {}; make room there",
            error.code().message());
        return kReadOrWriteFailed;
    } catch (const std::exception& error) {
        say(stderr, "furrow-cli: {}; this is a mistake of Furrow, please report it with the input",
            error.what());
        return kInputRefused;
    }
}

}  // namespace furrow::cli
