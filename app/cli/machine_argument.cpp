#include "app/cli/machine_argument.h"

#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"

#include <filesystem>

namespace furrow::cli {

Result<Machine> machineFrom(const std::string& nameOrFile) {
    if (nameOrFile.empty()) {
        return machineLibrary().front();
    }
    if (nameOrFile.ends_with(".json") || std::filesystem::is_regular_file(nameOrFile)) {
        return readMachineFile(nameOrFile);
    }
    return findMachine(nameOrFile);
}

}  // namespace furrow::cli
