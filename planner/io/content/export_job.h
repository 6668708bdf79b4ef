#pragma once

#include "planner/core/result.h"
#include "planner/io/content/field_content.h"
#include "planner/io/files/atomic_files.h"
#include "planner/jobs/job.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

struct Plan;

/// What a receiver needs otherwise than others do.
struct ExportOptions {
    bool holesAsObstacles = false;  ///< holes as areas of their own, for readers that overlook inner rings
    bool asciiNames = false;        ///< letters A to Z, digits, blank, - and _ only
    bool headlandLines = false;     ///< headland passes as curves of their own
    bool task = false;     ///< a planned task for each field, for terminals that show lines in tasks only
    int longestName = 32;  ///< characters, counting from 8

    friend bool operator==(const ExportOptions&, const ExportOptions&) = default;
};

/// What is written: fields, and of one of them a plan.
struct ExportJob {
    std::span<const FieldContent> fields;  ///< at least one
    const Plan* plan = nullptr;            ///< of the only field; null where fields alone are written
    ExportOptions options;
    JobContext job;
};

/// What was looked at in written files, and what was found; see checkExport in io/check.
struct ExportChecks {
    std::vector<std::string_view>
        made;                       ///< ids of the checks that had something to look at: "rings-closed" ...
    std::vector<Message> problems;  ///< empty for good files

    /// Those of other files of the same export.
    void add(const ExportChecks& more);
};

/// What one format makes of a job.
struct FormatFiles {
    std::vector<FileToWrite> files;  ///< paths below the folder that is written to
    std::vector<Message> notes;      ///< what the receiver will not find in them, or should know
    ExportChecks checks = {};
};

/// Files that are made already, without notes.
FormatFiles asFormatFiles(std::vector<FileInMemory> files);

/// InputRefused: a format of paths was asked for, and there is no plan.
Error needsPlan(std::string_view format);

}  // namespace furrow
