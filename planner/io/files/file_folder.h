#pragma once

#include "planner/core/result.h"
#include "planner/gdal/system_files.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// The bytes of a file, at most `limit` of them where `limit` is given as what is wanted of its beginning.
/// ReadFailed: not there, not readable, a folder. InputRefused: empty, larger than kLargestFileBytes.
Result<std::string> fileBytes(const std::filesystem::path& path);
Result<std::string> fileStart(const std::filesystem::path& path, std::size_t bytes);

/// Whether a file that starts like this is a zip.
bool isZip(std::string_view start);

/// The files of a folder or of a zip, read in memory: nothing is ever written, so that no name inside a zip
/// can lead anywhere.
class FileFolder {
public:
    /// @param path  a folder or a zip
    /// @param depth  levels of inner folders that are looked into; of a zip at least 32
    /// @return ReadFailed: neither, or damaged. InputRefused: more than 10,000 files, a zip that grows more
    ///         than three hundredfold or beyond 2 GiB.
    static Result<FileFolder> open(const std::filesystem::path& path, int depth = 2);

    struct Entry {
        std::string name;        ///< without folders, as written
        std::string folder;      ///< inside the folder or zip; empty at its top
        std::string systemPath;  ///< as GDAL opens it
    };
    /// By folder, then by name.
    const std::vector<Entry>& entries() const { return entries_; }
    /// The first entry of this name, capitals or not, in this inner folder.
    const Entry* find(std::string_view folder, std::string_view name) const;
    /// Every entry of this name, given in small letters, capitals or not, in any inner folder.
    std::vector<const Entry*> called(std::string_view name) const;
    /// "logs.zip, TASKDATA/TLG00001.bin"
    std::string placeOf(const Entry& entry) const;
    /// Of an entry. ReadFailed: damaged. InputRefused: larger than kLargestFileBytes.
    Result<std::string> read(const Entry& entry) const;
    /// The same of a text with fields. InputRefused: larger than `most`.
    Result<std::string> readText(const Entry& entry, std::size_t most) const;

private:
    std::string name_;
    std::vector<Entry> entries_;
};

}  // namespace furrow
