#include "planner/io/export_content.h"

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

std::string_view nextLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    while (true) {
        const std::size_t end = line.find(separator);
        cells.push_back(line.substr(0, end));
        if (end == std::string_view::npos) {
            return cells;
        }
        line.remove_prefix(end + 1);
    }
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
