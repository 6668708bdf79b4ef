#include "ui/trouble/crash_record.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

namespace furrow::crash_record {

namespace {

constexpr std::array kFatal{SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};
constexpr std::size_t kStackBytes = 64 * 1024;
constexpr int kFrames = 64;

// Read by the handler: plain data only, complete before it is pointed to.
std::string path;
std::string unfinishedPath;
std::atomic<const std::string*> text{nullptr};
std::atomic_flag writing;
std::unique_ptr<std::string> kept;
std::unique_ptr<std::string> keptBefore;
std::array<char, kStackBytes> signalStack;

void put(int file, const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = write(file, bytes, count);
        if (written <= 0) {
            return;
        }
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

const char* nameOf(int signal) {
    switch (signal) {
        case SIGSEGV: return "SIGSEGV";
        case SIGABRT: return "SIGABRT";
        case SIGBUS: return "SIGBUS";
        case SIGFPE: return "SIGFPE";
        default: return "SIGILL";
    }
}

/// Only what is allowed in a handler of a signal.
void record(int signal) {
    if (!writing.test_and_set()) {
        const int file =
            open(unfinishedPath.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0600);
        if (file >= 0) {
            const char* name = nameOf(signal);
            put(file, name, std::strlen(name));
            put(file, "\n", 1);
            if (const std::string* made = text.load()) {
                put(file, made->data(), made->size());
            }
            put(file, "\n", 1);
            std::array<void*, kFrames> frames{};
            backtrace_symbols_fd(frames.data(), backtrace(frames.data(), kFrames), file);
            close(file);
            rename(unfinishedPath.c_str(), path.c_str());
        }
    }
    // As if nobody had looked: the system's own record, and the status for who started the program.
    std::signal(signal, SIG_DFL);
    raise(signal);
}

}  // namespace

void begin(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    path = folder / ("crash-" + std::to_string(getpid()) + ".txt");
    unfinishedPath = path + ".part";
    // The first call loads a library, which a handler may not.
    std::array<void*, 1> frame{};
    backtrace(frame.data(), 1);
    // A stack of its own: the usual one may be what is used up.
    const stack_t stack{.ss_sp = signalStack.data(), .ss_flags = 0, .ss_size = signalStack.size()};
    sigaltstack(&stack, nullptr);
    struct sigaction action{};
    action.sa_handler = record;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : kFatal) {
        sigaction(signal, &action, nullptr);
    }
}

void setText(std::string made) {
    // The one before stays for a handler that has just begun to read it.
    keptBefore = std::move(kept);
    kept = std::make_unique<std::string>(std::move(made));
    text.store(kept.get());
}

}  // namespace furrow::crash_record
