#pragma once

#include "planner/core/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace furrow {

// Files as GDAL opens them: on disks, in its memory, inside zips ("/vsizip/{fields.zip}/field.shp").

/// The largest file that is read into memory at once.
inline constexpr std::size_t kLargestFileBytes = std::size_t{1} << 30;

/// The largest text that is read as a field. What takes it apart needs three to eleven times as much.
inline constexpr std::size_t kLargestFieldText = std::size_t{512} << 20;
inline constexpr std::size_t kLargestFieldXml = std::size_t{128} << 20;

bool systemFileExists(const std::string& systemPath);

/// The bytes of a file, or the first of them; `where` names it in messages.
///
/// @return ReadFailed: not readable, damaged. InputRefused: larger than kLargestFileBytes.
Result<std::string> systemFileBytes(const std::string& systemPath, const std::string& where);
Result<std::string> systemFileStart(const std::string& systemPath, const std::string& where,
                                    std::size_t wanted);

/// InputRefused, for a text of more than `most` bytes.
Error tooLargeText(const std::string& where, std::size_t most);

/// The stated length; nothing where there is no such file.
std::optional<std::uintmax_t> systemFileSize(const std::string& systemPath);

/// A zip's content as a folder.
std::string systemPathInto(const std::string& zip);

struct ListedFile {
    std::string path;  ///< below the folder that is listed
    std::uintmax_t bytes = 0;
};

/// The files below a folder, at most so many, in the order in which the system has them.
///
/// @param depth  levels of inner folders that are looked into
/// @return nothing where it cannot be listed
std::optional<std::vector<ListedFile>> filesBelow(const std::string& root, int depth, std::size_t most);

/// Files and folders at any depth below a folder.
std::vector<std::string> namesBelow(const std::string& root);

}  // namespace furrow
