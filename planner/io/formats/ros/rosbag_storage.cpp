#include "planner/io/formats/ros/rosbag_storage.h"

#include "planner/io/files/byte_reader.h"
#include "planner/io/files/checksum.h"
#include "planner/io/files/sqlite.h"
#include "planner/io/formats/ros/mcap_records.h"

#include <lz4frame.h>
#include <sqlite3.h>
#include <zstd.h>

#include <array>
#include <format>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

// Writers make chunks of a few MiB; what is far above would only fill the memory.
constexpr std::uint64_t kLargestPieceBytes = std::uint64_t{256} << 20U;

using Wants = std::function<bool(std::string_view)>;
using Visit = std::function<Result<void>(const BagMessage&)>;

Error damaged(Message where, Message what) {
    return {.code = ErrorCode::ReadFailed,
            .what = std::move(what),
            .where = where,
            .remedy = "copy it again, or mend it with 'mcap recover' or sqlite3's '.recover'"};
}

Error tooLarge(const std::string& where, std::uint64_t bytes) {
    return {.code = ErrorCode::InputRefused,
            .what = message("a part of it states {} bytes, more than 256 MiB", bytes),
            .where = where,
            .remedy = "record the positions without pictures and point clouds"};
}

// --- MCAP (https://mcap.dev/spec) -------------------------------------------------------------------

std::string_view stringIn(ByteReader& bytes) {
    return bytes.take(bytes.integer<std::uint32_t>());
}

std::optional<std::string> fromZstd(std::string_view packed, std::size_t size) {
    std::string bytes(size, '\0');
    const std::size_t got = ZSTD_decompress(bytes.data(), size, packed.data(), packed.size());
    return ZSTD_isError(got) == 0 && got == size ? std::optional{std::move(bytes)} : std::nullopt;
}

std::optional<std::string> fromLz4(std::string_view packed, std::size_t size) {
    LZ4F_dctx* made = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) {
        return std::nullopt;
    }
    const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context{
        made, &LZ4F_freeDecompressionContext};
    std::string bytes(size, '\0');
    std::size_t written = 0;
    std::size_t read = 0;
    while (read < packed.size() && written < size) {
        std::size_t out = size - written;
        std::size_t in = packed.size() - read;
        const std::size_t hint =
            LZ4F_decompress(context.get(), bytes.data() + written, &out, packed.data() + read, &in, nullptr);
        if (LZ4F_isError(hint) != 0 || (in == 0 && out == 0)) {
            return std::nullopt;
        }
        written += out;
        read += in;
    }
    return written == size ? std::optional{std::move(bytes)} : std::nullopt;
}

class McapReader {
public:
    McapReader(const fs::path& path, const Wants& wants, const Visit& visit, const JobContext& job)
        : where_{path.string()}, file_{path, std::ios::binary}, wants_{wants}, visit_{visit}, job_{job} {
        std::error_code unknown;
        const auto size = fs::file_size(path, unknown);
        size_ = unknown ? 0 : size;
    }

    Result<void> read() {
        std::string magic(kMcapMagic.size(), '\0');
        if (!file_.read(magic.data(), static_cast<std::streamsize>(magic.size())) || magic != kMcapMagic) {
            return std::unexpected(damaged(where_, "this is no MCAP file of version 0"));
        }
        while (true) {
            if (job_.stopRequested()) {
                return std::unexpected(cancelled());
            }
            std::string head(9, '\0');
            if (!file_.read(head.data(), 9)) {
                return std::unexpected(damaged(where_, "the recording is cut off: its end is missing"));
            }
            const auto opcode = static_cast<std::uint8_t>(head[0]);
            const auto length = ByteReader{std::string_view{head}.substr(1)}.integer<std::uint64_t>();
            if (opcode == mcap::kDataEnd || opcode == mcap::kFooter) {
                return {};  // what follows is an index of what was read
            }
            if (auto read = readRecord(opcode, length); !read) {
                return read;
            }
        }
    }

private:
    struct Channel {
        std::string topic;
        std::string type;
        bool wanted = false;
    };

