// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

struct sqlite3;
struct sqlite3_stmt;

// The only place that asks SQLite, an optional component: sqlite_database.cpp or sqlite_absent.cpp is compiled.
namespace jalon {

/// Whether this library was built with SQLite.
bool has_sqlite();
/// Error(kUnsupported), naming what to install, in a library without it.
void require_sqlite(const std::string& path, const char* format);

namespace gpkg {

struct Blob {
  std::string bytes;
};
/// NULL, a number, a text in UTF-8, or bytes.
using Value = std::variant<std::monostate, int64_t, double, std::string, Blob>;

/// A database in memory: no file of SQLite's own is ever beside the target, and what goes wrong with that is told as by
/// every other writer. What SQLite refuses is Error(kInternal), too little memory std::bad_alloc.
class Database {
 public:
  Database();
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Statements without values, separated by semicolons.
  void run(const std::string& sql);
  /// Gives the bytes of the database file to a function.
  template <class F>
  void give_bytes(F&& take) const {
    const Image image(database_);
    take(image.bytes());
  }

 private:
  friend class Insertion;
  class Image {
   public:
    explicit Image(sqlite3* database);
    ~Image();
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;
    std::string_view bytes() const { return {data_, size_}; }

   private:
    char* data_ = nullptr;
    size_t size_ = 0;
  };
  sqlite3* database_ = nullptr;
};

/// One statement that is run for many rows: a ? for each value.
class Insertion {
 public:
  Insertion(const Database& database, const std::string& sql);
  ~Insertion();
  Insertion(const Insertion&) = delete;
  Insertion& operator=(const Insertion&) = delete;

  void add(std::span<const Value> values);

 private:
  sqlite3* database_ = nullptr;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace gpkg

}  // namespace jalon
