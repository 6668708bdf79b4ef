#pragma once

#include <string>

namespace furrow {

/// A file that is on no disk: made to be written or sent, or taken from a zip.
struct FileInMemory {
    std::string path;  ///< below the folder or zip that it belongs to, with '/' between folders
    std::string bytes;

    friend bool operator==(const FileInMemory&, const FileInMemory&) = default;
};

}  // namespace furrow
