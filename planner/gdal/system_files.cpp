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

Error tooLargeText(const std::string& where, std::size_t most) {
    return inputRefused(where,
                        message("a text with fields may take {} MiB, and this one takes more", most >> 20),
                        "cut it into parts, or export it as a GeoPackage");
}

std::optional<std::uintmax_t> systemFileSize(const std::string& systemPath) {
    VSIStatBufL status;
    return VSIStatL(systemPath.c_str(), &status) == 0 ? std::optional<std::uintmax_t>{status.st_size}
                                                      : std::nullopt;
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
    int open = 0;
    for (const char c : zip) {
        open += c == '{' ? 1 : 0;
        if (c == '}' && --open < 0) {
            break;
        }
    }
    // Braces keep a name with blanks, brackets or another ".zip" in it in one piece. With an unpaired one in
    // it GDAL finds the end of the name by ".zip" or ".kmz".
    return open == 0 ? std::format("/vsizip/{{{}}}", zip) : std::format("/vsizip/{}", zip);
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
