#pragma once

#include "planner/core/result.h"
#include "planner/io/delivery/plan_folder.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/files/file_names.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace furrow {

struct Format;

/// Plans of several fields in one folder: each with a folder of its own below it, named as the field is, and
/// what terminals look for once with all fields in it (ISOXML, AgGPS). The plans are given one after the
/// other and need not live on.
class FarmFolder {
public:
    /// Usage: unknown format.
    static Result<FarmFolder> at(const std::filesystem::path& folder,
                                 std::span<const std::string_view> formatIds);

    /// Writes the folder of a plan (see writePlanFolder), and keeps what is written with all others. No files
    /// where there are only formats of the latter kind. Errors: those of writePlanFolder; then nothing of
    /// this plan is anywhere.
    Result<WrittenFiles> add(const Plan& plan, const JobContext& job = {});
    /// Writes what holds all the fields that were added. No files where there is nothing like that. Errors as
    /// writePlanFolder.
    Result<WrittenFiles> finish(const JobContext& job = {}) const;

private:
    explicit FarmFolder(std::filesystem::path folder) : folder_{std::move(folder)} {}

    std::filesystem::path folder_;
    std::vector<std::string_view> alone_;  ///< ids of the formats that each field has for itself
    std::vector<const Format*> together_;
    std::vector<FieldContent> fields_;
    UniqueNames names_{60, false};
};

/// Plans of several fields as they lie on the stick of one terminal.
class FarmOnStick {
public:
    explicit FarmOnStick(const Terminal& terminal);

    /// Errors as terminalFiles; then nothing of this plan is in the files.
    Result<void> add(const Plan& plan, const JobContext& job = {});
    /// Of a field that is not planned yet: its files have the right names, but do not hold all.
    Result<void> add(const FieldSource& field, const JobContext& job = {});
    /// Errors as terminalFiles.
    Result<FormatFiles> files(const JobContext& job = {}) const;
    /// What is in them, for writeToStick.
    const std::vector<FieldContent>& fields() const { return fields_; }

private:
    Result<void> add(FieldContent content, const Plan* plan, const JobContext& job);

    Terminal terminal_;
    const Format* format_ = nullptr;
    std::vector<FieldContent> fields_;
    /// Of the fields before, for a format that has files for each of them.
    FormatFiles made_;
    UniqueNames names_{56, false};
};

}  // namespace furrow
