#include "app/cli/list_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/terminal.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/formats/registry.h"
#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"

#include <nlohmann/json.hpp>

#include <format>
#include <memory>
#include <print>
#include <string>

namespace furrow::cli {

namespace {

using Json = nlohmann::ordered_json;

void printJson(const Json& json) {
    std::println("{}", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

int listFields(const std::string& file, bool asJson) {
    const auto sources = readBoundaries(file, {});
    if (!sources) {
        return failWith(sources.error());
    }
    Json all = Json::array();
    for (std::size_t i = 0; i < sources->size(); ++i) {
        const FieldSource& source = (*sources)[i];
        const auto field = Field::create(source);
        const std::string problem = field ? std::string{} : field.error().line();
        if (asJson) {
            Json entry{{"number", i + 1}, {"id", source.id}, {"name", source.name}};
            entry["area_m2"] = field ? Json(field->area().si()) : Json();
            entry["refused"] = field ? Json() : Json(problem);
            all.push_back(std::move(entry));
        } else {
            const std::string area = field ? std::format("{:.2f} ha", inHectares(field->area())) : problem;
            say("{:4}  {:24}  {:24}  {}", i + 1, source.id, source.name, area);
        }
    }
    if (asJson) {
        printJson({{"fields", all}});
    }
    return kDrivable;
}

std::string_view kindName(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::Length: return "length_m";
        case ParameterKind::Angle: return "angle_deg";
        case ParameterKind::Count: return "count";
        case ParameterKind::Percent: return "percent";
        case ParameterKind::Choice: return "choice";
        case ParameterKind::Flag: return "flag";
        case ParameterKind::Line:
        case ParameterKind::Lines: return "wkt";
        case ParameterKind::File: return "file";
        case ParameterKind::Place: return "place";
        case ParameterKind::Places: return "places";
        case ParameterKind::Numbers: return "numbers";
    }
    return "";
}

Json parameterJson(const Parameter& parameter) {
    Json entry{{"key", parameter.key},
               {"name", parameter.name},
               {"description", parameter.description},
               {"kind", kindName(parameter.kind)},
               {"default", settingText(parameter.defaultValue())}};
    if (parameter.kind == ParameterKind::Choice) {
        for (const Choice& choice : parameter.choices) {
            entry["choices"].push_back(choice.id);
        }
    } else if (parameter.max > parameter.min) {
        entry["min"] = parameter.min;
        entry["max"] = parameter.max;
    }
    return entry;
}

std::string rangeText(const Parameter& parameter) {
    const std::string standard = "default " + settingText(parameter.defaultValue());
    switch (parameter.kind) {
        case ParameterKind::Choice: {
            std::string choices;
            for (const Choice& choice : parameter.choices) {
                choices += (choices.empty() ? "" : " | ") + std::string{choice.id};
            }
            return choices + ", " + standard;
        }
        case ParameterKind::Flag: return "true | false, " + standard;
        case ParameterKind::Length:
            return std::format("{} to {} m, {}", parameter.min, parameter.max, standard);
        case ParameterKind::Angle:
            return std::format("{} to {} degrees, {}", parameter.min, parameter.max, standard);
        case ParameterKind::Count: return std::format("{} to {}, {}", parameter.min, parameter.max, standard);
        case ParameterKind::Percent:
            return std::format("{} to {} %, {}", parameter.min, parameter.max, standard);
        case ParameterKind::Line: return "WKT in WGS84, default none";
        case ParameterKind::Lines: return "WKT of lines in WGS84, default none";
        case ParameterKind::File: return "a file, default none";
        case ParameterKind::Place: return "a gate or a WKT point in WGS84, default the first gate";
        case ParameterKind::Places:
            return "gates or WKT points in WGS84, divided by semicolons, default none";
        case ParameterKind::Numbers: return "numbers divided by commas, default none";
    }
    return standard;
}

void printParameters(std::span<const Parameter* const> parameters, std::string_view indent) {
    for (const Parameter* parameter : parameters) {
        say("{}{:22} {}  [{}]", indent, parameter->key, parameter->description, rangeText(*parameter));
    }
}

int listMethods(bool asJson) {
    if (asJson) {
        Json all = Json::array();
        const auto parametersJson = [](std::span<const Parameter* const> parameters) {
            Json list = Json::array();
            for (const Parameter* parameter : parameters) {
                list.push_back(parameterJson(*parameter));
            }
            return list;
        };
        for (const StageInfo& stage : stages()) {
            Json methods = Json::array();
            for (const MethodInfo& method : stage.methods) {
                methods.push_back({{"id", method.id},
                                   {"name", method.name},
                                   {"description", method.description},
                                   {"parameters", parametersJson(method.parameters)}});
            }
            all.push_back({{"stage", stage.id},
                           {"name", stage.name},
                           {"key", stage.method->key},
                           {"methods", std::move(methods)},
                           {"parameters", parametersJson(stage.parameters)}});
        }
        printJson({{"stages", std::move(all)}, {"parameters", parametersJson(generalParameters())}});
        return kDrivable;
    }
    say("general");
    printParameters(generalParameters(), "    ");
    for (const StageInfo& stage : stages()) {
        say("");
        say("{} ({})", stage.id, stage.method->key);
        for (const MethodInfo& method : stage.methods) {
            say("  {:16} {}{}", method.id, method.description,
                method.id == stage.methods.front().id ? " (default)" : "");
            printParameters(method.parameters, "      ");
        }
        printParameters(stage.parameters, "    ");
    }
    return kDrivable;
}

int listMachines(bool asJson) {
    Json all = Json::array();
    for (const Machine& machine : machineLibrary()) {
        if (asJson) {
            all.push_back(Json::parse(machineJson(machine.spec())));
        } else {
            say("{:22} {:44} {:5.1f} m wide, {:4.1f} m turning radius", machine.id(), machine.name(),
                machine.operatingWidth().si(), machine.minTurningRadius().si());
        }
    }
    if (asJson) {
        printJson({{"machines", all}});
    }
    return kDrivable;
}

int listFormats(bool asJson) {
    Json all = Json::array();
    for (const Format& format : formats()) {
        if (asJson) {
            all.push_back({{"id", format.id},
                           {"name", format.name},
                           {"extensions", format.extensions},
                           {"read", format.readsFields()},
                           {"reads_tracks", format.readsTracks()},
                           {"write", format.writes()},
                           {"writes_fields", format.writesFields()},
                           {"carries", format.carries}});
        } else {
            say("{:14} {:22} {:5} {:7} {:6} {}", format.id, format.name, format.readsFields() ? "read" : "",
                format.readsTracks() ? "tracks" : "", format.writes() ? "write" : "", format.carries);
        }
    }
    if (asJson) {
        printJson({{"formats", all}});
    }
    return kDrivable;
}

int listTerminals(bool asJson) {
    Json all = Json::array();
    for (const Terminal& terminal : terminals()) {
        if (asJson) {
            all.push_back({{"id", terminal.id},
                           {"name", terminal.name},
                           {"format", terminal.format},
                           {"folder", terminal.folder},
                           {"usb_stick", terminal.onStick},
                           {"shows", terminal.shows}});
        } else {
            say("{:30} {} ({})", terminal.id, terminal.name, terminal.format);
            say("{:30} {}", "", terminal.shows);
        }
    }
    if (asJson) {
        printJson({{"terminals", all}});
    }
    return kDrivable;
}

}  // namespace

void addListCommand(CLI::App& app, std::function<int()>& run) {
    CLI::App* list =
        app.add_subcommand("list", "Show the fields of a file, or what there is to choose from.");
    list->require_subcommand(1);
    const auto asJson = std::make_shared<bool>(false);
    const auto add = [&](const char* name, const char* description, auto action) {
        CLI::App* command = list->add_subcommand(name, description);
        command->add_flag("--json", *asJson, "One JSON object for programs");
        command->callback([&run, action] { run = action; });
        return command;
    };
    const auto file = std::make_shared<std::string>();
    add("fields", "The fields of a file, with number, id, name and area",
        [=] { return listFields(*file, *asJson); })
        ->add_option("FILE", *file, "A boundary file")
        ->required();
    add("methods", "Every method and setting, with its default", [=] { return listMethods(*asJson); });
    add("machines", "The machines that come with Furrow", [=] { return listMachines(*asJson); });
    add("terminals", "The terminals that plans are written for, and what they show of them",
        [=] { return listTerminals(*asJson); });
    add("formats", "The file formats that are read and written", [=] { return listFormats(*asJson); });
}

}  // namespace furrow::cli
