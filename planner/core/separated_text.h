#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// Takes the first line from a text, without its end.
std::string_view nextLine(std::string_view& text);

/// The lines of a text without their ends, one after the other, whichever system wrote them.
class Lines {
public:
    explicit Lines(std::string_view text);
    bool next(std::string_view& line);
    std::size_t number() const { return number_; }  ///< of the last one, from 1

private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

/// Between separators, as they stand there; at least one.
std::vector<std::string_view> cellsOf(std::string_view line, char separator);

/// The same where quotes hold separators together and a quote inside them is doubled.
///
/// @param most  what comes after so many cells is left out
std::vector<std::string> quotedCellsOf(std::string_view line, char separator, std::size_t most = 1000);

/// A text as a cell that no spreadsheet takes for a formula: one that begins with =, +, -, @ or a tab gets a
/// quote before it.
std::string asPlainCell(std::string_view text);
/// The text of such a cell.
std::string_view fromPlainCell(std::string_view cell);

}  // namespace furrow
