#include "planner/gdal/system_files.h"

#include "planner/core/file_error.h"
#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <format>
#include <memory>

namespace furrow {

namespace {

struct FileCloser {
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

}  // namespace

bool systemFileExists(const std::string& systemPath) {
    VSIStatBufL status;
    return VSIStatL(systemPath.c_str(), &status) == 0;
}

Result<std::string> systemFileStart(const std::string& systemPath, const std::string& where,
                                    std::size_t wanted) {
    registerGdalDrivers();
    const GdalMessages unsaid;
    const std::unique_ptr<VSILFILE, FileCloser> file{VSIFOpenL(systemPath.c_str(), "rb")};
    if (!file) {
        return std::unexpected(readFailed(where, "the file cannot be read", "check that you may read it"));
    }
    std::string bytes;
    // In blocks: the length that a zip states may be wrong, and is not trusted.
    constexpr std::size_t kBlock = 1 << 20;
    while (bytes.size() < wanted) {
        const std::size_t before = bytes.size();
        const std::size_t block = std::min(kBlock, wanted - before);
        bytes.resize(before + block);
        const std::size_t got = VSIFReadL(bytes.data() + before, 1, block, file.get());
        bytes.resize(before + got);
        if (got < block) {
            if (VSIFErrorL(file.get()) != 0) {
                return std::unexpected(readFailed(where, "the file is damaged", "copy or export it again"));
            }
            break;
        }
    }
    return bytes;
}

Result<std::string> systemFileBytes(const std::string& systemPath, const std::string& where) {
    auto bytes = systemFileStart(systemPath, where, kLargestFileBytes + 1);
    if (bytes && bytes->size() > kLargestFileBytes) {
        return std::unexpected(inputRefused(where, "the file is larger than 1 GiB",
                                            "cut it into the days or fields that it holds"));
    }
    return bytes;
}

std::string systemPathInto(const std::string& zip) {
    // Braces keep a name with blanks, brackets or another ".zip" in it in one piece.
    return std::format("/vsizip/{{{}}}", zip);
}

std::optional<std::vector<ListedFile>> filesBelow(const std::string& root, int depth, std::size_t most) {
    registerGdalDrivers();
    const GdalMessages unsaid;
    VSIDIR* listing = VSIOpenDir(root.c_str(), depth, nullptr);
    if (listing == nullptr) {
        return std::nullopt;
    }
    std::vector<ListedFile> files;
    while (const VSIDIREntry* found = files.size() < most ? VSIGetNextDirEntry(listing) : nullptr) {
        if (!VSI_ISDIR(found->nMode)) {
            files.push_back({found->pszName, found->nSize});
        }
    }
    VSICloseDir(listing);
    return files;
}

std::vector<std::string> namesBelow(const std::string& root) {
    const CPLStringList listed{VSIReadDirRecursive(root.c_str())};
    std::vector<std::string> names;
    for (int i = 0; i < listed.size(); ++i) {
        names.emplace_back(listed[i]);
    }
    return names;
}

}  // namespace furrow
