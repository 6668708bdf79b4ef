#include "planner/gdal/memory_folder.h"

#include <cpl_vsi.h>

#include <atomic>
#include <format>

namespace furrow {

MemoryFolder::MemoryFolder() {
    static std::atomic<unsigned> next{0};
    path_ = std::format("/vsimem/furrow_export_{}", next++);
    VSIMkdir(path_.c_str(), 0755);
}

MemoryFolder::~MemoryFolder() {
    VSIRmdirRecursive(path_.c_str());
}

std::string MemoryFolder::bytes(const std::string& name) const {
    vsi_l_offset size = 0;
    const GByte* start = VSIGetMemFileBuffer(file(name).c_str(), &size, FALSE);
    return start == nullptr
               ? std::string{}
               : std::string{reinterpret_cast<const char*>(start), static_cast<std::size_t>(size)};
}

}  // namespace furrow
