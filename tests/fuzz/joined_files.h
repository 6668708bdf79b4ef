#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <format>
#include <fstream>
#include <initializer_list>
#include <string_view>

namespace furrow::fuzz {

/// A folder of this process alone.
inline std::filesystem::path ownFolder() {
    const auto folder = std::filesystem::temp_directory_path() / std::format("fuzz_{}", ::getpid());
    std::filesystem::create_directories(folder);
    return folder;
}

/// Writes what lines "====" divide into one file after the other, as tests/fuzz/run joins them. Files that
/// nothing is left for are empty.
inline void writeDivided(std::string_view text, const std::filesystem::path& folder,
                         std::initializer_list<const char*> names) {
    constexpr std::string_view kDivider = "\n====\n";
    for (const char* name : names) {
        const std::size_t end = std::min(text.find(kDivider), text.size());
        std::ofstream{folder / name, std::ios::binary} << text.substr(0, end);
        text.remove_prefix(std::min(end + kDivider.size(), text.size()));
    }
}

}  // namespace furrow::fuzz
