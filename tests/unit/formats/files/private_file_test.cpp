// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Leftovers of killed writers beside a target, and those of writers that are still at work.
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

#include "formats/files/atomic_file.h"
#include "formats/files/private_file.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A process that has written half of a file; it lives until it is killed.
pid_t writer_at_work(const std::string& path) {
  int ready[2];
  REQUIRE(::pipe(ready) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    AtomicFile file(path);
    file.write("half");
    (void)!::write(ready[1], "x", 1);
    for (;;) ::pause();
  }
  char x = 0;
  CHECK(::read(ready[0], &x, 1) == 1);
  ::close(ready[0]);
  ::close(ready[1]);
  return child;
}

void kill_and_wait(pid_t child) {
  ::kill(child, SIGKILL);
  int state = 0;
  ::waitpid(child, &state, 0);
  CHECK(WIFSIGNALED(state));
}

void write_whole(const std::string& path, const char* text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

TEST_CASE("private_file__what_killed_writers_left_is_gone_after_the_next_write") {
  const Folder folder;
  const pid_t first = writer_at_work(folder.file("a.las")),
              second = writer_at_work(folder.file("a.las"));
  CHECK(folder.entries() == 2);
  kill_and_wait(second);
  kill_and_wait(first);
  CHECK(folder.entries() == 2);  // the fault: they stay
  write_whole(folder.file("a.las"), "whole");
  CHECK(folder.entries() == 1);
  CHECK(slurp(folder.file("a.las")) == "whole");
}

TEST_CASE("private_file__a_writer_at_work_keeps_its_file") {
  const Folder folder;
  const pid_t child = writer_at_work(folder.file("a.las"));
  write_whole(folder.file("a.las"), "whole");
  CHECK(folder.entries() == 2);
  const PrivateFile mine = open_private_file(folder.file("a.las"));
  REQUIRE(mine.handle != kNoFile);
  CHECK(folder.entries() == 3);
  close_file(mine.handle);
  kill_and_wait(child);
  write_whole(folder.file("a.las"), "again");
  CHECK(folder.entries() == 1);
}

TEST_CASE("private_file__leaves_other_targets_files_and_folders_alone") {
  const Folder folder;
  kill_and_wait(writer_at_work(folder.file("b.las")));
  spill(folder.file("a.las.part"), "of the user");
  REQUIRE(::mkdir(folder.file("a.las.jalon0.part").c_str(), 0700) == 0);
  write_whole(folder.file("a.las"), "whole");
  CHECK(folder.entries() == 4);
  CHECK(slurp(folder.file("a.las.part")) == "of the user");
}
