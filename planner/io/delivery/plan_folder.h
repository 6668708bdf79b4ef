#pragma once

#include "planner/core/result.h"
#include "planner/io/content/export_job.h"
#include "planner/plan/plan.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace furrow {

struct Terminal;

/// The formats that are written where none are named.
std::span<const std::string_view> standardPlanFormats();

/// What an export came to.
struct WrittenFiles {
    std::vector<std::filesystem::path> files;
    std::vector<Message> notes;  ///< what a receiver will not find, or should know
    ExportChecks checks;         ///< what was looked at in the files before they were written
    std::string summary;         ///< the text of summary.json
};

/// Writes a plan to a folder: summary.json always, and each format's files at its place (see Format). The
/// folder is made if it is not there. Everything is written and synced beside its final name first and
/// renamed when all of it is on the disk, so that a full disk, a cancel or a crash leaves what was there
/// before. A plan that was there is replaced as a whole: summary.json lists the files of a plan, and those
/// that the new one does not have are removed. Files of others stay.
///
/// @return the files, summary.json first. Usage: unknown format. InputRefused: a format cannot hold this
/// plan.
///         WriteFailed: with the system's reason. Cancelled.
Result<WrittenFiles> writePlanFolder(const Plan& plan, const std::filesystem::path& folder,
                                     std::span<const std::string_view> formatIds, const JobContext& job = {},
                                     const ExportOptions& options = {});

/// The same for a terminal: summary.json, and its files as they lie on a stick.
Result<WrittenFiles> writeForTerminal(const Plan& plan, const std::filesystem::path& folder,
                                      const Terminal& terminal, const JobContext& job = {});

}  // namespace furrow
