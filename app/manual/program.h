#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace furrow::manual {

/// What a shell offers where a value is asked for.
enum class Offer {
    Nothing,      ///< free text
    Words,        ///< one of `words`
    WordList,     ///< one of `words`, or several divided by commas
    WordOrFile,   ///< one of `words`, or a file
    KeyAndValue,  ///< `words` of the form key=value, or key= where the value is free
    File,
    Folder,
};

/// An option, or with `names` empty an argument that is told by its place.
struct Argument {
    std::vector<std::string> names;  ///< "-h", "--help"
    std::string value;               ///< "TEXT"; empty for a flag
    std::string description;
    bool required = false;
    bool repeated = false;
    Offer offer = Offer::Nothing;
    std::vector<std::string> words;

    bool takesValue() const { return !value.empty(); }
};

/// A program or one of its commands, as its own help describes it.
struct Program {
    std::string name;  ///< "furrow-cli plan"
    std::string description;
    std::vector<Argument> places;
    std::vector<Argument> options;
    std::string footer;
    std::vector<Program> commands;

    /// The last word of the name.
    std::string_view ownName() const { return std::string_view{name}.substr(name.rfind(' ') + 1); }
};

/// furrow-cli with all its commands.
Program commandLineProgram();

/// The window.
Program windowProgram();

/// Sets offer and words of an argument of `program` by its name.
void addOffer(const Program& program, Argument& argument);

/// A page for man, in troff: the program, or one of its commands with the commands below it.
std::string manualPage(const Program& program, std::span<const std::string> seeAlso);

std::string bashCompletion(const Program& program);
std::string zshCompletion(const Program& program);

/// "furrow-cli" as the name of a shell function: "furrow_cli".
std::string functionName(std::string_view program);

}  // namespace furrow::manual
