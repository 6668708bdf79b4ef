#include "planner/evaluation/batch_key.h"

#include "planner/core/fingerprint.h"
#include "planner/machine/machine_file.h"
#include "planner/project/plan_key.h"

#include <format>

namespace furrow {

std::string runKey(const BatchTask& task) {
    std::string text =
        std::format("{}\n{}\n", FURROW_VERSION, task.machine ? machineJson(task.machine->spec()) : "");
    text += settingInputs(task.settings);
    for (const std::string_view format : task.formats) {
        text += std::format("{} ", format);
    }
    return fingerprint(text).substr(0, 16);
}

std::string fieldKey(const std::filesystem::path& file, std::size_t number, const FieldTask& field,
                     const std::string& run) {
    const std::string text = std::format("{}\n{}\n{}\n", run, file.string(), number) +
                             planInputs(field.source, field.machine, field.settings);
    return fingerprint(text).substr(0, 16);
}

}  // namespace furrow
