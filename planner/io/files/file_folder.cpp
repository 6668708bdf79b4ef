#include "planner/io/files/file_folder.h"

#include "planner/core/file_error.h"
#include "planner/core/text.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <system_error>
#include <tuple>

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 10'000;
// macOS adds one of its own to each.
constexpr std::size_t kMostListed = 2 * kMostEntries;

// Text of machines shrinks to a twentieth at best, tables of blanks to a hundredth; what shrinks further was
// made to fill memories. Deflate cannot do more than 1,032.
constexpr std::uintmax_t kMostExpansion = 300;
constexpr std::uintmax_t kHarmlessBytes = std::uintmax_t{64} << 20;
constexpr std::uintmax_t kMostUnpacked = std::uintmax_t{2} << 30;
// A zip lists its files at no cost, however deep they lie.
constexpr int kDeepestInZip = 32;

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
Result<std::vector<FileFolder::Entry>> entriesUnder(const std::string& root, const std::string& where,
                                                    int depth, std::optional<std::uintmax_t> packedBytes) {
    const auto files = filesBelow(root, depth, kMostListed + 1);
    if (!files) {
        return std::unexpected(readFailed(where, "the folder or zip cannot be read",
                                          "it may be damaged; copy or export it again"));
    }
    std::vector<FileFolder::Entry> entries;
    std::uintmax_t bytes = 0;
    for (const ListedFile& file : *files) {
        bytes += file.bytes;
        const std::string_view inner = file.path;
        const std::size_t slash = inner.rfind('/');
        const std::string_view folder = slash == std::string_view::npos ? "" : inner.substr(0, slash);
        const std::string_view name = slash == std::string_view::npos ? inner : inner.substr(slash + 1);
        // What macOS adds for itself.
        if (!folder.starts_with("__MACOSX") && !name.starts_with("._")) {
            entries.push_back({std::string{name}, std::string{folder}, root + "/" + file.path});
        }
    }
    if (entries.size() > kMostEntries || files->size() > kMostListed) {
        return std::unexpected(inputRefused(where, message("it holds more than {} files", kMostEntries),
                                            "give the folder of one recording"));
    }
    if (packedBytes && bytes > kHarmlessBytes && bytes / kMostExpansion > *packedBytes) {
        return std::unexpected(inputRefused(where,
                                            "it would grow more than three hundredfold when it is unpacked",
                                            "this is no zip of fields or recordings"));
    }
    if (packedBytes && bytes > kMostUnpacked) {
        return std::unexpected(inputRefused(where, "it would take more than 2 GiB when it is unpacked",
                                            "unpack it and give one of its files"));
    }
    std::ranges::sort(entries, {},
                      [](const FileFolder::Entry& entry) { return std::tie(entry.folder, entry.name); });
    return entries;
}

}  // namespace

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
    const bool isDirectory = fs::is_directory(path);
    const std::string root = isDirectory ? absolute : systemPathInto(absolute);
    std::error_code failed;
    const std::uintmax_t bytes = fs::file_size(path, failed);
    auto entries = entriesUnder(root.ends_with('/') ? root.substr(0, root.size() - 1) : root, path.string(),
                                isDirectory ? depth : std::max(depth, kDeepestInZip),
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

std::vector<const FileFolder::Entry*> FileFolder::called(std::string_view name) const {
    std::vector<const Entry*> found;
    for (const Entry& entry : entries_) {
        if (inSmallLetters(entry.name) == name) {
            found.push_back(&entry);
        }
    }
    return found;
}

std::string FileFolder::placeOf(const Entry& entry) const {
    return entry.folder.empty() ? message("{}, {}", name_, entry.name)
                                : message("{}, {}/{}", name_, entry.folder, entry.name);
}

Result<std::string> FileFolder::readText(const Entry& entry, std::size_t most) const {
    auto text = systemFileStart(entry.systemPath, placeOf(entry), most + 1);
    return text && text->size() > most ? std::unexpected(tooLargeText(placeOf(entry), most))
                                       : std::move(text);
}

Result<std::string> FileFolder::read(const Entry& entry) const {
    return systemFileBytes(entry.systemPath, placeOf(entry));
}

}  // namespace furrow
