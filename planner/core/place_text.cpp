#include "planner/core/place_text.h"

#include "planner/core/text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace furrow {

namespace {

constexpr double kMinutes = 60.0;
constexpr double kMostLatDeg = 90.0;
constexpr double kMostLonDeg = 180.0;
constexpr std::size_t kLongest = 200;
// Degrees, minutes, seconds.
constexpr std::string_view kMarks = "d'\"";

/// A number, a letter of the compass, a mark of degrees, minutes or seconds, or a comma between two angles.
struct Token {
    char kind = '#';  ///< '#' a number, "NSEW", one of kMarks, ','
    double value = 0.0;
    bool isNegative = false;
};

/// Signs that are written in several ways become one byte each.
std::string plainSigns(std::string_view text) {
    struct Sign {
        std::string_view written;
        char byte;
    };
    constexpr Sign kSigns[] = {{"°", 'd'},  {"º", 'd'},  {"˚", 'd'},      {"′", '\''},    {"’", '\''},
                               {"´", '\''}, {"″", '"'},  {"”", '"'},      {"''", '"'},    {"−", '-'},
                               {"–", '-'},  {"\t", ' '}, {"\u00a0", ' '}, {"\u202f", ' '}};
    std::string plain{text};
    for (const Sign& sign : kSigns) {
        for (auto at = plain.find(sign.written); at != std::string::npos; at = plain.find(sign.written, at)) {
            plain.replace(at, sign.written.size(), 1, sign.byte);
        }
    }
    return plain;
}

bool isDigit(char letter) {
    return letter >= '0' && letter <= '9';
}

/// Nothing where the text holds anything else.
/// @param comma  in numbers, in the place of the point
std::optional<std::vector<Token>> tokensOf(std::string_view text, bool comma) {
    std::vector<Token> tokens;
    for (std::size_t i = 0; i < text.size();) {
        const char letter = text[i];
        const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
        const bool isSigned = (letter == '-' || letter == '+') && i + 1 < text.size() && isDigit(text[i + 1]);
        if (letter == ' ') {
            ++i;
        } else if (isDigit(letter) || isSigned) {
            std::size_t end = i + 1;
            const auto isPoint = [&](std::size_t k) {
                return k + 1 < text.size() && text[k] == (comma ? ',' : '.') && isDigit(text[k + 1]);
            };
            for (bool hasPoint = false;
                 end < text.size() && (isDigit(text[end]) || (!hasPoint && isPoint(end))); ++end) {
                hasPoint = hasPoint || !isDigit(text[end]);
            }
            const auto value = numberIn(text.substr(i, end - i), comma);
            if (!value) {
                return std::nullopt;
            }
            tokens.push_back({.value = std::abs(*value), .isNegative = letter == '-'});
            i = end;
        } else if (std::string_view{"NSEW"}.contains(capital)) {
            tokens.push_back({.kind = capital});
            ++i;
        } else if (kMarks.contains(letter)) {
            tokens.push_back({.kind = letter});
            ++i;
        } else if (letter == ',' || letter == ';') {
            tokens.push_back({.kind = ','});
            ++i;
        } else {
            return std::nullopt;
        }
    }
    return tokens;
}

bool isCompass(const Token& token) {
    return std::string_view{"NSEW"}.contains(token.kind);
}

/// Degrees with minutes and seconds, each but the last one whole, with a letter before or behind.
struct AngleText {
    double deg = 0.0;
    char compass = ' ';
};

std::optional<AngleText> angleOf(std::span<const Token> tokens) {
    AngleText angle;
    double parts[] = {0.0, 0.0, 0.0};
    std::size_t count = 0;
    bool isNegative = false;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (isCompass(token)) {
            if (angle.compass != ' ' || (i != 0 && i + 1 != tokens.size())) {
                return std::nullopt;
            }
            angle.compass = token.kind;
        } else if (token.kind == '#') {
            const bool mayFollow = count == 0 || (count < 3 && !token.isNegative &&
                                                  parts[count - 1] == std::floor(parts[count - 1]));
            if (!mayFollow || (count > 0 && token.value >= kMinutes)) {
                return std::nullopt;
            }
            isNegative = isNegative || token.isNegative;
            parts[count++] = token.value;
        } else if (count == 0 || token.kind != kMarks[count - 1] || tokens[i - 1].kind != '#') {
            return std::nullopt;
        }
    }
    if (count == 0 || (isNegative && angle.compass != ' ')) {
        return std::nullopt;
    }
    angle.deg = parts[0] + (parts[1] + parts[2] / kMinutes) / kMinutes;
    const bool isWestOrSouth = angle.compass == 'S' || angle.compass == 'W';
    angle.deg = isNegative || isWestOrSouth ? -angle.deg : angle.deg;
    return angle;
}

