#include "planner/machine/machine_library.h"

#include "planner/machine/machine_file.h"
#include "planner/settings/settings.h"
#include "resources/embedded.h"

#include <algorithm>
#include <array>
#include <format>
#include <vector>

namespace furrow {

namespace {

std::string smallLetters(std::string_view text) {
    std::string small{text};
    // ASCII only: ids and names of the library have no other letters.
    std::ranges::transform(small, small.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return small;
}

}  // namespace

std::span<const Machine> machineLibrary() {
    static const std::vector<Machine> machines = [] {
        std::vector<Machine> read;
        for (const EmbeddedFile& file : embeddedMachines()) {
            // A shipped file that does not parse is a broken build; the tests read every one.
            read.push_back(parseMachine(file.text, file.name).value());
        }
        return read;
    }();
    return machines;
}

std::string_view usualOperation(const Machine& machine) {
    struct Usual {
        std::string_view machine;
        std::string_view operation;
    };
    static constexpr std::array kUsual{
        Usual{"agbot", "tillage"},
        Usual{"field-robot", "tillage"},
        Usual{"orchard-sprayer", "spraying"},
        Usual{"plough", "tillage"},
        Usual{"power-harrow-drill", "sowing"},
        Usual{"cultivator", "tillage"},
        Usual{"planter", "sowing"},
        Usual{"combine", "harvest"},
        Usual{"mower", "mowing"},
        Usual{"mounted-drill", "sowing"},
        Usual{"slurry-tanker", "spreading"},
        Usual{"trailed-sprayer", "spraying"},
        Usual{"spreader", "spreading"},
    };
    const auto usual = std::ranges::find(kUsual, machine.id(), &Usual::machine);
    return usual == kUsual.end() ? std::string_view{} : usual->operation;
}

Result<Machine> findMachine(std::string_view idOrName) {
    const std::string wanted = smallLetters(idOrName);
    std::string known;
    std::vector<std::string> names;
    for (const Machine& machine : machineLibrary()) {
        names.push_back(smallLetters(machine.id()));
        names.push_back(smallLetters(machine.name()));
        if (wanted == names.back() || wanted == names[names.size() - 2]) {
            return machine;
        }
        known += std::format("{}{}", known.empty() ? "" : ", ", machine.id());
    }
    const std::vector<std::string_view> candidates{names.begin(), names.end()};
    const std::string nearest = nearestName(wanted, candidates);
    return std::unexpected(
        Error{.code = ErrorCode::Usage,
              .what = message("there is no machine '{}'", idOrName),
              .where = "machine",
              .remedy = nearest.empty()
                            ? message("use one of: {}; or give a machine file (.json)", known)
                            : message("did you mean '{}'? use one of: {}; or give a machine file (.json)",
                                      nearest, known)});
}

}  // namespace furrow
