#pragma once

#include "planner/core/file_in_memory.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace furrow {

/// A file to be written: its path below a folder, and what makes its content when its turn comes.
struct FileToWrite {
    std::filesystem::path path;
    std::function<std::string()> text;
};

/// One that is made already.
FileToWrite toWrite(FileInMemory file);

/// Writes files together. The folders are made if they are not there. Everything is written and synced
/// beside its final name first and renamed when all of it is on the disk, so that a full disk, a cancel or
/// a crash leaves what was there before.
///
/// @return the files, in the order given. WriteFailed: with the system's reason. Cancelled.
Result<std::vector<std::filesystem::path>> writeTogether(const std::filesystem::path& folder,
                                                         std::span<const FileToWrite> files,
                                                         const JobContext& job = {});

/// Whether writeTogether is at work in any thread: until then nothing is half written.
bool isWritingFiles();

}  // namespace furrow
