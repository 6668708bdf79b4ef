#include "planner/io/files/atomic_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <ranges>
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
        // What an interrupted run left is replaced. A link of that name would lead elsewhere.
        ::unlink(part_.c_str());
        const int file = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
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

/// The folders that are made for files; those that are empty go again unless the files are there.
class MadeFolders {
public:
    MadeFolders() = default;
    ~MadeFolders() {
        for (const fs::path& folder : made_ | std::views::reverse) {
            std::error_code ignored;
            fs::remove(folder, ignored);
        }
    }
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;

    std::error_code make(const fs::path& folder) {
        std::vector<fs::path> missing;
        std::error_code failed;
        for (fs::path each = folder; !each.empty() && !fs::exists(each, failed); each = each.parent_path()) {
            missing.push_back(each);
        }
        fs::create_directories(folder, failed);
        made_.insert(made_.end(), missing.rbegin(), missing.rend());
        return failed;
    }
    void keep() { made_.clear(); }

private:
    std::vector<fs::path> made_;  ///< outer ones first
};

std::atomic<int> writers = 0;

struct Writing {
    Writing() { ++writers; }
    ~Writing() { --writers; }
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
};

}  // namespace

bool isWritingFiles() {
    return writers > 0;
}

FileToWrite toWrite(FileInMemory file) {
    return {std::move(file.path), [bytes = std::move(file.bytes)] { return bytes; }};
}

Result<std::vector<fs::path>> writeTogether(const fs::path& folder, std::span<const FileToWrite> files,
                                            const JobContext& job) {
    const Writing writing;
    MadeFolders folders;
    std::vector<PendingFile> pending;
    for (const FileToWrite& file : files) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const fs::path target = folder / file.path;
        if (const std::error_code failed = folders.make(target.parent_path())) {
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
        folders.keep();
    }
    return written;
}

}  // namespace furrow
