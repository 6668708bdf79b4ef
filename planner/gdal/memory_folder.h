#pragma once

#include <string>

namespace furrow {

/// A folder in GDAL's memory that nobody else has; gone with this object.
class MemoryFolder {
public:
    MemoryFolder();
    ~MemoryFolder();
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    const std::string& path() const { return path_; }
    /// Where a file of this name is, or would be.
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    /// Of a file in it; empty where there is none.
    std::string bytes(const std::string& name) const;

private:
    std::string path_;
};

}  // namespace furrow
