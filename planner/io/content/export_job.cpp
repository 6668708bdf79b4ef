#include "planner/io/content/export_job.h"

#include "planner/core/file_error.h"

#include <algorithm>
#include <utility>

namespace furrow {

void ExportChecks::add(const ExportChecks& more) {
    for (const std::string_view id : more.made) {
        if (!std::ranges::contains(made, id)) {
            made.push_back(id);
        }
    }
    problems.insert(problems.end(), more.problems.begin(), more.problems.end());
}

FormatFiles asFormatFiles(std::vector<FileInMemory> files) {
    FormatFiles made;
    for (FileInMemory& file : files) {
        made.files.push_back(toWrite(std::move(file)));
    }
    return made;
}

Error needsPlan(std::string_view format) {
    return inputRefused(std::string{format},
                        "this format holds the path of a plan, and there is only a field",
                        "plan the field first: furrow-cli plan FIELD --out plan");
}

}  // namespace furrow
