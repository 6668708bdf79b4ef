#include "app/manual/program.h"

#include <format>
#include <functional>
#include <map>

namespace furrow::manual {

namespace {

// @ stands for the name of the function, ~ for the patterns of its commands.
constexpr std::string_view kHelpers = R"(# Offers words, also after commas.
@_list() {
    local before=''
    [[ $1 != *,* ]] || before=${1%,*},
    mapfile -t COMPREPLY < <(compgen -P "$before" -W "$2" -- "${1##*,}")
    compopt -o nospace
}

# Offers the keys of words of the form key=value, and the values of a key that is there.
@_assignments() {
    local current=$1 key=$2 word words=''
    for word in $3; do
        if [[ -z $key ]]; then
            [[ " $words" == *" ${word%%=*}= "* ]] || words+="${word%%=*}= "
        elif [[ $word == "$key="* ]]; then
            words+="${word#*=} "
        fi
    done
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    [[ -n $key ]] || compopt -o nospace
}

)";

constexpr std::string_view kBegin = R"(@() {
    local command='' current=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]} key='' i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$command/${COMP_WORDS[i]}" in
            ~) command=${command:+$command }${COMP_WORDS[i]} ;;
        esac
    done
    # The shell makes three words of --option=value and of key=value.
    if [[ $current == = ]]; then
        key=$option option=${COMP_WORDS[COMP_CWORD-2]} current=''
    elif [[ $option == = && $COMP_CWORD -gt 3 ]]; then
        key=${COMP_WORDS[COMP_CWORD-2]} option=${COMP_WORDS[COMP_CWORD-3]}
    fi
    if [[ $key == --* ]]; then
        option=$key key=''
    fi
    COMPREPLY=()
    case "$command $option" in
)";

std::string replaced(std::string_view text, char mark, const std::string& by) {
    std::string result;
    for (const char letter : text) {
        result += letter == mark ? by : std::string{letter};
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

std::string offerOf(const Argument& argument, const std::string& function) {
    const std::string words = joined(argument.words);
    switch (argument.offer) {
        case Offer::Nothing: return ":";
        case Offer::Words:
            return std::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$current\")", words);
        case Offer::WordList: return std::format("{}_list \"$current\" '{}'", function, words);
        case Offer::KeyAndValue:
            return std::format("{}_assignments \"$current\" \"$key\" '{}'", function, words);
        case Offer::WordOrFile:
            return std::format(
                "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -W '{}' -f -- \"$current\")", words);
        case Offer::File: return "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$current\")";
        case Offer::Folder:
            return "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- \"$current\")";
    }
    return ":";
}

/// The words after the program's own: "list fields".
std::string commandOf(const Program& program) {
    const std::size_t blank = program.name.find(' ');
    return blank == std::string::npos ? std::string{} : program.name.substr(blank + 1);
}

void forEach(const Program& program, const std::function<void(const Program&)>& visit) {
    visit(program);
    for (const Program& command : program.commands) {
        forEach(command, visit);
    }
}

}  // namespace

std::string bashCompletion(const Program& program) {
    const std::string function = "_" + functionName(program.name);
    std::string ways;
    std::string options;
    std::string rest;
    std::map<std::string, std::string> patternsByOffer;
    forEach(program, [&](const Program& each) {
        std::vector<std::string> names;
        std::vector<std::string> commands;
        for (const Program& command : each.commands) {
            ways += std::format("{}'{}/{}'", ways.empty() ? "" : " | ", commandOf(each), command.ownName());
            commands.emplace_back(command.ownName());
        }
        for (const Argument& option : each.options) {
            names.push_back(option.names.back());
            if (option.takesValue()) {
                std::string& patterns = patternsByOffer[offerOf(option, function)];
                patterns += std::format("{}'{} {}'", patterns.empty() ? "" : " | ", commandOf(each),
                                        option.names.back());
            }
        }
        options += std::format("            '{}') words='{}' ;;\n", commandOf(each), joined(names));
        if (!commands.empty()) {
            rest += std::format("            '{}') words='{}' ;;\n", commandOf(each), joined(commands));
        }
    });
    std::string text = std::format("# Completion of {} for bash, made from its own help.\n\n", program.name) +
                       replaced(kHelpers, '@', function) +
                       replaced(replaced(kBegin, '@', function), '~', ways.empty() ? "''" : ways);
    for (const auto& [offer, patterns] : patternsByOffer) {
        text += std::format("        {}) {}; return ;;\n", patterns, offer);
    }
    text +=
        "    esac\n    local words=''\n    if [[ $current == -* ]]; then\n        case \"$command\" in\n" +
        options + "        esac\n";
    if (!rest.empty()) {
        text += "    else\n        case \"$command\" in\n" + rest + "        esac\n";
    }
    return text +
           "    fi\n    if [[ -n $words ]]; then\n"
           "        mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
           "    elif [[ $current != -* ]]; then\n"
           "        compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n    fi\n}\n\n" +
           std::format("complete -F {} {}\n", function, program.name);
}

}  // namespace furrow::manual
