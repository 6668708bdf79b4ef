#pragma once

#include "planner/core/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// What is known of a stick before anything is written.
struct VolumeInfo {
    std::filesystem::path root;
    std::string fileSystem;  ///< "vfat", "exfat", "ntfs" ...; empty where it is not known
    std::uintmax_t freeBytes = 0;
    std::uintmax_t totalBytes = 0;
    bool readOnly = false;
    int partitions = 1;  ///< of the whole stick
};

/// A stick, or a folder that stands for one. Paths are below its root. Everything that fails says WriteFailed
/// or ReadFailed with the system's reason.
class StickVolume {
public:
    virtual ~StickVolume() = default;

    virtual Result<VolumeInfo> info() const = 0;
    virtual bool exists(const std::filesystem::path& path) const = 0;
    /// Makes the folders above it; replaces what is there; is on the stick when it returns.
    virtual Result<void> write(const std::filesystem::path& path, std::string_view bytes) = 0;
    /// From the stick, not from the system's memory of what was written.
    virtual Result<std::string> read(const std::filesystem::path& path) const = 0;
    /// Of a file or folder; makes the folders above the new name.
    virtual Result<void> rename(const std::filesystem::path& from, const std::filesystem::path& to) = 0;
    virtual void removeAll(const std::filesystem::path& path) = 0;
    /// Waits until everything is on the stick.
    virtual Result<void> sync() = 0;
};

/// A mounted stick, or any folder.
std::unique_ptr<StickVolume> openStick(const std::filesystem::path& root);

/// Whether this is the reason of a stick that was pulled out.
bool isGone(int systemError);

}  // namespace furrow
