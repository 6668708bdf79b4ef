#pragma once

#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace furrow {

struct SqliteCloser {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
};
using SqliteDatabase = std::unique_ptr<sqlite3, SqliteCloser>;
using SqliteStatement = std::unique_ptr<sqlite3_stmt, SqliteCloser>;

/// An empty one in memory.
SqliteDatabase emptyDatabase();
/// To read the one that these bytes are, which have to outlive it; null where they are none.
SqliteDatabase databaseIn(std::string& bytes);

/// To read the file, which is left as it is; null where it cannot be opened.
SqliteDatabase databaseAt(const std::string& path);

/// Null where the database is, or does not understand the text.
SqliteStatement prepared(sqlite3* database, const char* text);

/// Of the current row, until the next one is asked for; empty where the column is null.
std::string_view textAt(sqlite3_stmt* statement, int column);
std::string_view bytesAt(sqlite3_stmt* statement, int column);

}  // namespace furrow
