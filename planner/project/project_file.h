#pragma once

#include "planner/core/fingerprint.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/project/project.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

// A project file is a GeoJSON FeatureCollection, so that every GIS opens it: one feature for each field,
// obstacle and gate, and a member `furrow_project` with the plans. The README describes it.

inline constexpr std::string_view kProjectExtension = ".furrow";

/// A project as it was read.
struct OpenedProject {
    Project project;
    /// Which bytes it was read from; see fingerprint().
    std::string fingerprint;
    /// What could not be used as it is; it is kept all the same and written again.
    std::vector<Message> notes;
};

/// Of what is in a file now; nothing where there is none or it cannot be read.
std::optional<std::string> fileFingerprint(const std::filesystem::path& path);

/// Reads a project from the text of its file. InputRefused: not JSON, not a project, damaged (says what),
/// saved by a newer Furrow.
Result<OpenedProject> parseProject(std::string_view text, const std::string& origin);
/// The same from a file. ReadFailed: not there, not readable.
Result<OpenedProject> readProject(const std::filesystem::path& path);

/// Whether a text begins like a project file: telling it from a boundary needs no parsing of all of it.
bool isProject(std::string_view text);
/// Whether a file is one: its extension says so, or how it begins.
bool holdsProject(const std::filesystem::path& path);

/// The file's text: the same for equal projects, one feature a line.
std::string projectText(const Project& project);

/// Writes the file beside its name and renames it: what was there stays until all of it is on the disk. A
/// link is followed. Gives the fingerprint of what was written. WriteFailed: with the system's reason.
Result<std::string> writeProject(const Project& project, const std::filesystem::path& path);

}  // namespace furrow
