#include "planner/io/delivery/stick_writer.h"

#include "planner/io/check/read_back.h"
#include "planner/io/import/field_reader.h"

#include <algorithm>
#include <format>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

// In eight and three capitals, so that the oldest file systems hold it.
constexpr const char* kTemporary = "FURROW.TMP";

// Folders and tables take room, too.
constexpr std::uintmax_t kSpareBytes = 256 * 1024;

Error refused(ErrorCode code, Message what, Message remedy) {
    return {.code = code, .what = std::move(what), .where = "stick", .remedy = std::move(remedy)};
}

/// What is replaced as a whole: the folder that a terminal reads, the folder of a field, or a single file.
fs::path unitOf(const fs::path& file) {
    const fs::path first = *file.begin();
    if (!file.has_parent_path()) {
        return file;
    }
    return first == "TASKDATA" ? first : file.parent_path();
}

std::vector<fs::path> unitsOf(const FormatFiles& files) {
    std::vector<fs::path> units;
    for (const FileToWrite& file : files.files) {
        const fs::path unit = unitOf(file.path);
        if (!std::ranges::contains(units, unit)) {
            units.push_back(unit);
        }
    }
    return units;
}

/// Removes the temporary folder however it ends.
class Temporary {
public:
    explicit Temporary(StickVolume& stick) : stick_{stick} { stick_.removeAll(kTemporary); }
    ~Temporary() { stick_.removeAll(kTemporary); }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

private:
    StickVolume& stick_;
};

struct Content {
    fs::path path;
    std::string bytes;
};

Result<void> compare(const StickVolume& stick, const std::vector<Content>& contents, const fs::path& below) {
    for (const Content& content : contents) {
        const auto read = stick.read(below / content.path);
        if (!read) {
            return std::unexpected(read.error());
        }
        if (*read != content.bytes) {
            return std::unexpected(
                refused(ErrorCode::WriteFailed,
                        message("{} reads back other bytes than were written", content.path.string()),
                        "the stick is damaged: use another one"));
        }
    }
    return {};
}

fs::path freeBackupName(const StickVolume& stick, const fs::path& unit) {
    for (int number = 1;; ++number) {
        const fs::path name = unit.parent_path() / std::format("{}_backup_{}{}", unit.stem().string(), number,
                                                               unit.extension().string());
        if (!stick.exists(name)) {
            return name;
        }
    }
}

/// From the temporary folder to the final names; undone as far as possible where one of them fails.
class Moves {
public:
    explicit Moves(StickVolume& stick) : stick_{stick} {}

    Result<void> replace(const fs::path& unit, std::vector<fs::path>& backups) {
        if (stick_.exists(unit)) {
            const fs::path backup = freeBackupName(stick_, unit);
            if (auto moved = move(unit, backup); !moved) {
                return moved;
            }
            backups.push_back(backup);
        }
        return move(fs::path{kTemporary} / unit, unit);
    }
    void undo() {
        while (!done_.empty()) {
            const auto& [from, to] = done_.back();
            (void)stick_.rename(to, from);  // a stick that is gone cannot be put right
            done_.pop_back();
        }
    }

private:
    Result<void> move(const fs::path& from, const fs::path& to) {
        auto moved = stick_.rename(from, to);
        if (moved) {
            done_.emplace_back(from, to);
        }
        return moved;
    }
    StickVolume& stick_;
    std::vector<std::pair<fs::path, fs::path>> done_;
};

Result<void> checkRoom(const StickVolume& stick, const std::vector<Content>& contents, std::uintmax_t bytes) {
    const auto info = stick.info();
    if (!info) {
        return std::unexpected(info.error());
    }
    if (info->readOnly) {
        return std::unexpected(refused(ErrorCode::WriteFailed, "the stick is write-protected",
                                       "take off its write protection, or use another one"));
    }
    // Each file takes whole blocks.
    constexpr std::uintmax_t kLargestBlock = 32 * 1024;
    const std::uintmax_t needed = bytes + kSpareBytes + kLargestBlock * contents.size();
    if (info->freeBytes < needed) {
        return std::unexpected(
            refused(ErrorCode::WriteFailed,
                    message("the stick has {:.1f} MB free, and {:.1f} MB are needed",
                            static_cast<double>(info->freeBytes) / 1e6, static_cast<double>(needed) / 1e6),
                    "free some space on it, or use another one"));
    }
    return {};
}

