// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/data_set.h"

#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

namespace fs = std::filesystem;

void put(ept::DataSet& set, const std::string& text) {
  set.write(ept::kDataFolder, "0-0-0-0.bin", text.data(), text.size());
  set.write(ept::kHierarchyFolder, "0-0-0-0.json", text.data(), text.size());
}

// Of a data set that is whole and alone in its folder; "" where it is not.
std::string text_of(const std::string& folder) {
  const std::string text = slurp(folder + "/ept.json");
  const bool is_whole = slurp(folder + "/ept-data/0-0-0-0.bin") == text &&
                        slurp(folder + "/ept-hierarchy/0-0-0-0.json") == text;
  return is_whole && std::distance(fs::directory_iterator(folder), {}) == 3 ? text : "";
}

void write_set(const std::string& folder, const std::string& text) {
  ept::DataSet set(folder + "/ept.json");
  put(set, text);
  set.commit(text);
}

}  // namespace

TEST_CASE("ept_data_set__appears_whole_and_replaces_the_old_one_whole") {
  const Folder folder;
  const std::string out = folder.file("out");
  write_set(out, "first");
  CHECK(text_of(out) == "first");
  spill(out + "/ept-data/9-0-0-0.bin", "of a deeper tree");
  write_set(out, "second");
  CHECK(text_of(out) == "second");
  CHECK(!fs::exists(out + "/ept-data/9-0-0-0.bin"));
}

TEST_CASE("ept_data_set__without_commit_there_is_what_was_there_before") {
  const Folder folder;
  const std::string out = folder.file("out");
  {
    ept::DataSet set(out + "/ept.json");
    put(set, "never");
  }
  CHECK(folder.entries() == 0);
  write_set(out, "old");
  {
    ept::DataSet set(out + "/ept.json");
    put(set, "never");
  }
  CHECK(text_of(out) == "old");
}

TEST_CASE("ept_data_set__a_commit_that_fails_half_way_gives_the_old_one_back") {
  const Folder folder;
  const std::string out = folder.file("out");
  write_set(out, "old");
  {
    ept::DataSet set(out + "/ept.json");
    put(set, "new");
    fs::remove_all(out + "/.jalon-ept-0/ept-hierarchy");  // the second folder to be moved
    const Failure failure = failure_of([&] { set.commit("new"); });
    CHECK(failure.status == Status::kIo);
    CHECK(has_text(failure.text, "ept-hierarchy"));
  }
  CHECK(text_of(out) == "old");
}

TEST_CASE("ept_data_set__what_a_killed_writer_left_goes_and_two_at_once_keep_apart") {
  const Folder folder;
  const std::string out = folder.file("out");
  fs::create_directories(out + "/.jalon-ept-0/ept-data");
  spill(out + "/.jalon-ept-0/ept-data/5-0-0-0.bin", "left");
  spill(out + "/.jalon-ept-0/lock", "");
  {
    ept::DataSet a(out + "/ept.json"), b(out + "/ept.json");
    put(a, "a");
    put(b, "b");
    a.commit("a");
    b.commit("b");
  }
  CHECK(text_of(out) == "b");
  CHECK(!fs::exists(out + "/ept-data/5-0-0-0.bin"));
}

TEST_CASE("ept_data_set__other_names_and_folders_that_cannot_be_are_refused") {
  const Folder folder;
  for (const char* name : {"scan.json", "scan.ept.json", "ept"}) {
    const Failure failure = failure_of([&] { ept::DataSet set(folder.file(name)); });
    CHECK(failure.status == Status::kInvalidArgument);
    CHECK(has_text(failure.text, "folder/ept.json"));
  }
  CHECK(failure_of([&] { ept::DataSet set(folder.file("no/where/ept.json")); }).status ==
        Status::kIo);
  spill(folder.file("file"), "");
  CHECK(failure_of([&] { ept::DataSet set(folder.file("file/ept.json")); }).status == Status::kIo);
  CHECK(folder.entries() == 1);
}
