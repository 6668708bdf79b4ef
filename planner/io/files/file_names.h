#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace furrow {

/// The first `longest` characters of a text, without what XML cannot hold; '?' for what is no UTF-8.
std::string cutText(std::string_view text, std::size_t longest);

/// In the letters A to Z, digits, blank, '-' and '_': umlauts written out, accents left out, '_' for the
/// rest.
std::string asciiText(std::string_view text);

/// A text as the name of one file or folder on any system, never one that leads elsewhere: no separators, no
/// characters that Windows refuses, no dots or blanks at its ends, no name of a device, at most 60 bytes.
/// `otherwise` where nothing is left.
std::string safeFileName(std::string_view text, std::string_view otherwise);

/// Names of one list, cut and unequal even after that, capitals or not.
class UniqueNames {
public:
    UniqueNames() = default;
    UniqueNames(std::size_t longest, bool ascii) : longest_{longest}, ascii_{ascii} {}
    std::string unique(std::string_view wanted, std::string_view otherwise);

private:
    std::size_t longest_ = 32;
    bool ascii_ = false;
    std::set<std::string> used_;  ///< in small letters
};

}  // namespace furrow
