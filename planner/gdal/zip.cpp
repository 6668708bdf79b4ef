#include "planner/gdal/zip.h"

#include "planner/gdal/drivers.h"
#include "planner/gdal/memory_folder.h"
#include "planner/gdal/messages.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <format>
#include <memory>

namespace furrow {

namespace {

std::size_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
    std::size_t number = 0;
    for (std::size_t i = size; i-- > 0;) {
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return number;
}

/// The same files give the same bytes: all times are the first that a zip can state, 1980-01-01.
std::string withoutTimes(std::string zip) {
    constexpr std::string_view kFirstTime{"\0\0\x21\0", 4};
    constexpr std::size_t kEndBytes = 22;
    constexpr std::size_t kEntryBytes = 46;
    if (zip.size() < kEndBytes || !zip.substr(zip.size() - kEndBytes).starts_with("PK\x05\x06")) {
        return zip;
    }
    const std::size_t end = zip.size() - kEndBytes;
    std::size_t at = numberAt(zip, end + 16, 4);
    for (std::size_t left = numberAt(zip, end + 10, 2); left > 0 && at + kEntryBytes <= end; --left) {
        const std::size_t local = numberAt(zip, at + 42, 4);
        if (local + 14 > end) {
            return zip;
        }
        zip.replace(at + 12, kFirstTime.size(), kFirstTime);
        zip.replace(local + 10, kFirstTime.size(), kFirstTime);
        at += kEntryBytes + numberAt(zip, at + 28, 2) + numberAt(zip, at + 30, 2) + numberAt(zip, at + 32, 2);
    }
    return zip;
}

}  // namespace

Result<std::string> zipOf(std::span<const FileInMemory> files) {
    const GdalMessages messages;
    const MemoryFolder memory;
    void* zip = CPLCreateZip(memory.file("out.zip").c_str(), nullptr);
    bool good = zip != nullptr;
    for (const FileInMemory& file : files) {
        // What is unsigned in zips is an int here; no file of ours comes near.
        good = good && CPLCreateFileInZip(zip, file.path.c_str(), nullptr) == CE_None &&
               CPLWriteFileInZip(zip, file.bytes.data(), static_cast<int>(file.bytes.size())) == CE_None &&
               CPLCloseFileInZip(zip) == CE_None;
    }
    if (zip != nullptr) {
        good = CPLCloseZip(zip) == CE_None && good;
    }
    if (!good) {
        return std::unexpected(Error{.code = ErrorCode::WriteFailed,
                                     .what = message("the zip cannot be made: {}", messages.failure()),
                                     .where = "",
                                     .remedy = "choose another format"});
    }
    return withoutTimes(memory.bytes("out.zip"));
}

std::vector<FileInMemory> filesInZip(std::string_view zip) {
    registerGdalDrivers();
    const GdalMessages messages;
    const MemoryFolder memory;
    const std::string path = memory.file("in.zip");
    const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> out{VSIFOpenL(path.c_str(), "wb"), VSIFCloseL};
    if (!out || VSIFWriteL(zip.data(), 1, zip.size(), out.get()) != zip.size() ||
        VSIFFlushL(out.get()) != 0) {
        return {};
    }
    const std::string root = "/vsizip/{" + path + "}";
    std::vector<FileInMemory> files;
    const CPLStringList names{VSIReadDirRecursive(root.c_str())};
    for (int i = 0; i < names.size(); ++i) {
        const std::string name = names[i];
        GByte* read = nullptr;
        vsi_l_offset size = 0;
        if (!name.ends_with('/') &&
            VSIIngestFile(nullptr, std::format("{}/{}", root, name).c_str(), &read, &size, -1) != 0) {
            files.push_back(
                {name, std::string{reinterpret_cast<const char*>(read), static_cast<std::size_t>(size)}});
        }
        VSIFree(read);
    }
    return files;
}

}  // namespace furrow
