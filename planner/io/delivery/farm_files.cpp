#include "planner/io/delivery/farm_files.h"

#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/checked_files.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace fs = std::filesystem;

namespace {

void addNotes(std::vector<Message>& notes, const std::vector<Message>& more) {
    for (const Message& note : more) {
        if (!std::ranges::contains(notes, note)) {
            notes.push_back(note);
        }
    }
}

void putBelow(const fs::path& folder, std::vector<FileToWrite>& files) {
    for (FileToWrite& file : files) {
        file.path = folder / file.path;
    }
}

}  // namespace

Result<FarmFolder> FarmFolder::at(const fs::path& folder, std::span<const std::string_view> formatIds) {
    FarmFolder farm{folder};
    for (const std::string_view id : formatIds) {
        const auto known = findPlanFormat(id);
        if (!known) {
            return std::unexpected(known.error());
        }
        if ((*known)->writing.fieldsTogether) {
            farm.together_.push_back(*known);
        } else {
            farm.alone_.push_back((*known)->id);
        }
    }
    return farm;
}

Result<WrittenFiles> FarmFolder::add(const Plan& plan, const JobContext& job) {
    Result<WrittenFiles> written;
    const std::string_view fieldName = plan.field().name();
    if (!alone_.empty() || together_.empty()) {
        UniqueNames names = names_;
        const std::string name = names.unique(safeFileName(fieldName, "Field"), "Field");
        written = writePlanFolder(plan, folder_ / name, alone_, job);
        if (!written) {
            return written;
        }
        names_ = std::move(names);
    }
    fields_.push_back(contentOf(plan));
    return written;
}

Result<WrittenFiles> FarmFolder::finish(const JobContext& job) const {
    WrittenFiles all;
    if (fields_.empty()) {
        return all;
    }
    std::vector<FileToWrite> files;
    for (const Format* format : together_) {
        auto made = checkedFiles(*format, {.fields = fields_, .plan = nullptr, .options = {}, .job = job});
        if (!made) {
            return std::unexpected(made.error());
        }
        putBelow(format->writing.folder, made->files);
        std::ranges::move(made->files, std::back_inserter(files));
        addNotes(all.notes, made->notes);
        all.checks.add(made->checks);
    }
    if (files.empty()) {
        return all;
    }
    return writeTogether(folder_, files, job).transform([&all](std::vector<fs::path> paths) {
        all.files = std::move(paths);
        return std::move(all);
    });
}

FarmOnStick::FarmOnStick(const Terminal& terminal)
    : terminal_{terminal}, format_{*findPlanFormat(terminal.format)} {}

Result<void> FarmOnStick::add(const Plan& plan, const JobContext& job) {
    return add(contentOf(plan, terminal_.options), &plan, job);
}

Result<void> FarmOnStick::add(const FieldSource& field, const JobContext& job) {
    return add(FieldContent{.field = field, .mainland = {}, .lines = {}, .area = {}}, nullptr, job);
}

Result<void> FarmOnStick::add(FieldContent content, const Plan* plan, const JobContext& job) {
    if (!format_->writing.fieldsTogether) {
        UniqueNames names = names_;
        // Two fields of one name are two folders.
        content.field.name = names.unique(content.field.name, "Field");
        auto made = checkedFiles(
            *format_, {.fields = {&content, 1}, .plan = plan, .options = terminal_.options, .job = job});
        if (!made) {
            return std::unexpected(made.error());
        }
        std::ranges::move(made->files, std::back_inserter(made_.files));
        addNotes(made_.notes, made->notes);
        made_.checks.add(made->checks);
        names_ = std::move(names);
    }
    fields_.push_back(std::move(content));
    return {};
}

Result<FormatFiles> FarmOnStick::files(const JobContext& job) const {
    auto made =
        format_->writing.fieldsTogether
            ? checkedFiles(*format_,
                           {.fields = fields_, .plan = nullptr, .options = terminal_.options, .job = job})
            : Result<FormatFiles>{made_};
    if (made) {
        putBelow(terminal_.folder, made->files);
    }
    return made;
}

}  // namespace furrow
