#include "planner/core/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace furrow {

namespace {

std::optional<double> wholeNumber(std::string_view text,
                                  std::chars_format format = std::chars_format::general) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, format);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

}  // namespace

std::string inSmallLetters(std::string_view text) {
    std::string small{text};
    std::ranges::transform(small, small.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return small;
}

std::string extensionInSmallLetters(const std::filesystem::path& path) {
    return inSmallLetters(path.extension().string());
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<double> numberIn(std::string_view text, bool decimalComma) {
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    std::string withPoint;
    if (decimalComma && text.find(',') != std::string_view::npos) {
        withPoint = text;
        std::ranges::replace(withPoint, ',', '.');
        text = withPoint;
    }
    return wholeNumber(text);
}

std::optional<double> decimalIn(std::string_view text) {
    const auto value = wholeNumber(trimmed(text));
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> plainDecimalIn(std::string_view text) {
    const auto value = wholeNumber(text, std::chars_format::fixed);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace furrow
