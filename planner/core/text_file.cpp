#include "planner/core/text_file.h"

#include "planner/core/file_error.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

namespace furrow {

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

Result<std::string> writtenText(const std::filesystem::path& path, const Message& remedy) {
    constexpr std::size_t kMostBytes = std::size_t{16} << 20;
    std::error_code status;
    if (!std::filesystem::exists(path, status)) {
        return std::unexpected(readFailed(path.string(), "there is no such file", "check the path"));
    }
    if (std::filesystem::is_directory(path, status)) {
        return std::unexpected(readFailed(path.string(), "this is a folder", remedy));
    }
    std::ifstream file{path, std::ios::binary};
    std::string text;
    std::array<char, 1 << 16> block{};
    while (file && text.size() <= kMostBytes) {
        file.read(block.data(), block.size());
        text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (text.size() > kMostBytes) {
        return std::unexpected(
            inputRefused(path.string(), "the file is far too large for what it should hold", remedy));
    }
    if (!file.eof()) {
        return std::unexpected(
            readFailed(path.string(), "the file cannot be read", "check that you may read it"));
    }
    return text;
}

Message lineAndColumn(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t lineBreak = before.rfind('\n');
    return message("line {}, column {}", std::ranges::count(before, '\n') + 1,
                   before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1);
}

}  // namespace furrow
