#include "planner/core/separated_text.h"

namespace furrow {

namespace {

constexpr std::string_view kFormulaStarts = "=+-@\t\r";

}  // namespace

std::string_view nextLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

Lines::Lines(std::string_view text) : rest_{text} {}

bool Lines::next(std::string_view& line) {
    if (rest_.empty()) {
        return false;
    }
    const std::size_t end = rest_.find_first_of("\r\n");
    line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
        rest_ = {};
    } else {
        rest_.remove_prefix(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1));
    }
    ++number_;
    return true;
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

std::vector<std::string> quotedCellsOf(std::string_view line, char separator, std::size_t most) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char letter = line[i];
        if (letter == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += line[++i];
        } else if (letter == '"') {
            quoted = !quoted;
        } else if (letter == separator && !quoted) {
            if (cells.size() == most) {
                return cells;
            }
            cells.emplace_back();
        } else {
            cells.back() += letter;
        }
    }
    return cells;
}

std::string asPlainCell(std::string_view text) {
    const bool isFormula = !text.empty() && kFormulaStarts.contains(text.front());
    return (isFormula ? "'" : "") + std::string{text};
}

std::string_view fromPlainCell(std::string_view cell) {
    const bool isQuoted = cell.size() > 1 && cell[0] == '\'' && kFormulaStarts.contains(cell[1]);
    return isQuoted ? cell.substr(1) : cell;
}

}  // namespace furrow
