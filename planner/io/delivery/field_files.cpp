#include "planner/io/delivery/field_files.h"

#include "planner/core/text.h"
#include "planner/gdal/zip.h"
#include "planner/io/delivery/checked_files.h"
#include "planner/io/files/file_folder.h"
#include "planner/io/formats/registry.h"

#include <algorithm>
#include <ranges>
#include <string>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

Error noFormat(Message what) {
    std::string known;
    for (const Format& format : formats()) {
        if (format.writesFields()) {
            known += (known.empty() ? "" : ", ") + std::string{format.id};
        }
    }
    return {.code = ErrorCode::Usage,
            .what = std::move(what),
            .where = "OUT",
            .remedy = message("give a file name with an ending, or --format with one of: {}", known)};
}

Result<const Format*> formatFor(const fs::path& out, std::optional<std::string_view> formatId) {
    const std::string name = inSmallLetters(out.filename().string());
    std::string_view wanted = formatId.value_or("");
    if (wanted.empty() && (name == "taskdata" || name == "taskdata.xml")) {
        wanted = "isoxml";
    } else if (wanted.empty() && name == "aggps") {
        wanted = "aggps";
    } else if (wanted.empty() && name.ends_with(".zip")) {
        wanted = "shapefile-zip";
    }
    if (!wanted.empty()) {
        const auto known = std::ranges::find(formats(), wanted, &Format::id);
        if (known == formats().end() || !known->writesFields()) {
            return std::unexpected(noFormat(message("fields cannot be written as '{}'", wanted)));
        }
        return &*known;
    }
    const std::string ending = extensionInSmallLetters(out);
    for (const Format& format : formats()) {
        if (!format.writesFields() || ending.size() < 2) {
            continue;
        }
        for (const auto word : std::views::split(format.extensions, ' ')) {
            if (std::string_view{word} == std::string_view{ending}.substr(1)) {
                return &format;
            }
        }
    }
    return std::unexpected(
        noFormat(message("'{}' does not say which format is wanted", out.filename().string())));
}

/// Where the files of a format go for the name that was given.
fs::path placeOf(const fs::path& made, const fs::path& out, bool single) {
    const std::string name = inSmallLetters(out.filename().string());
    const fs::path first = *made.begin();
    if (!single && name == inSmallLetters(first.string())) {
        return out / made.lexically_relative(first);  // "…/TASKDATA" is that folder itself
    }
    if (single) {
        const std::string stem = made.stem().string();
        const std::size_t code = stem.find("_EPSG");
        const bool addsCode = code != std::string::npos &&
                              !name.ends_with(inSmallLetters(made.filename().string()).substr(code));
        return addsCode
                   ? out.parent_path() / (out.stem().string() + stem.substr(code) + out.extension().string())
                   : out;
    }
    if (extensionInSmallLetters(out) == ".shp") {
        const std::string layer = made.stem().string();
        return out.parent_path() /
               (out.stem().string() + (layer == "boundary" ? "" : "_" + layer) + made.extension().string());
    }
    return out / made;
}

}  // namespace

Result<WrittenFiles> writeFields(std::span<const FieldContent> fields, const fs::path& out,
                                 std::optional<std::string_view> formatId, const ExportOptions& options,
                                 const JobContext& job) {
    const auto format = formatFor(out, formatId);
    if (!format) {
        return std::unexpected(format.error());
    }
    auto made = checkedFiles(**format, {.fields = fields, .plan = nullptr, .options = options, .job = job});
    if (!made) {
        return std::unexpected(made.error());
    }
    if (extensionInSmallLetters(out) == ".zip" && (*format)->id != "shapefile-zip") {
        std::vector<FileInMemory> inside;
        for (const FileToWrite& file : made->files) {
            inside.push_back({file.path.generic_string(), file.text()});
        }
        auto zip = zipOf(inside);
        if (!zip) {
            return std::unexpected(zip.error());
        }
        made->files.clear();
        made->files.push_back(toWrite({out.filename().string(), *std::move(zip)}));
    }
    // A single file is what was asked for by its name.
    const bool single = made->files.size() == 1 && out.has_extension();
    for (FileToWrite& file : made->files) {
        file.path = fs::absolute(placeOf(file.path, out, single)).lexically_normal();
    }
    auto written = writeTogether({}, made->files, job);
    if (!written) {
        return std::unexpected(written.error());
    }
    return WrittenFiles{*std::move(written), std::move(made->notes), std::move(made->checks)};
}

}  // namespace furrow
