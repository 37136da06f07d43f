// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "formats/geopackage/geopackage.h"
#include "unit/formats/fixtures.h"

#ifdef JALON_WITH_SQLITE
#include <sqlite3.h>
#endif

namespace jalon::test {

using Rows = std::vector<std::vector<std::string>>;

/// A GeoPackage as SQLite reads it; nothing is there in a build without SQLite, which skips what asks for it.
class OpenedPackage {
 public:
  explicit OpenedPackage(const Model& model, const WriteSettings& settings = {}) {
    Task task;
    write_geopackage(model, folder_.file("a.gpkg"), settings, task);
#ifdef JALON_WITH_SQLITE
    REQUIRE(sqlite3_open_v2(folder_.file("a.gpkg").c_str(), &database_, SQLITE_OPEN_READONLY,
                            nullptr) == SQLITE_OK);
#endif
  }
#ifdef JALON_WITH_SQLITE
  ~OpenedPackage() { sqlite3_close(database_); }
#endif
  OpenedPackage(const OpenedPackage&) = delete;
  OpenedPackage& operator=(const OpenedPackage&) = delete;

  std::string bytes() const { return slurp(folder_.file("a.gpkg")); }

  /// "-" for NULL.
  Rows rows(const std::string& query) const {
    Rows out;
#ifdef JALON_WITH_SQLITE
    sqlite3_stmt* statement = nullptr;
    REQUIRE(sqlite3_prepare_v2(database_, query.c_str(), -1, &statement, nullptr) == SQLITE_OK);
    while (sqlite3_step(statement) == SQLITE_ROW) {
      out.emplace_back();
      for (int i = 0; i < sqlite3_column_count(statement); ++i) {
        const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement, i));
        const int count = sqlite3_column_bytes(statement, i);
        out.back().push_back(bytes == nullptr ? "-"
                                              : std::string(bytes, static_cast<size_t>(count)));
      }
    }
    REQUIRE(sqlite3_finalize(statement) == SQLITE_OK);
#else
    (void)query;
#endif
    return out;
  }
  /// The only value of a query.
  std::string value(const std::string& query) const {
    const Rows found = rows(query);
    REQUIRE(found.size() == 1);
    REQUIRE(found[0].size() == 1);
    return found[0][0];
  }

 private:
  Folder folder_;
#ifdef JALON_WITH_SQLITE
  sqlite3* database_ = nullptr;
#endif
};

}  // namespace jalon::test
