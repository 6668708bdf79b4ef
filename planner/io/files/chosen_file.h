#pragma once

#include "planner/core/result.h"
#include "planner/io/files/file_folder.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace furrow {

/// A file or folder that somebody chose to be read, looked into as far as telling formats apart takes. Not to
/// be shared between threads: folders are listed when they are asked for.
class ChosenFile {
public:
    /// @param startBytes  of a file that are looked at
    /// @param depth       levels of inner folders of a folder or zip that are looked into
    ChosenFile(std::filesystem::path path, std::size_t startBytes, int depth);

    const std::filesystem::path& path() const { return path_; }
    /// Small letters of ASCII, without folders.
    std::string name() const;

    bool isDirectory() const { return isDirectory_; }
    /// A directory, but for those that are one file to people (".gdb").
    bool isFolder() const;
    /// By its first bytes.
    bool isZip() const;
    /// A folder, or a zip that stands for one: a KMZ is one file.
    bool holdsFiles() const;

    /// The first bytes of a file; of a folder, or where it cannot be read, why.
    const Result<std::string>& start() const { return start_; }
    /// The same as text, without a byte order mark; empty where there is none.
    std::string_view text() const;
    bool isXml() const;
    /// The name of the first element of an XML text; empty where it is none.
    std::string xmlRoot() const;
    /// A text without characters that no text has, and no XML.
    bool isPlainText() const;

    /// The files in a folder or zip.
    const Result<FileFolder>& inside() const;
    /// The files beside a file, not those in folders below.
    const Result<FileFolder>& beside() const;
    std::filesystem::path folderAround() const;

private:
    std::filesystem::path path_;
    int depth_;
    bool isDirectory_ = false;
    Result<std::string> start_;
    mutable std::optional<Result<FileFolder>> inside_;
    mutable std::optional<Result<FileFolder>> beside_;
};

}  // namespace furrow
