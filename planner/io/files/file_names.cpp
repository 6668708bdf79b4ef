#include "planner/io/files/file_names.h"

#include "planner/core/text.h"
#include "planner/io/files/file_folder.h"

#include <algorithm>
#include <array>
#include <format>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kLongestFileName = 60;

/// How many bytes the character at the front takes; 0 where these bytes are not UTF-8.
std::size_t characterBytes(std::string_view text) {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    const std::size_t count = lead < 0x80                   ? 1
                              : lead >= 0xC2 && lead < 0xE0 ? 2
                              : lead >= 0xE0 && lead < 0xF0 ? 3
                              : lead >= 0xF0 && lead < 0xF5 ? 4
                                                            : 0;
    if (count == 0 || text.size() < count) {
        return 0;
    }
    for (std::size_t i = 1; i < count; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return 0;
        }
    }
    // Forms that say the same with too many bytes, halves of pairs, beyond the last character.
    if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) >= 0xA0) ||
        (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) >= 0x90)) {
        return 0;
    }
    return count;
}

/// Latin letters with marks, as they are written without.
constexpr std::pair<std::string_view, std::string_view> kPlain[] = {
    {"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"ß", "ss"}, {"Ä", "Ae"}, {"Ö", "Oe"}, {"Ü", "Ue"}, {"æ", "ae"},
    {"ø", "oe"}, {"å", "aa"}, {"Æ", "Ae"}, {"Ø", "Oe"}, {"Å", "Aa"}, {"à", "a"},  {"á", "a"},  {"â", "a"},
    {"ã", "a"},  {"ç", "c"},  {"è", "e"},  {"é", "e"},  {"ê", "e"},  {"ë", "e"},  {"ì", "i"},  {"í", "i"},
    {"î", "i"},  {"ï", "i"},  {"ñ", "n"},  {"ò", "o"},  {"ó", "o"},  {"ô", "o"},  {"õ", "o"},  {"ù", "u"},
    {"ú", "u"},  {"û", "u"},  {"ý", "y"},  {"ÿ", "y"},  {"À", "A"},  {"Á", "A"},  {"Â", "A"},  {"Ã", "A"},
    {"Ç", "C"},  {"È", "E"},  {"É", "E"},  {"Ê", "E"},  {"Ë", "E"},  {"Í", "I"},  {"Î", "I"},  {"Ñ", "N"},
    {"Ó", "O"},  {"Ô", "O"},  {"Õ", "O"},  {"Ú", "U"},  {"Û", "U"},  {"ą", "a"},  {"ć", "c"},  {"č", "c"},
    {"ď", "d"},  {"ę", "e"},  {"ě", "e"},  {"ğ", "g"},  {"ı", "i"},  {"ł", "l"},  {"ń", "n"},  {"ň", "n"},
    {"ő", "o"},  {"ř", "r"},  {"ś", "s"},  {"š", "s"},  {"ş", "s"},  {"ť", "t"},  {"ů", "u"},  {"ű", "u"},
    {"ź", "z"},  {"ż", "z"},  {"ž", "z"},  {"Č", "C"},  {"Ł", "L"},  {"Ř", "R"},  {"Ś", "S"},  {"Š", "S"},
    {"Ž", "Z"},  {"Ż", "Z"}};

/// Takes the next character off the text; a byte that is no UTF-8 alone, with `valid` false.
std::string_view takeCharacter(std::string_view& text, bool& valid) {
    const std::size_t bytes = characterBytes(text);
    valid = bytes > 0;
    const std::string_view character = text.substr(0, std::max<std::size_t>(bytes, 1));
    text.remove_prefix(character.size());
    return character;
}

bool isPlain(char letter) {
    return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z') ||
           (letter >= '0' && letter <= '9') || letter == ' ' || letter == '-' || letter == '_';
}

bool isDevice(std::string_view name) {
    constexpr std::array kDevices = {"con", "prn", "aux", "nul", "conin$", "conout$"};
    const std::string small = inSmallLetters(trimmed(name.substr(0, name.find('.'))));
    const bool numbered = small.size() == 4 && (small.starts_with("com") || small.starts_with("lpt")) &&
                          small[3] >= '0' && small[3] <= '9';
    return numbered || std::ranges::contains(kDevices, small);
}

}  // namespace

std::string cutText(std::string_view text, std::size_t longest) {
    std::string kept;
    for (std::size_t characters = 0; !text.empty() && characters < longest;) {
        bool valid = false;
        const std::string_view character = takeCharacter(text, valid);
        const bool isControl = character.size() == 1 && valid &&
                               (static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7F);
        const bool isNoCharacter = character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
        if (isControl || isNoCharacter) {
            continue;
        }
        kept += valid ? character : std::string_view{"?"};
        ++characters;
    }
    while (kept.ends_with(' ')) {
        kept.pop_back();
    }
    return kept;
}

std::string asciiText(std::string_view text) {
    std::string plain;
    while (!text.empty()) {
        bool valid = false;
        const std::string_view character = takeCharacter(text, valid);
        const auto known =
            std::ranges::find(kPlain, character, &std::pair<std::string_view, std::string_view>::first);
        if (known != std::end(kPlain)) {
            plain += known->second;
        } else {
            plain += character.size() == 1 && isPlain(character[0]) ? character[0] : '_';
        }
    }
    return plain;
}

std::string safeFileName(std::string_view text, std::string_view otherwise) {
    std::string name;
    while (!text.empty()) {
        bool valid = false;
        const std::string_view character = takeCharacter(text, valid);
        const bool refused =
            !valid || (character.size() == 1 && (static_cast<unsigned char>(character[0]) < 0x20 ||
                                                 std::string_view{"\\/:*?\"<>|\x7F"}.contains(character[0])));
        if (name.size() + character.size() > kLongestFileName) {
            break;
        }
        name += refused ? std::string_view{"_"} : character;
    }
    const std::size_t first = name.find_first_not_of(" .");
    const std::size_t last = name.find_last_not_of(" .");
    name = first == std::string::npos ? std::string{} : name.substr(first, last - first + 1);
    if (isDevice(name)) {
        // What Windows takes for a device it does with any extension, too.
        name.insert(std::min(name.find('.'), name.size()), 1, '_');
    }
    return name.empty() ? std::string{otherwise} : name;
}

std::string UniqueNames::unique(std::string_view wanted, std::string_view otherwise) {
    std::string name = cutText(ascii_ ? asciiText(wanted) : std::string{wanted}, longest_);
    if (name.empty()) {
        name = otherwise;
    }
    std::string tried = name;
    // Folders that differ in capitals only are one on a stick.
    for (int number = 2; !used_.insert(inSmallLetters(tried)).second; ++number) {
        const std::string suffix = std::format(" {}", number);
        tried = cutText(name, longest_ - suffix.size()) + suffix;
    }
    return tried;
}

}  // namespace furrow
