#include "planner/core/text_file.h"

#include <algorithm>

namespace furrow {

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

Message lineAndColumn(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t lineBreak = before.rfind('\n');
    return message("line {}, column {}", std::ranges::count(before, '\n') + 1,
                   before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1);
}

}  // namespace furrow