    Result<void> readRecord(std::uint8_t opcode, std::uint64_t length) {
        const bool needed = opcode == mcap::kSchema || opcode == mcap::kChannel || opcode == mcap::kMessage ||
                            opcode == mcap::kChunk;
        if (needed && length > kLargestPieceBytes) {
            return std::unexpected(tooLarge(where_, length));
        }
        if (!needed) {
            // A length of nonsense must not lead back to where it was read.
            const auto here = static_cast<std::uint64_t>(file_.tellg());
            if (length > size_ || here > size_ - length) {
                return std::unexpected(damaged(where_, "the recording is cut off in the middle of a record"));
            }
            file_.seekg(static_cast<std::streamoff>(length), std::ios::cur);
            return {};
        }
        std::string body;
        // In blocks: a length that is wrong must not take the memory before the file ends.
        constexpr std::uint64_t kBlock = 1U << 20U;
        while (body.size() < length) {
            const std::size_t before = body.size();
            const auto block = static_cast<std::size_t>(std::min(kBlock, length - before));
            body.resize(before + block);
            if (!file_.read(body.data() + before, static_cast<std::streamsize>(block))) {
                return std::unexpected(damaged(where_, "the recording is cut off in the middle of a record"));
            }
        }
        return opcode == mcap::kChunk ? readChunk(body) : readInner(opcode, body);
    }

    Result<void> readChunk(std::string_view body) {
        ByteReader bytes{body};
        bytes.skip(16);  // times of the first and last message
        const auto size = bytes.integer<std::uint64_t>();
        const auto crc = bytes.integer<std::uint32_t>();
        const std::string_view compression = stringIn(bytes);
        const auto packedSize = bytes.integer<std::uint64_t>();
        if (!bytes.ok() || packedSize > bytes.bytesLeft()) {
            return std::unexpected(damaged(where_, "a chunk of the recording is damaged"));
        }
        if (size > kLargestPieceBytes) {
            return std::unexpected(tooLarge(where_, size));
        }
        const std::string_view packed = bytes.take(packedSize);
        std::optional<std::string> unpacked;
        if (compression == "zstd" || compression == "lz4") {
            unpacked = compression == "zstd" ? fromZstd(packed, size) : fromLz4(packed, size);
            if (!unpacked) {
                return std::unexpected(damaged(where_, "a compressed chunk of the recording is damaged"));
            }
        } else if (!compression.empty()) {
            return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                         .what = message("its compression '{}' is not known", compression),
                                         .where = where_,
                                         .remedy = "record with zstd, lz4 or no compression"});
        }
        const std::string_view records = unpacked ? std::string_view{*unpacked} : packed;
        if (crc != 0 && crc32Of(records) != crc) {
            return std::unexpected(damaged(where_, "a chunk of the recording has a wrong checksum"));
        }
        return readRecords(records);
    }

    Result<void> readRecords(std::string_view records) {
        ByteReader bytes{records};
        while (bytes.bytesLeft() > 0) {
            const auto opcode = bytes.integer<std::uint8_t>();
            const auto length = bytes.integer<std::uint64_t>();
            const std::string_view body = bytes.take(length);
            if (!bytes.ok()) {
                return std::unexpected(damaged(where_, "a chunk of the recording is cut off"));
            }
            if (auto read = readInner(opcode, body); !read) {
                return read;
            }
        }
        return {};
    }

    Result<void> readInner(std::uint8_t opcode, std::string_view body) {
        ByteReader bytes{body};
        if (opcode == mcap::kSchema) {
            const auto id = bytes.integer<std::uint16_t>();
            schemas_[id] = std::string{stringIn(bytes)};
        } else if (opcode == mcap::kChannel) {
            const auto id = bytes.integer<std::uint16_t>();
            const auto schema = schemas_.find(bytes.integer<std::uint16_t>());
            Channel& channel = channels_[id];
            channel.topic = stringIn(bytes);
            channel.type = schema == schemas_.end() ? std::string{} : schema->second;
            channel.wanted = stringIn(bytes) == "cdr" && wants_(channel.type);
        } else if (opcode == mcap::kMessage) {
            const auto channel = channels_.find(bytes.integer<std::uint16_t>());
            bytes.skip(4);
            const auto recorded = bytes.integer<std::uint64_t>();
            bytes.skip(8);
            if (bytes.ok() && channel != channels_.end() && channel->second.wanted) {
                return visit_({.topic = channel->second.topic,
                               .type = channel->second.type,
                               .recordedNs = static_cast<std::int64_t>(recorded),
                               .data = bytes.take(bytes.bytesLeft())});
            }
        }
        return bytes.ok() ? Result<void>{}
                          : std::unexpected(damaged(where_, "a record of the recording is damaged"));
    }

    std::string where_;
    std::ifstream file_;
    std::uint64_t size_ = 0;  ///< of the file
    const Wants& wants_;
    const Visit& visit_;
    const JobContext& job_;
    std::map<std::uint16_t, std::string> schemas_;
    std::map<std::uint16_t, Channel> channels_;
};

