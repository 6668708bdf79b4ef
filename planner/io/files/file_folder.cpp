#include "planner/io/files/file_folder.h"

#include "planner/core/file_error.h"
#include "planner/gdal/drivers.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cstdint>
#include <format>
#include <system_error>
#include <tuple>

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 10'000;

// Text of machines shrinks to a twentieth at best; what shrinks further was made to fill memories.
constexpr std::uintmax_t kMostExpansion = 1000;
constexpr std::uintmax_t kHarmlessBytes = std::uintmax_t{64} << 20;

/// Keeps GDAL from printing.
class Quiet {
public:
    Quiet() { CPLPushErrorHandler(CPLQuietErrorHandler); }
    ~Quiet() { CPLPopErrorHandler(); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

struct FileCloser {
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};

}  // namespace

Result<std::string> systemFileStart(const std::string& systemPath, const std::string& where,
                                    std::size_t wanted) {
    registerGdalDrivers();
    const Quiet quiet;
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

namespace {

Result<void> checkOrdinary(const fs::path& path) {
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (!fs::exists(status)) {
        return std::unexpected(readFailed(path.string(), "there is no such file", "check the path"));
    }
    if (!fs::is_regular_file(status)) {
        return std::unexpected(
            readFailed(path.string(), "this is no ordinary file", "give a file on a disk"));
    }
    if (fs::file_size(path, failed) == 0 && !failed) {
        return std::unexpected(inputRefused(path.string(), "the file is empty", "record or export it again"));
    }
    return {};
}

/// @param packedBytes  of a zip, the size of its file
Result<std::vector<FileFolder::Entry>> entriesUnder(const std::string& root, const std::string& where, int depth,
                                                    std::optional<std::uintmax_t> packedBytes) {
    registerGdalDrivers();
    const Quiet quiet;
    std::vector<FileFolder::Entry> entries;
    VSIDIR* listing = VSIOpenDir(root.c_str(), depth, nullptr);
    if (listing == nullptr) {
        return std::unexpected(readFailed(where, "the folder or zip cannot be read",
                                          "it may be damaged; copy or export it again"));
    }
    bool tooMany = false;
    std::uintmax_t bytes = 0;
    while (const VSIDIREntry* found = VSIGetNextDirEntry(listing)) {
        if (VSI_ISDIR(found->nMode)) {
            continue;
        }
        if (entries.size() == kMostEntries) {
            tooMany = true;
            break;
        }
        bytes += found->nSize;
        const std::string_view inner = found->pszName;
        const std::size_t slash = inner.rfind('/');
        const std::string_view folder = slash == std::string_view::npos ? "" : inner.substr(0, slash);
        const std::string_view name = slash == std::string_view::npos ? inner : inner.substr(slash + 1);
        // What macOS adds for itself.
        if (!folder.starts_with("__MACOSX") && !name.starts_with("._")) {
            entries.push_back({std::string{name}, std::string{folder}, std::format("{}/{}", root, inner)});
        }
    }
    VSICloseDir(listing);
    if (tooMany) {
        return std::unexpected(inputRefused(where, message("it holds more than {} files", kMostEntries),
                                            "give the folder of one recording"));
    }
    if (packedBytes && bytes > kHarmlessBytes && bytes / kMostExpansion > *packedBytes) {
        return std::unexpected(inputRefused(where, "it would grow more than a thousandfold when it is unpacked",
                                            "this is no zip of fields or recordings"));
    }
    std::ranges::sort(entries, {},
                      [](const FileFolder::Entry& entry) { return std::tie(entry.folder, entry.name); });
    return entries;
}

}  // namespace

std::string inSmallLetters(std::string_view text) {
    std::string small{text};
    std::ranges::transform(small, small.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return small;
}

std::string extensionInSmallLetters(const fs::path& path) {
    return inSmallLetters(path.extension().string());
}

bool isZip(std::string_view start) {
    return start.starts_with("PK\x03\x04");
}

Result<std::string> fileBytes(const fs::path& path) {
    if (const auto checked = checkOrdinary(path); !checked) {
        return std::unexpected(checked.error());
    }
    // Absolute, so that no part of the name can be taken for a prefix of GDAL's.
    return systemFileBytes(fs::absolute(path).string(), path.string());
}

Result<std::string> fileStart(const fs::path& path, std::size_t bytes) {
    if (const auto checked = checkOrdinary(path); !checked) {
        return std::unexpected(checked.error());
    }
    return systemFileStart(fs::absolute(path).string(), path.string(), bytes);
}

Result<FileFolder> FileFolder::open(const fs::path& path, int depth) {
    const std::string absolute = fs::absolute(path).lexically_normal().string();
    // Braces keep a name with blanks, brackets or another ".zip" in it in one piece.
    const std::string root = fs::is_directory(path) ? absolute : std::format("/vsizip/{{{}}}", absolute);
    std::error_code failed;
    const std::uintmax_t bytes = fs::file_size(path, failed);
    auto entries = entriesUnder(root.ends_with('/') ? root.substr(0, root.size() - 1) : root, path.string(), depth,
                                failed ? std::nullopt : std::optional{bytes});
    if (!entries) {
        return std::unexpected(entries.error());
    }
    FileFolder folder;
    folder.name_ = path.string();
    folder.entries_ = std::move(*entries);
    return folder;
}

const FileFolder::Entry* FileFolder::find(std::string_view folder, std::string_view name) const {
    const std::string wanted = inSmallLetters(name);
    const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
        return entry.folder == folder && inSmallLetters(entry.name) == wanted;
    });
    return found == entries_.end() ? nullptr : &*found;
}

std::string FileFolder::placeOf(const Entry& entry) const {
    return entry.folder.empty() ? message("{}, {}", name_, entry.name)
                                : message("{}, {}/{}", name_, entry.folder, entry.name);
}

Result<std::string> FileFolder::read(const Entry& entry) const {
    return systemFileBytes(entry.systemPath, placeOf(entry));
}

}  // namespace furrow
