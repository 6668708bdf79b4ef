#include "app/manual/program.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/formats/registry.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/settings/operation.h"

#include <algorithm>
#include <functional>

namespace furrow::manual {

namespace {

using Words = std::vector<std::string>;

Words machineIds() {
    Words ids;
    for (const Machine& machine : machineLibrary()) {
        ids.emplace_back(machine.id());
    }
    return ids;
}

Words terminalIds() {
    Words ids;
    for (const Terminal& terminal : terminals()) {
        ids.emplace_back(terminal.id);
    }
    return ids;
}

Words formatIds(bool (Format::*fits)() const) {
    Words ids;
    for (const Format& format : formats()) {
        if ((format.*fits)()) {
            ids.emplace_back(format.id);
        }
    }
    return ids;
}

Words choicesOf(const Parameter& parameter) {
    Words ids;
    for (const Choice& choice : parameter.choices) {
        ids.emplace_back(choice.id);
    }
    return ids;
}

Words operations() {
    return choicesOf(kOperationKind);
}

/// key=value where there is a list of values, key= where not.
Words assignments() {
    Words all;
    for (const Parameter* parameter : allParameters()) {
        const std::string key = std::string{parameter->key} + "=";
        Words values =
            parameter->kind == ParameterKind::Flag ? Words{"true", "false"} : choicesOf(*parameter);
        if (values.empty()) {
            values.emplace_back();
        }
        for (const std::string& value : values) {
            all.push_back(key + value);
        }
    }
    return all;
}

/// What belongs to one argument of one program; of every program where that is empty.
struct Row {
    std::string_view program;
    std::string_view argument;
    Offer offer;
    std::function<Words()> words = [] { return Words{}; };
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"furrow-cli report", "--out", Offer::File},
        {"", "--out", Offer::Folder},
        {"", "--machine", Offer::WordOrFile, machineIds},
        {"", "--operation", Offer::Words, operations},
        {"", "--settings", Offer::File},
        {"", "--order", Offer::File},
        {"", "--set", Offer::KeyAndValue, assignments},
        {"furrow-cli convert", "--format", Offer::Words, [] { return formatIds(&Format::writesFields); }},
        {"", "--format", Offer::WordList, [] { return formatIds(&Format::writes); }},
        {"", "--terminal", Offer::Words, terminalIds},
        {"furrow", "--screenshot", Offer::File},
        {"furrow", "--colours", Offer::Words, [] { return Words{"light", "dark", "sunlight"}; }},
        {"furrow", "--units", Offer::Words, [] { return Words{"metric", "imperial"}; }},
        {"furrow", "--language", Offer::Words,
         [] { return Words{"en", "de", "nl", "fr", "es", "pt_BR", "pt_PT"}; }},
    };
    return all;
}

}  // namespace

void addOffer(const Program& program, Argument& argument) {
    if (argument.names.empty()) {
        argument.offer = Offer::File;  // everything that is told by its place is a file or a folder
        return;
    }
    const auto row = std::ranges::find_if(rows(), [&](const Row& each) {
        return (each.program.empty() || each.program == program.name) &&
               std::ranges::contains(argument.names, each.argument);
    });
    if (argument.takesValue() && row != rows().end()) {
        argument.offer = row->offer;
        argument.words = row->words();
    }
}

}  // namespace furrow::manual
