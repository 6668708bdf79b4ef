#include "planner/io/files/atomic_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

Error writeFailed(const fs::path& path, std::error_code reason) {
    return {.code = ErrorCode::WriteFailed,
            .what = message("could not be written: {}", reason.message()),
            .where = path.string(),
            .remedy = reason == std::errc::no_space_on_device ? "free some space or choose another folder"
                                                              : "check that the folder can be written to"};
}

std::error_code lastError() {
    return {errno, std::generic_category()};
}

/// Removes what it wrote unless it was kept.
class PendingFile {
public:
    PendingFile(fs::path target, std::string_view text)
        : target_{std::move(target)}, part_{target_.string() + ".part"} {
        const int file = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (file < 0) {
            problem_ = lastError();
            return;
        }
        while (!problem_ && !text.empty()) {
            const ssize_t written = ::write(file, text.data(), text.size());
            if (written >= 0) {
                text.remove_prefix(static_cast<std::size_t>(written));
            } else if (errno != EINTR) {
                problem_ = lastError();
            }
        }
        if (!problem_ && ::fsync(file) != 0) {
            problem_ = lastError();
        }
        if (::close(file) != 0 && !problem_) {
            problem_ = lastError();
        }
    }
    ~PendingFile() {
        if (!part_.empty()) {
            std::error_code ignored;
            fs::remove(part_, ignored);
        }
    }
    PendingFile(PendingFile&& other) noexcept
        : target_{std::move(other.target_)},
          part_{std::exchange(other.part_, {})},
          problem_{other.problem_} {}
    PendingFile& operator=(PendingFile&&) = delete;

    const fs::path& target() const { return target_; }
    std::error_code problem() const { return problem_; }
    std::error_code keep() {
        std::error_code failed;
        fs::rename(part_, target_, failed);
        if (!failed) {
            part_.clear();
        }
        return failed;
    }

private:
    fs::path target_;
    fs::path part_;
    std::error_code problem_;
};

}  // namespace

FileToWrite toWrite(FileInMemory file) {
    return {std::move(file.path), [bytes = std::move(file.bytes)] { return bytes; }};
}

Result<std::vector<fs::path>> writeTogether(const fs::path& folder, std::span<const FileToWrite> files,
                                            const JobContext& job) {
    std::vector<PendingFile> pending;
    for (const FileToWrite& file : files) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const fs::path target = folder / file.path;
        std::error_code failed;
        fs::create_directories(target.parent_path(), failed);
        if (failed) {
            return std::unexpected(writeFailed(target.parent_path(), failed));
        }
        pending.emplace_back(target, file.text());
        if (pending.back().problem()) {
            return std::unexpected(writeFailed(target, pending.back().problem()));
        }
    }
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    std::vector<fs::path> written;
    for (PendingFile& file : pending) {
        if (const std::error_code failed = file.keep()) {
            return std::unexpected(writeFailed(file.target(), failed));
        }
        written.push_back(file.target());
    }
    return written;
}

}  // namespace furrow