// --- sqlite3 ----------------------------------------------------------------------------------------

/// As a URI: nothing is written beside the file, unless changes still wait there.
std::string uriOf(const fs::path& path) {
    std::string uri = "file:";
    for (const char letter : fs::absolute(path).string()) {
        if (letter == '?' || letter == '#' || letter == '%') {
            uri += std::format("%{:02X}", static_cast<unsigned>(letter));
        } else {
            uri += letter;
        }
    }
    return uri + (fs::exists(path.string() + "-wal") ? "?mode=ro" : "?mode=ro&immutable=1");
}

/// What may be wrong with a database, or that nobody wants it any more.
Error unreadable(const SqliteDatabase& database, const std::string& where, const JobContext& job) {
    return job.stopRequested()
               ? cancelled()
               : damaged(where, message("it is no rosbag2 that can be read ({})",
                                        database ? sqlite3_errmsg(database.get()) : "no memory"));
}

/// Nothing where the system cannot open it; `database` says why.
bool openBag(const fs::path& path, SqliteDatabase& database, const JobContext& job) {
    sqlite3* opened = nullptr;
    const int status =
        sqlite3_open_v2(uriOf(path).c_str(), &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    database.reset(opened);
    if (status != SQLITE_OK) {
        return false;
    }
    // A file may hold views and triggers of its own; none of them runs anything.
    sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(opened, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, static_cast<int>(kLargestPieceBytes));
    sqlite3_progress_handler(
        opened, 10'000,
        [](void* context) { return static_cast<const JobContext*>(context)->stopRequested() ? 1 : 0; },
        const_cast<JobContext*>(&job));
    return true;
}

struct BagTopic {
    std::string name;
    std::string type;
};

/// The topics that are wanted by their numbers; nothing where they cannot be read.
std::optional<std::map<std::int64_t, BagTopic>> wantedTopics(sqlite3* database, const Wants& wants) {
    const SqliteStatement rows =
        prepared(database, "SELECT id, name, type, serialization_format FROM topics");
    std::map<std::int64_t, BagTopic> topics;
    int step = SQLITE_ERROR;
    while (rows && (step = sqlite3_step(rows.get())) == SQLITE_ROW) {
        const std::string type{textAt(rows.get(), 2)};
        if (textAt(rows.get(), 3) == "cdr" && wants(type)) {
            topics[sqlite3_column_int64(rows.get(), 0)] = {std::string{textAt(rows.get(), 1)}, type};
        }
    }
    return step == SQLITE_DONE ? std::optional{std::move(topics)} : std::nullopt;
}

Result<void> visitSqlite(const fs::path& path, const Wants& wants, const Visit& visit,
                         const JobContext& job) {
    const std::string where = path.string();
    SqliteDatabase database;
    if (!openBag(path, database, job)) {
        return std::unexpected(unreadable(database, where, job));
    }
    const auto topics = wantedTopics(database.get(), wants);
    const SqliteStatement rows =
        topics ? prepared(database.get(),
                          "SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id")
               : SqliteStatement{};
    int step = SQLITE_ERROR;
    while (rows && (step = sqlite3_step(rows.get())) == SQLITE_ROW) {
        const auto topic = topics->find(sqlite3_column_int64(rows.get(), 0));
        if (topic == topics->end()) {
            continue;
        }
        if (auto visited = visit({.topic = topic->second.name,
                                  .type = topic->second.type,
                                  .recordedNs = sqlite3_column_int64(rows.get(), 1),
                                  .data = bytesAt(rows.get(), 2)});
            !visited) {
            return visited;
        }
    }
    return step == SQLITE_DONE ? Result<void>{} : std::unexpected(unreadable(database, where, job));
}

}  // namespace

Result<void> visitBag(const fs::path& file, const std::function<bool(std::string_view)>& wants,
                      const std::function<Result<void>(const BagMessage&)>& visit, const JobContext& job) {
    std::array<char, 5> start{};
    std::ifstream probe{file, std::ios::binary};
    if (!probe.read(start.data(), start.size())) {
        return std::unexpected(damaged(file.string(), "the file is empty or cannot be read"));
    }
    const bool isMcap = std::string_view{start.data(), start.size()} == kMcapMagic.substr(0, start.size());
    return isMcap ? McapReader{file, wants, visit, job}.read() : visitSqlite(file, wants, visit, job);
}

}  // namespace furrow
