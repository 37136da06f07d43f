// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "formats/geopackage/sqlite_database.h"

namespace jalon {

bool has_sqlite() { return false; }
void require_sqlite(const std::string& path, const char* format) {
  fail(Status::kUnsupported,
       "%.400s: %s needs SQLite, which this library was built without: install it (Debian: apt "
       "install libsqlite3-dev) and build with -DJALON_WITH_SQLITE=ON",
       path.c_str(), format);
}

namespace gpkg {

// Never called: require_sqlite() comes before.
Database::Database() = default;
Database::~Database() = default;
void Database::run(const std::string&) {}
Database::Image::Image(sqlite3*) {}
Database::Image::~Image() = default;
Insertion::Insertion(const Database&, const std::string&) {}
Insertion::~Insertion() = default;
void Insertion::add(std::span<const Value>) {}

}  // namespace gpkg

}  // namespace jalon
