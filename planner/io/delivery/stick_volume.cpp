#include "planner/io/delivery/stick_volume.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

Error failed(ErrorCode code, const fs::path& path, int reason) {
    const std::string why = std::generic_category().message(reason);
    if (isGone(reason)) {
        return {.code = code,
                .what = message("the stick does not answer any more ({})", why),
                .where = path.string(),
                .remedy = "was it pulled out? Plug it in again and write once more"};
    }
    return {.code = code,
            .what = message(
                code == ErrorCode::WriteFailed ? "could not be written: {}" : "could not be read: {}", why),
            .where = path.string(),
            .remedy = reason == ENOSPC  ? "free some space on the stick"
                      : reason == EROFS ? "take off the write protection of the stick"
                                        : "try another stick"};
}

class Handle {
public:
    Handle(const fs::path& path, int flags) : file_{::open(path.c_str(), flags | O_CLOEXEC, 0666)} {}
    ~Handle() {
        if (file_ >= 0) {
            ::close(file_);
        }
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    bool opened() const { return file_ >= 0; }
    int get() const { return file_; }

private:
    int file_;
};

/// "/run/media/me/My Stick" is written with \040 for blanks in the table of mounts.
std::string unescaped(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape = text[i] == '\\' && i + 3 < text.size() &&
                            std::all_of(text.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                        text.begin() + static_cast<std::ptrdiff_t>(i) + 4,
                                        [](char c) { return c >= '0' && c <= '7'; });
        if (escape) {
            plain += static_cast<char>(((text[i + 1] - '0') << 6) | ((text[i + 2] - '0') << 3) |
                                       (text[i + 3] - '0'));
            i += 3;
        } else {
            plain += text[i];
        }
    }
    return plain;
}

/// What is mounted where this folder lies: device and file system of the longest mount point above it.
struct Mount {
    std::string device;
    std::string type;
};
Mount mountOf(const fs::path& root) {
    std::error_code ignored;
    const std::string path = fs::canonical(root, ignored).string();
    std::ifstream table{"/proc/self/mounts"};
    Mount best;
    std::size_t longest = 0;
    for (std::string line; std::getline(table, line);) {
        std::istringstream words{line};
        std::string device;
        std::string place;
        std::string type;
        words >> device >> place >> type;
        place = unescaped(place);
        const bool above = path == place || place == "/" || path.starts_with(place + "/");
        if (above && place.size() >= longest) {
            longest = place.size();
            best = {device, type};
        }
    }
    return best;
}

/// Of the disk that a partition's device belongs to.
int partitionsBeside(const std::string& device) {
    std::error_code none;
    const fs::path own = fs::canonical(fs::path{"/sys/class/block"} / fs::path{device}.filename(), none);
    if (none || !fs::exists(own / "partition", none)) {
        return 1;
    }
    int count = 0;
    for (const auto& entry : fs::directory_iterator{own.parent_path(), none}) {
        count += fs::exists(entry.path() / "partition", none) ? 1 : 0;
    }
    return std::max(count, 1);
}

class FolderVolume : public StickVolume {
public:
    explicit FolderVolume(fs::path root) : root_{std::move(root)} {}

    Result<VolumeInfo> info() const override {
        struct statvfs state{};
        if (::statvfs(root_.c_str(), &state) != 0) {
            return std::unexpected(failed(ErrorCode::ReadFailed, root_, errno));
        }
        const Mount mount = mountOf(root_);
        return VolumeInfo{.root = root_,
                          .fileSystem = mount.type,
                          .freeBytes = static_cast<std::uintmax_t>(state.f_bavail) * state.f_frsize,
                          .totalBytes = static_cast<std::uintmax_t>(state.f_blocks) * state.f_frsize,
                          .readOnly = (state.f_flag & ST_RDONLY) != 0,
                          .partitions = partitionsBeside(mount.device)};
    }

    bool exists(const fs::path& path) const override {
        std::error_code ignored;
        return fs::exists(root_ / path, ignored);
    }

    Result<void> write(const fs::path& path, std::string_view bytes) override {
        const fs::path target = root_ / path;
        if (auto made = makeFolder(target.parent_path()); !made) {
            return made;
        }
        const Handle file{target, O_WRONLY | O_CREAT | O_TRUNC};
        if (!file.opened()) {
            return std::unexpected(failed(ErrorCode::WriteFailed, target, errno));
        }
        while (!bytes.empty()) {
            const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
            if (written >= 0) {
                bytes.remove_prefix(static_cast<std::size_t>(written));
            } else if (errno != EINTR) {
                return std::unexpected(failed(ErrorCode::WriteFailed, target, errno));
            }
        }
        if (::fsync(file.get()) != 0) {
            return std::unexpected(failed(ErrorCode::WriteFailed, target, errno));
        }
        return {};
    }

    Result<std::string> read(const fs::path& path) const override {
        const fs::path target = root_ / path;
        const Handle file{target, O_RDONLY};
        if (!file.opened()) {
            return std::unexpected(failed(ErrorCode::ReadFailed, target, errno));
        }
        // What was synced is dropped from memory, so that the bytes come from the stick.
        ::posix_fadvise(file.get(), 0, 0, POSIX_FADV_DONTNEED);
        std::string bytes;
        std::string block(std::size_t{1} << 18, '\0');
        while (true) {
            const ssize_t got = ::read(file.get(), block.data(), block.size());
            if (got > 0) {
                bytes.append(block, 0, static_cast<std::size_t>(got));
            } else if (got == 0) {
                return bytes;
            } else if (errno != EINTR) {
                return std::unexpected(failed(ErrorCode::ReadFailed, target, errno));
            }
        }
    }

    Result<void> rename(const fs::path& from, const fs::path& to) override {
        if (auto made = makeFolder((root_ / to).parent_path()); !made) {
            return made;
        }
        if (::rename((root_ / from).c_str(), (root_ / to).c_str()) != 0) {
            return std::unexpected(failed(ErrorCode::WriteFailed, root_ / to, errno));
        }
        return {};
    }

    void removeAll(const fs::path& path) override {
        std::error_code ignored;
        fs::remove_all(root_ / path, ignored);
    }

    Result<void> sync() override {
        const Handle folder{root_, O_RDONLY | O_DIRECTORY};
        if (!folder.opened() || ::syncfs(folder.get()) != 0) {
            return std::unexpected(failed(ErrorCode::WriteFailed, root_, errno));
        }
        return {};
    }

private:
    Result<void> makeFolder(const fs::path& folder) {
        std::error_code reason;
        // A root that is gone is not made anew on the disk below it.
        if (!fs::is_directory(root_, reason)) {
            return std::unexpected(failed(ErrorCode::WriteFailed, root_, ENODEV));
        }
        fs::create_directories(folder, reason);
        if (reason) {
            return std::unexpected(failed(ErrorCode::WriteFailed, folder, reason.value()));
        }
        return {};
    }

    fs::path root_;
};

}  // namespace

bool isGone(int systemError) {
    constexpr int kReasons[] = {EIO, ENODEV, ENXIO, ENOENT, ESTALE, ENOTCONN};
    return std::ranges::contains(kReasons, systemError);
}

std::unique_ptr<StickVolume> openStick(const fs::path& root) {
    return std::make_unique<FolderVolume>(root);
}

}  // namespace furrow
