// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What the forms of system_file.h promise, on this system; tests/install/mingw.sh runs the tool with the other.
#include <cerrno>
#include <thread>

#include "formats/files/atomic_file.h"
#include "formats/files/system_file.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("system_file__tells_files_folders_devices_and_nothing") {
  const Folder folder;
  spill(folder.file("a"), "12345");
  CHECK(state_of(folder.file("a")).kind == FileKind::kRegular);
  CHECK(state_of(folder.file("a")).size == 5);
  CHECK(state_of(folder.file("")).kind == FileKind::kFolder);
  CHECK(state_of(std::string("/dev/null")).kind == FileKind::kOther);
  CHECK(state_of(folder.file("none")).kind == FileKind::kNone);
  CHECK(open_to_read(folder.file("none")) == kNoFile);
  CHECK(errno == ENOENT);
}

TEST_CASE("system_file__reads_and_writes_where_it_is_told") {
  const Folder folder;
  const FileHandle out = create_locked(folder.file("a"));
  REQUIRE(out != kNoFile);
  CHECK(write_all(out, "abc", 3));
  CHECK(write_all_at(out, 1, "B", 1));
  CHECK(write_all(out, "def", 3));  // behind what was written last, not behind the B
  CHECK(sync_file(out));
  close_file(out);
  const FileHandle in = open_to_read(folder.file("a"));
  char text[8] = {};
  CHECK(read_at(in, 1, text, 3) == 3);
  CHECK(std::string(text) == "Bcd");
  CHECK(read_at(in, 4, text, 8) == 2);
  CHECK(read_at(in, 6, text, 8) == 0);
  close_file(in);
}

TEST_CASE("system_file__a_locked_file_is_no_leftover_and_an_unlocked_one_is") {
  const Folder folder;
  const FileHandle mine = create_locked(folder.file("a"));
  REQUIRE(mine != kNoFile);
  CHECK(create_locked(folder.file("a")) == kNoFile);
  CHECK(errno == EEXIST);
  remove_unlocked(folder.file("a"));
  CHECK(folder.entries() == 1);
  close_file(mine);
  remove_unlocked(folder.file("a"));
  CHECK(folder.entries() == 0);
}

TEST_CASE("system_file__replaces_while_it_is_open") {
  const Folder folder;
  spill(folder.file("a"), "old");
  const FileHandle mine = create_locked(folder.file("b"));
  CHECK(write_all(mine, "new", 3));
  CHECK(replace_file(folder.file("b"), folder.file("a")));
  close_file(mine);
  CHECK(slurp(folder.file("a")) == "new");
  CHECK(folder.entries() == 1);
  CHECK_FALSE(replace_file(folder.file("b"), folder.file("a")));
  CHECK(errno == ENOENT);
}

TEST_CASE("atomic_file__of_many_writers_of_one_target_each_succeeds") {
  const Folder folder;
  std::vector<std::thread> writers;
  std::vector<std::string> failures(4);
  for (size_t w = 0; w < failures.size(); ++w)
    writers.emplace_back([&, w] {
      const Failure failure = failure_of([&] {
        for (int i = 0; i < 200; ++i) {
          AtomicFile file(folder.file("a"));
          file.write("whole");
          file.commit();
        }
      });
      failures[w] = failure.text;
    });
  for (std::thread& writer : writers) writer.join();
  for (const std::string& failure : failures) CHECK(failure == "");
  CHECK(slurp(folder.file("a")) == "whole");
  CHECK(folder.entries() == 1);
}
