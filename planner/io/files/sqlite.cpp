#include "planner/io/files/sqlite.h"

#include <sqlite3.h>

#include <cstddef>
#include <utility>

namespace furrow {

void SqliteCloser::operator()(sqlite3* database) const {
    sqlite3_close(database);
}

void SqliteCloser::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

SqliteDatabase emptyDatabase() {
    sqlite3* opened = nullptr;
    sqlite3_open(":memory:", &opened);
    return SqliteDatabase{opened};
}

SqliteDatabase databaseIn(std::string& bytes) {
    SqliteDatabase database = emptyDatabase();
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    const bool good =
        sqlite3_deserialize(database.get(), "main", reinterpret_cast<unsigned char*>(bytes.data()), size,
                            size, SQLITE_DESERIALIZE_READONLY) == SQLITE_OK;
    return good ? std::move(database) : nullptr;
}

SqliteDatabase databaseAt(const std::string& path) {
    sqlite3* opened = nullptr;
    std::string name;
    for (const char c : path) {
        name += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
    }
    const std::string uri = "file:" + name + "?mode=ro&immutable=1";
    const bool good =
        sqlite3_open_v2(uri.c_str(), &opened, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr) == SQLITE_OK;
    SqliteDatabase database{opened};
    return good ? std::move(database) : nullptr;
}

SqliteStatement prepared(sqlite3* database, const char* text) {
    sqlite3_stmt* made = nullptr;
    if (database != nullptr) {
        sqlite3_prepare_v2(database, text, -1, &made, nullptr);
    }
    return SqliteStatement{made};
}

std::string_view textAt(sqlite3_stmt* statement, int column) {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
    return text == nullptr ? std::string_view{} : std::string_view{text, size};
}

std::string_view bytesAt(sqlite3_stmt* statement, int column) {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement, column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
    return bytes == nullptr ? std::string_view{} : std::string_view{bytes, size};
}

}  // namespace furrow
