// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/geopackage/sqlite_database.h"

#include <array>

#include "unit/formats/geopackage/opened_package.h"

using namespace jalon;
using namespace jalon::gpkg;
using namespace jalon::test;

TEST_CASE("sqlite_database__what_it_refuses_is_told_in_its_words") {
  if (!has_sqlite()) return;
  Database database;
  const Failure failure = failure_of([&] { database.run("SELECT * FROM absent"); });
  CHECK(failure.status == Status::kInternal);
  CHECK(failure.text == "SQLite: no such table: absent");
}

TEST_CASE("sqlite_database__gives_the_bytes_of_a_file_with_all_kinds_of_values") {
  if (!has_sqlite()) return;
  Database database;
  database.run("CREATE TABLE t (a, b, c, d, e)");
  {
    Insertion rows(database, "INSERT INTO t VALUES (?, ?, ?, ?, ?)");
    rows.add(std::array<Value, 5>{Value(), int64_t{-3}, 0.5, std::string("\xC3\xA9"),
                                  Blob{std::string("\0x", 2)}});
    rows.add(std::array<Value, 5>{});
  }
  std::string bytes;
  database.give_bytes([&](std::string_view all) { bytes = all; });
  CHECK(bytes.starts_with(std::string("SQLite format 3\0", 16)));
  CHECK(bytes.size() % 4096 == 0);
  CHECK(bytes.find("\xC3\xA9") != std::string::npos);
}

TEST_CASE("sqlite_database__a_library_without_it_names_the_package") {
  if (has_sqlite()) return;
  const Folder folder;
  Task task;
  const Failure failure =
      failure_of([&] { write_geopackage({}, folder.file("a.gpkg"), {}, task); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(failure.text.find("apt install libsqlite3-dev") != std::string::npos);
  CHECK(folder.entries() == 0);
}
