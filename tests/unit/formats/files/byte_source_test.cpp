// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Files read at any offset against the bytes that were written, and what is no file against its refusal.
#include "formats/files/byte_source.h"

#include <doctest/doctest.h>

#include <sys/stat.h>

#include "base/parallel.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string random_bytes(size_t n) {
  RandomStream random(1, 1);
  std::string out(n, '\0');
  for (char& c : out) c = static_cast<char>(random.below(256));
  return out;
}

Failure refusal_to_open(const std::string& path) {
  return failure_of([&] { const ByteSource source(path); });
}

}  // namespace

TEST_CASE("byte_source__threads_read_any_range_and_know_the_end") {
  const Folder folder;
  const std::string bytes = random_bytes(5000);
  spill(folder.file("a.bin"), bytes);
  const ByteSource source(folder.file("a.bin"));
  CHECK(source.size() == bytes.size());
  CHECK(source.path() == folder.file("a.bin"));
  Task::Hooks hooks;
  hooks.threads = 4;
  Task task(hooks);
  std::vector<uint8_t> wrong(400, 1);
  parallel_for(task, wrong.size(), 10, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      RandomStream random(2, i);
      const size_t offset = random.below(bytes.size()), n = random.below(bytes.size() - offset + 1);
      std::string part(n, '\0'), longer(n + bytes.size(), '\0');
      source.read(offset, part.data(), n);
      longer.resize(source.read_some(offset, longer.data(), longer.size()));
      wrong[i] = part != bytes.substr(offset, n) || longer != bytes.substr(offset);
    }
  });
  CHECK(wrong == std::vector<uint8_t>(wrong.size(), 0));
  constexpr uint64_t kLargest = ~uint64_t{0};
  CHECK(source.has(0, 5000));
  CHECK(source.has(5000, 0));
  CHECK_FALSE(source.has(1, 5000));
  CHECK_FALSE(source.has(5001, 0));
  CHECK_FALSE(source.has(4999, kLargest));  // their sum is 4998 in 64 bits
  CHECK_FALSE(source.has(kLargest, 1));
}

TEST_CASE("byte_source__a_read_beyond_the_end_names_file_offset_and_bytes") {
  const Folder folder;
  const std::string path = folder.file("short.bin");
  spill(path, random_bytes(100));
  const ByteSource source(path);
  char out[100];
  const auto read = [&](uint64_t offset, size_t n) {
    return failure_of([&] { source.read(offset, out, n); });
  };
  CHECK(read(0, 100).status == Status::kOk);
  const Failure beyond = read(40, 61);
  CHECK(beyond.status == Status::kFormat);
  CHECK(beyond.text == path + ": offset 40: the file ends before the 61 bytes that belong here");
  std::filesystem::resize_file(path, 50);  // another process cuts it
  CHECK(read(0, 50).status == Status::kOk);
  CHECK(read(0, 100).status == Status::kFormat);
  CHECK(source.read_some(45, out, 100) == 5);
}

TEST_CASE("byte_source__opens_regular_files_only_and_waits_for_no_pipe") {
  const Folder folder;
  spill(folder.file("file"), "x");
  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  const Failure missing = refusal_to_open(folder.file("none")),
                below = refusal_to_open(folder.file("file") + "/none"),
                itself = refusal_to_open(folder.file(".")),
                pipe = refusal_to_open(folder.file("pipe"));
  CHECK(missing.status == Status::kNotFound);
  CHECK(missing.text == folder.file("none") + ": cannot open: no such file or folder");
  CHECK(below.status == Status::kNotFound);
  CHECK(itself.status == Status::kIo);
  CHECK(itself.text.ends_with("it is a folder"));
  CHECK(pipe.status == Status::kIo);
  CHECK(pipe.text.ends_with("it is no regular file"));
}

TEST_CASE("byte_source__a_long_path_does_not_push_the_reason_away") {
  const Folder folder;
  std::string path = folder.file("");
  for (int level = 0; level < 4; ++level) {
    path += std::string(200, static_cast<char>('a' + level)) + "/";
    std::filesystem::create_directory(path);
  }
  path += "end.bin";
  spill(path, "x");
  const ByteSource source(path);
  const Failure failure = failure_of([&] { source.refuse(7, "%s of %d", "reason", 12); });
  CHECK(failure.text.ends_with("dddd/end.bin: offset 7: reason of 12"));
  CHECK(failure.text.starts_with("..."));
  CHECK(failure.text.size() < 450);  // 400 of the path
}
