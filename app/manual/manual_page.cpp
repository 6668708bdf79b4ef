#include "app/manual/program.h"
#include "planner/version.h"

#include <algorithm>
#include <format>
#include <ranges>

namespace furrow::manual {

namespace {

/// What a footer says, by the section of a page.
struct Footer {
    std::vector<std::string> description;
    std::vector<std::string> examples;
    std::string exitStatus;
};

std::vector<std::string> splitBy(std::string_view text, std::string_view separator) {
    std::vector<std::string> parts;
    for (const auto part : std::views::split(text, separator)) {
        parts.emplace_back(std::string_view{part});
    }
    return parts;
}

Footer footerOf(std::string_view text) {
    constexpr std::string_view kExamples = "Examples:\n";
    constexpr std::string_view kExit = "Exit status: ";
    Footer footer;
    for (std::string& paragraph : splitBy(text, "\n\n")) {
        if (paragraph.starts_with(kExamples)) {
            footer.examples = splitBy(std::string_view{paragraph}.substr(kExamples.size()), "\n");
            continue;
        }
        if (const std::size_t exit = paragraph.find(kExit); exit != std::string::npos) {
            footer.exitStatus = paragraph.substr(exit + kExit.size());
            paragraph.resize(exit);
        }
        if (!paragraph.empty()) {
            footer.description.push_back(std::move(paragraph));
        }
    }
    return footer;
}

/// Text as troff takes it literally.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        switch (letter) {
            case '\\': result += "\\e"; break;
            case '-': result += "\\-"; break;
            case '\'': result += "\\(aq"; break;
            case '.':
                // At the beginning of a line a full stop would begin a request.
                result += result.empty() || result.back() == '\n' ? "\\&." : ".";
                break;
            default: result += letter;
        }
    }
    return result;
}

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return std::string{first == std::string_view::npos ? std::string_view{} : text.substr(first)};
}

std::string withoutStop(std::string text) {
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return text;
}

std::string synopsis(const Program& program) {
    std::string line = std::format("\\fB{}\\fR", escaped(program.name));
    for (const Argument& option : program.options | std::views::filter(&Argument::required)) {
        line += std::format(" \\fB{}\\fR \\fI{}\\fR", escaped(option.names.back()), escaped(option.value));
    }
    line += " [\\fIOPTION\\fR ...]";
    if (!program.commands.empty()) {
        line += " \\fICOMMAND\\fR ...";
    }
    for (const Argument& place : program.places) {
        const std::string name =
            std::format("\\fI{}\\fR{}", escaped(place.value), place.repeated ? " ..." : "");
        line += place.required ? " " + name : " [" + name + "]";
    }
    return line + "\n";
}

std::string optionList(const std::vector<Argument>& arguments) {
    std::string text;
    for (const Argument& argument : arguments) {
        std::string head;
        for (const std::string& name : argument.names) {
            head += std::format("{}\\fB{}\\fR", head.empty() ? "" : ", ", escaped(name));
        }
        if (argument.takesValue()) {
            head += std::format("{}\\fI{}\\fR", head.empty() ? "" : " ", escaped(argument.value));
        }
        text += std::format(".TP\n{}\n{}\n", head, escaped(argument.description));
    }
    return text;
}

/// The commands below a command, with their options; of a program the names alone, which have their own
/// pages.
std::string commandList(const Program& program) {
    const bool haveOwnPages = !program.name.contains(' ');
    std::string text;
    for (const Program& command : program.commands) {
        if (haveOwnPages) {
            text += std::format(".TP\n\\fB{}\\fR\n{}\n", escaped(command.ownName()),
                                escaped(command.description));
        } else {
            text += std::format(".SS {}\n{}.PP\n{}\n{}{}", escaped(command.name), synopsis(command),
                                escaped(command.description), optionList(command.places),
                                optionList(command.options));
        }
    }
    return text;
}

std::string exampleList(const std::vector<std::string>& examples) {
    std::string text = ".EX\n";
    for (const std::string& line : examples) {
        text += escaped(trimmed(line)) + "\n";
    }
    return text + ".EE\n";
}

std::string section(std::string_view title, const std::string& text) {
    return text.empty() ? std::string{} : std::format(".SH {}\n{}", title, text);
}

}  // namespace

std::string manualPage(const Program& program, std::span<const std::string> seeAlso) {
    std::string page = program.name;
    std::ranges::replace(page, ' ', '-');
    std::string title = page;
    std::ranges::transform(title, title.begin(), [](unsigned char letter) { return std::toupper(letter); });
    const Footer footer = footerOf(program.footer);
    std::string description = escaped(program.description) + "\n";
    for (const std::string& paragraph : footer.description) {
        description += ".PP\n" + escaped(paragraph) + "\n";
    }
    std::string others;
    for (const std::string& other : seeAlso) {
        others += std::format("{}\\fB{}\\fR(1)", others.empty() ? "" : ",\n", escaped(other));
    }
    return std::format(".TH {} 1 \"\" \"Furrow {}\" \"User Commands\"\n", escaped(title), kVersion) +
           section("NAME",
                   std::format("{} \\- {}\n", escaped(page), escaped(withoutStop(program.description)))) +
           section("SYNOPSIS", synopsis(program)) + section("DESCRIPTION", description) +
           section("ARGUMENTS", optionList(program.places)) +
           section("OPTIONS", optionList(program.options)) + section("COMMANDS", commandList(program)) +
           section("EXAMPLES", footer.examples.empty() ? std::string{} : exampleList(footer.examples)) +
           section("EXIT STATUS",
                   footer.exitStatus.empty() ? std::string{} : escaped(footer.exitStatus) + "\n") +
           section("SEE ALSO", others + "\n");
}

}  // namespace furrow::manual
