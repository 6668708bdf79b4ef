#pragma once

#include "planner/core/result.h"
#include "planner/io/content/export_job.h"
#include "planner/io/delivery/stick_volume.h"
#include "planner/io/delivery/terminals.h"

#include <filesystem>
#include <string>
#include <vector>

namespace furrow {

/// What stands in the way of a terminal reading this stick: a file system it does not know, several
/// partitions. Sentences for people; empty for a good stick.
std::vector<Message> stickWarnings(const VolumeInfo& info);

/// What would be replaced: folders and files that are there already, below the root of the stick.
std::vector<std::filesystem::path> stickConflicts(const StickVolume& stick, const FormatFiles& files);

/// What writing to a stick came to: everything was read back and found equal, so it can be unplugged.
struct StickReport {
    std::vector<std::filesystem::path> files;    ///< below the root
    std::vector<std::filesystem::path> backups;  ///< what was there before, under its new name
    std::uintmax_t bytes = 0;
    bool contentCompared =
        false;  ///< the files were also parsed again; not for formats that are only written
    std::vector<Message> notes;
    ExportChecks checks;  ///< of the files, before they were written
};

/// Writes files to a stick so that either all of it is there and right, or nothing under its final name:
/// into a folder of its own first, synced, every byte read back and compared, then what was there before
/// renamed to a backup and the new folders to their names, synced again, read back again, parsed and compared
/// with what was meant.
///
/// @param files    see terminalFiles
/// @param meant    the fields that are in them
/// @param replace  what is there may be renamed to a backup; without it such a stick is refused
/// @return WriteFailed: full, write-protected, pulled out, other bytes or content than were written. Usage:
/// something
///         is there and `replace` is false. Cancelled: before anything has its final name.
Result<StickReport> writeToStick(StickVolume& stick, const FormatFiles& files,
                                 std::span<const FieldContent> meant, bool replace,
                                 const JobContext& job = {});

}  // namespace furrow
