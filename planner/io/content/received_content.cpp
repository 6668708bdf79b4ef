#include "planner/io/content/received_content.h"

#include <charconv>
#include <cmath>

namespace furrow {

std::optional<double> decimalIn(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    const std::size_t last = text.find_last_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    text = text.substr(first, last - first + 1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    return good ? std::optional{value} : std::nullopt;
}

Message badLine(std::size_t number) {
    return message("line {} is not as this format has it", number);
}

Message isNot(std::string_view format) {
    return message("this is no {}", format);
}

Message cannotBeRead() {
    return "its content cannot be read";
}

Message isMissing(std::string_view what) {
    return message("{} is missing", what);
}

Message badCount(std::size_t announced, std::size_t found) {
    return message("{} entries are announced, and {} are there", announced, found);
}

}  // namespace furrow
