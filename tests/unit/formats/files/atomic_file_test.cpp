// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "formats/files/atomic_file.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("atomic_file__without_commit_nothing_changes") {
  const Folder folder;
  spill(folder.file("a"), "old");
  {
    AtomicFile file(folder.file("a"));
    file.write("new");
  }
  CHECK(slurp(folder.file("a")) == "old");
  CHECK(folder.entries() == 1);
  AtomicFile file(folder.file("a"));
  file.write("new one");
  file.rewrite(0, "N", 1);
  file.commit();
  CHECK(slurp(folder.file("a")) == "New one");
  CHECK(folder.entries() == 1);
}

TEST_CASE("atomic_file__keeps_links_and_rights") {
  const Folder folder;
  spill(folder.file("a"), "old");
  ::chmod(folder.file("a").c_str(), 0600);
  std::filesystem::create_symlink("a", folder.file("link"));
  AtomicFile file(folder.file("link"));
  file.write("new");
  file.commit();
  CHECK(slurp(folder.file("a")) == "new");
  CHECK(std::filesystem::is_symlink(folder.file("link")));
  struct stat info {};
  ::stat(folder.file("a").c_str(), &info);
  CHECK((info.st_mode & 0777) == 0600);
}

TEST_CASE("atomic_file__refuses_folders_devices_and_missing_places") {
  const Folder folder;
  for (const std::string& path :
       {folder.file(""), folder.file("no/such/a"), std::string("/dev/null"), std::string()}) {
    const Failure failure = failure_of([&] { AtomicFile file(path); });
    CHECK(failure.status == Status::kIo);
    CHECK(failure.text.find('\n') == std::string::npos);
  }
  CHECK(folder.entries() == 0);
}

TEST_CASE("writers__a_full_disk_leaves_the_old_file_and_one_line") {
  const Folder folder;
  const Cloud cloud = random_points(200000, 1);
  for (const char* name : {"a.las", "a.ply", "a.xyz"}) {
    spill(folder.file(name), "good");
    // A limit on the size of files stands in for the full disk; it is the child's own.
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{100000, 100000};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      const Failure failure = failure_of([&] { write(cloud, folder.file(name)); });
      ::_exit(failure.status == Status::kIo && failure.text.find("too large") != std::string::npos
                  ? 0
                  : 1);
    }
    int state = 0;
    ::waitpid(child, &state, 0);
    CHECK(state == 0);
    CHECK(slurp(folder.file(name)) == "good");
  }
  CHECK(folder.entries() == 3);
}

TEST_CASE("atomic_file__what_was_written_can_be_read_back_and_written_over") {
  const Folder folder;
  AtomicFile file(folder.file("a"));
  file.write("0123456789");
  char back[8] = {};
  CHECK(file.read_back(4, back, 8) == 6);
  CHECK(std::string(back, 6) == "456789");
  file.rewrite(4, "xy", 2);
  file.write("end");
  CHECK(file.read_back(3, back, 8) == 8);
  CHECK(std::string(back, 8) == "3xy6789e");
  file.commit();
  CHECK(slurp(folder.file("a")) == "0123xy6789end");
}

TEST_CASE("writers__a_cancelled_write_leaves_the_old_file") {
  const Folder folder;
  const Cloud cloud = random_points(200000, 1);
  for (const char* name : {"a.las", "a.ply", "a.csv"}) {
    spill(folder.file(name), "good");
    std::atomic<bool> cancel{true};
    Task::Hooks hooks;
    hooks.cancel = &cancel;
    Task task(hooks);
    CHECK(failure_of([&] { write_cloud(cloud, folder.file(name), {}, task); }).status ==
          Status::kCancelled);
    CHECK(slurp(folder.file(name)) == "good");
  }
  CHECK(folder.entries() == 3);
}

TEST_CASE("readers__missing_files_folders_and_pipes_are_refused") {
  const Folder folder;
  CHECK(failure_of([&] { read(folder.file("none.las")); }).status == Status::kNotFound);
  CHECK(failure_of([&] { read(folder.file("")); }).status == Status::kIo);
  REQUIRE(::mkfifo(folder.file("pipe.las").c_str(), 0600) == 0);
  CHECK(failure_of([&] { read(folder.file("pipe.las")); }).status == Status::kIo);
  spill(folder.file("empty.ply"), "");
  CHECK(failure_of([&] { read(folder.file("empty.ply")); }).status == Status::kFormat);
  spill(folder.file("wrong.las"), "hello");
  CHECK(failure_of([&] { read(folder.file("wrong.las")); }).status == Status::kFormat);
}
