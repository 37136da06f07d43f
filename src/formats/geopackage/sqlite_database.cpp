// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/sqlite_database.h"

#include <sqlite3.h>

#include <new>

#include "base/error.h"

namespace jalon {

bool has_sqlite() { return true; }
void require_sqlite(const std::string&, const char*) {}

namespace gpkg {

namespace {

void check(sqlite3* database, int code) {
  if (code == SQLITE_OK || code == SQLITE_DONE) return;
  if (code == SQLITE_NOMEM || database == nullptr) throw std::bad_alloc();
  fail(Status::kInternal, "SQLite: %.400s", sqlite3_errmsg(database));
}

/// Binds a value to a mark; texts and bytes live until the row is written.
struct Binder {
  sqlite3_stmt* statement;
  int at;
  int operator()(std::monostate) const { return sqlite3_bind_null(statement, at); }
  int operator()(int64_t value) const { return sqlite3_bind_int64(statement, at, value); }
  int operator()(double value) const { return sqlite3_bind_double(statement, at, value); }
  int operator()(const std::string& text) const {
    return sqlite3_bind_text64(statement, at, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
  }
  int operator()(const Blob& blob) const {
    return sqlite3_bind_blob64(statement, at, blob.bytes.data(), blob.bytes.size(), SQLITE_STATIC);
  }
};

}  // namespace

Database::Database() {
  const int code = sqlite3_open_v2(
      ":memory:", &database_,
      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE,
      nullptr);
  if (code == SQLITE_OK) return;
  sqlite3_close(database_);
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  fail(Status::kInternal, "SQLite: %s", sqlite3_errstr(code));
}

Database::~Database() { sqlite3_close(database_); }

void Database::run(const std::string& sql) {
  check(database_, sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr));
}

Database::Image::Image(sqlite3* database) {
  sqlite3_int64 size = 0;
  data_ = reinterpret_cast<char*>(sqlite3_serialize(database, "main", &size, 0));
  if (data_ == nullptr) throw std::bad_alloc();
  size_ = static_cast<size_t>(size);
}

Database::Image::~Image() { sqlite3_free(data_); }

Insertion::Insertion(const Database& database, const std::string& sql)
    : database_(database.database_) {
  check(database_, sqlite3_prepare_v2(database_, sql.c_str(), -1, &statement_, nullptr));
}

Insertion::~Insertion() { sqlite3_finalize(statement_); }

void Insertion::add(std::span<const Value> values) {
  for (size_t i = 0; i < values.size(); ++i)
    check(database_, std::visit(Binder{statement_, static_cast<int>(i + 1)}, values[i]));
  check(database_, sqlite3_step(statement_));
  check(database_, sqlite3_reset(statement_));
}

}  // namespace gpkg

}  // namespace jalon