/// Where the second of two angles begins: behind the comma, at or behind the letter, at the second degree
/// sign's number, at the second number.
std::optional<std::size_t> secondAngleIn(std::span<const Token> tokens) {
    const auto findFrom = [&](std::size_t from, const auto& wanted) -> std::optional<std::size_t> {
        const auto found =
            std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(from), tokens.end(), wanted);
        return found == tokens.end() ? std::nullopt
                                     : std::optional{static_cast<std::size_t>(found - tokens.begin())};
    };
    if (tokens.empty()) {
        return std::nullopt;
    }
    if (const auto comma = findFrom(0, [](const Token& token) { return token.kind == ','; })) {
        return *comma + 1;
    }
    if (isCompass(tokens.front())) {
        return findFrom(1, isCompass);
    }
    if (const auto letter = findFrom(0, isCompass)) {
        return *letter + 1;
    }
    if (const auto first = findFrom(0, [](const Token& token) { return token.kind == 'd'; })) {
        return findFrom(*first + 1, [](const Token& token) { return token.kind == 'd'; })
            .transform([](std::size_t second) { return second - 1; });
    }
    return tokens.size() == 2 ? std::optional<std::size_t>{1} : std::nullopt;
}

std::optional<GeoPoint> placeOf(std::span<const Token> tokens) {
    const auto split = secondAngleIn(tokens);
    if (!split) {
        return std::nullopt;
    }
    auto before = tokens.first(*split);
    if (!before.empty() && before.back().kind == ',') {
        before = before.first(before.size() - 1);
    }
    auto first = angleOf(before);
    auto second = angleOf(tokens.subspan(*split));
    if (!first || !second) {
        return std::nullopt;
    }
    const auto isAlong = [](const AngleText& angle) { return angle.compass == 'E' || angle.compass == 'W'; };
    if (isAlong(*first)) {
        std::swap(first, second);
    }
    // Letters of both, one along each way, or of none.
    const bool hasLetters = first->compass != ' ';
    if (hasLetters != (second->compass != ' ') || (hasLetters && isAlong(*first) == isAlong(*second)) ||
        std::abs(first->deg) > kMostLatDeg || std::abs(second->deg) > kMostLonDeg) {
        return std::nullopt;
    }
    return GeoPoint{.lonDeg = second->deg, .latDeg = first->deg};
}

}  // namespace

std::optional<GeoPoint> placeNamedBy(std::string_view text) {
    constexpr std::string_view kScheme = "geo:";
    text = trimmed(text);
    if (text.size() > kLongest) {
        return std::nullopt;
    }
    if (inSmallLetters(text.substr(0, kScheme.size())) == kScheme) {
        text = text.substr(kScheme.size());
        text = text.substr(0, text.find_first_of(";?"));
    }
    const std::string plain = plainSigns(text);
    for (const bool comma : {true, false}) {
        if (comma && plain.contains('.')) {
            continue;
        }
        const auto tokens = tokensOf(plain, comma);
        if (const auto place = tokens ? placeOf(*tokens) : std::nullopt) {
            return place;
        }
    }
    return std::nullopt;
}

}  // namespace furrow
