#include "app/manual/program.h"

#include <format>
#include <map>

namespace furrow::manual {

namespace {

/// A text inside of a specification in single quotes.
std::string quoted(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        switch (letter) {
            case '\'': result += "'\\''"; break;
            case '[':
            case ']':
            case ':': result += std::string{"\\"} + letter; break;
            case '\n': result += ' '; break;
            default: result += letter;
        }
    }
    return result;
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) {
        all += (all.empty() ? "" : " ") + word;
    }
    return all;
}

class Writer {
public:
    explicit Writer(const Program& program) { addFunction(program); }

    std::string text() const {
        std::string all;
        for (const auto& [name, body] : functions_) {
            all += std::format("{}() {{\n{}}}\n\n", name, body);
        }
        return all;
    }

private:
    /// A function that offers what is more than one list of words.
    std::string helper(const Argument& argument, const std::string& body) {
        const std::string name = std::format("_furrow_offer_{}", argument.names.back().substr(2));
        functions_[name] = body;
        return name;
    }
    std::string action(const Argument& argument) {
        const std::string words = joined(argument.words);
        switch (argument.offer) {
            case Offer::Nothing: return " ";
            case Offer::Words: return std::format("({})", words);
            case Offer::WordList: return std::format("_sequence compadd - {}", words);
            case Offer::File: return "_files";
            case Offer::Folder: return "_files -/";
            case Offer::WordOrFile:
                return helper(argument, std::format("    compadd -- {}\n    _files\n", words));
            case Offer::KeyAndValue:
                return helper(argument,
                              std::format("    local -a all=({})\n"
                                          "    if compset -P '*='; then\n"
                                          "        compadd -- ${{${{(M)all:#$IPREFIX*}}#$IPREFIX}}\n"
                                          "    else\n"
                                          "        compadd -S = -- ${{(u)${{all%%=*}}}}\n"
                                          "    fi\n",
                                          words));
        }
        return " ";
    }
    std::string specification(const Argument& option) {
        const std::string value =
            option.takesValue() ? std::format(":{}:{}", quoted(option.value), action(option)) : "";
        const std::string description = std::format("[{}]{}'", quoted(option.description), value);
        if (option.names.size() == 1) {
            return std::format("'{}{}{}", option.repeated ? "*" : "", option.names.front(), description);
        }
        std::string names;
        for (const std::string& name : option.names) {
            names += (names.empty() ? "" : ",") + name;
        }
        return std::format("'({})'{{{}}}'{}", joined(option.names), names, description);
    }
    std::string addFunction(const Program& program) {
        const std::string name = "_" + functionName(program.name);
        std::string body = "    local line state\n    _arguments -C";
        for (const Argument& option : program.options) {
            body += " \\\n        " + specification(option);
        }
        for (std::size_t i = 0; i < program.places.size(); ++i) {
            const Argument& place = program.places[i];
            body += std::format(" \\\n        '{}:{}:_files'", place.repeated ? "*" : std::to_string(i + 1),
                                quoted(place.value));
        }
        if (!program.commands.empty()) {
            body +=
                " \\\n        '1:command:->command' '*::argument:->argument'\n    case $state in\n"
                "        command)\n            local -a commands=(\n";
            std::string calls;
            for (const Program& command : program.commands) {
                body +=
                    std::format("                '{}:{}'\n", command.ownName(), quoted(command.description));
                calls += std::format("                {}) {} ;;\n", command.ownName(), addFunction(command));
            }
            body +=
                "            )\n            _describe command commands ;;\n        argument)\n"
                "            case $line[1] in\n" +
                calls + "            esac ;;\n    esac";
        }
        functions_[name] = body + "\n";
        return name;
    }

    std::map<std::string, std::string> functions_;
};

}  // namespace

std::string zshCompletion(const Program& program) {
    const Writer writer{program};
    return std::format(
        "#compdef {0}\n# Completion of {0} for zsh, made from its own help.\n\n{1}_{2} \"$@\"\n",
        program.name, writer.text(), functionName(program.name));
}

}  // namespace furrow::manual