/// Parses the written files again; true where there is a reader for them.
Result<bool> compareContent(const StickVolume& stick, const std::vector<fs::path>& units,
                            std::span<const FieldContent> meant) {
    const auto info = stick.info();
    if (!info) {
        return std::unexpected(info.error());
    }
    ImportedFields all;
    for (const fs::path& unit : units) {
        const bool readable = unit == "TASKDATA" || *unit.begin() == "AgGPS" || *unit.begin() == "AgOpenGPS";
        if (!readable) {
            return false;
        }
        auto read = readFields(info->root / unit);
        if (!read) {
            return std::unexpected(read.error());
        }
        std::ranges::move(read->fields, std::back_inserter(all.fields));
    }
    const std::vector<Message> differences = contentDifferences(meant, all);
    if (!differences.empty()) {
        return std::unexpected(refused(
            ErrorCode::WriteFailed, message("what is on the stick is not the plan: {}", differences.front()),
            "use another terminal's format, and report this"));
    }
    return true;
}

}  // namespace

std::vector<Message> stickWarnings(const VolumeInfo& info) {
    std::vector<Message> warnings;
    constexpr std::string_view kUnknownToTerminals[] = {"exfat", "ntfs",  "ntfs3", "fuseblk", "ext2", "ext3",
                                                        "ext4",  "btrfs", "xfs",   "hfsplus", "apfs"};
    if (std::ranges::contains(kUnknownToTerminals, info.fileSystem)) {
        warnings.push_back(message(
            "Most terminals read FAT32 only; this stick has {}. Format it as FAT32.",
            info.fileSystem == "fuseblk" || info.fileSystem.starts_with("ntfs") ? "NTFS" : info.fileSystem));
    }
    if (info.partitions > 1) {
        warnings.push_back(message("This stick has {} partitions; terminals see the first one only, if any.",
                                   info.partitions));
    }
    return warnings;
}

std::vector<fs::path> stickConflicts(const StickVolume& stick, const FormatFiles& files) {
    std::vector<fs::path> there = unitsOf(files);
    std::erase_if(there, [&stick](const fs::path& unit) { return !stick.exists(unit); });
    return there;
}

Result<StickReport> writeToStick(StickVolume& stick, const FormatFiles& files,
                                 std::span<const FieldContent> meant, bool replace, const JobContext& job) {
    if (const auto there = stickConflicts(stick, files); !there.empty() && !replace) {
        return std::unexpected(refused(ErrorCode::Usage,
                                       message("{} is on the stick already", there.front().string()),
                                       "allow it to be kept as a backup"));
    }
    StickReport report{.notes = files.notes, .checks = files.checks};
    std::vector<Content> contents;
    for (const FileToWrite& file : files.files) {
        contents.push_back({file.path, file.text()});
        report.bytes += contents.back().bytes.size();
        report.files.push_back(file.path);
    }
    if (auto room = checkRoom(stick, contents, report.bytes); !room) {
        return std::unexpected(room.error());
    }
    const Temporary temporary{stick};
    std::uintmax_t written = 0;
    for (const Content& content : contents) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (auto done = stick.write(fs::path{kTemporary} / content.path, content.bytes); !done) {
            return std::unexpected(done.error());
        }
        written += content.bytes.size();
        job.report(0.6 * static_cast<double>(written) /
                   static_cast<double>(std::max<std::uintmax_t>(report.bytes, 1)));
    }
    auto good = stick.sync().and_then([&] { return compare(stick, contents, kTemporary); });
    job.report(0.8);
    if (good && job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const std::vector<fs::path> units = unitsOf(files);
    Moves moves{stick};
    for (const fs::path& unit : units) {
        if (good) {
            good = moves.replace(unit, report.backups);
        }
    }
    good = good.and_then([&] { return stick.sync(); }).and_then([&] { return compare(stick, contents, {}); });
    const auto compared = good ? compareContent(stick, units, meant) : std::unexpected(good.error());
    if (!compared) {
        moves.undo();
        return std::unexpected(compared.error());
    }
    report.contentCompared = *compared;
    job.report(1.0);
    return report;
}

}  // namespace furrow
