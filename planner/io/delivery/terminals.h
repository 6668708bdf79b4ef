#pragma once

#include "planner/core/result.h"
#include "planner/io/content/export_job.h"

#include <span>
#include <string_view>

namespace furrow {

/// A receiver of files that people know by its name: what it reads, and what it makes of it.
struct Terminal {
    std::string_view id;      ///< "fendt"
    std::string_view name;    ///< "Fendt One, Vario terminal"
    std::string_view format;  ///< id of a format
    std::string_view shows;   ///< one or two sentences: what the driver will see, and what not
    ExportOptions options;
    std::string_view folder = {};  ///< on the stick; empty for its top
    bool onStick = true;           ///< carried on a USB stick, not sent or copied elsewhere

    /// Its format knows tasks; see ExportOptions::task.
    bool hasTasks() const { return format.starts_with("isoxml"); }
};

/// By their names.
std::span<const Terminal> terminals();

/// Usage: there is none of that id; the message names the nearest and lists them.
Result<const Terminal*> findTerminal(std::string_view id);

/// The files as they lie on its stick. Errors as FormatWriter.
Result<FormatFiles> terminalFiles(const Terminal& terminal, const Plan& plan, const JobContext& job = {});

}  // namespace furrow
