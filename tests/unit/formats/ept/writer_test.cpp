// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/ept.h"

#include <atomic>
#include <map>

#include "base/json_reader.h"
#include "formats/files/endian.h"
#include "unit/formats/las/copc_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

namespace fs = std::filesystem;

/// The files of a data set by their names.
std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      out[fs::relative(entry.path(), folder).string()] = slurp(entry.path().string());
  return out;
}

std::map<std::string, std::string> written(const Cloud& cloud, unsigned threads = 0) {
  const Folder folder;
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  write_cloud(cloud, folder.file("out/ept.json"), {}, task);
  return files_of(folder.file("out"));
}

const JsonValue& member(const JsonValue& object, const char* name) {
  const JsonValue* found = find_member(object, name);
  REQUIRE(found != nullptr);
  return *found;
}

}  // namespace

TEST_CASE("ept__each_point_is_in_one_node_that_the_hierarchy_counts") {
  const Cloud cloud = wall_and_ground(30000, 31);
  const auto files = written(cloud);
  const std::vector<JsonValue> index = read_json(files.at("ept.json"));
  CHECK(member(index.front(), "points").integer == 30000);
  const std::vector<JsonValue> nodes = read_json(files.at("ept-hierarchy/0-0-0-0.json"));
  std::vector<int> seen(cloud.size());
  size_t count = 0;
  for (const JsonValue& node : JsonChildren(nodes.front())) {
    const std::string& bytes = files.at("ept-data/" + node.name + ".bin");
    REQUIRE(bytes.size() == static_cast<size_t>(node.integer) * 16);
    ++count;
    for (size_t at = 0; at < bytes.size(); at += 16) ++seen[load<uint32_t>(&bytes[at + 12])];
  }
  CHECK(count >= 5);
  CHECK(files.size() == count + 2);
  CHECK(seen == std::vector<int>(cloud.size(), 1));
}

TEST_CASE("ept__has_the_same_bytes_for_any_number_of_threads") {
  const Cloud cloud = wall_and_ground(30000, 32);
  CHECK(written(cloud, 1) == written(cloud, 4));
}

TEST_CASE("ept__tells_a_crs_in_metres_and_no_other") {
  Cloud cloud = random_points(10, 33);
  cloud.crs = std::string("EPSG:2154");
  const std::vector<JsonValue> index = read_json(written(cloud).at("ept.json"));
  const JsonValue& crs = member(index.front(), "srs");
  CHECK(member(crs, "authority").text == "EPSG");
  CHECK(member(crs, "horizontal").text == "2154");
  CHECK(has_text(member(crs, "wkt").text, "Lambert-93"));
  cloud.crs = std::string("EPSG:2263");  // New York in US survey feet
  CHECK(has_text(written(cloud).at("ept.json"), "\"srs\": {}"));
}

TEST_CASE("ept__keeps_which_points_are_whose_stations") {
  Cloud cloud = random_points(10, 34);
  cloud.stations = {{std::string("west"), false, {}, 0, 4}, {std::string("east"), false, {}, 4, 6}};
  const auto files = written(cloud);
  const std::string& index = files.at("ept.json");
  CHECK(has_text(index, "\"jalon_stations\": 1"));
  CHECK(has_text(index, "\"field\": \"station\""));
  CHECK(has_text(index, "\"east\""));
  const std::string& bytes = files.at("ept-data/0-0-0-0.bin");
  int of_first = 0;
  for (size_t at = 12; at < bytes.size(); at += 13) of_first += bytes[at] == 1 ? 1 : 0;
  CHECK(of_first == 4);
}

TEST_CASE("ept__of_no_points_is_a_data_set_too_and_a_cancel_leaves_nothing") {
  const auto files = written(make_cloud(Buffer<double>(0)));
  CHECK(files.size() == 2);
  CHECK(files.at("ept-hierarchy/0-0-0-0.json") == "{\"0-0-0-0\":0}");
  const Folder folder;
  const std::atomic<bool> cancel = true;
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK(failure_of([&] {
          write_cloud(wall_and_ground(30000, 35), folder.file("out/ept.json"), {}, task);
        }).status == Status::kCancelled);
  CHECK(folder.entries() == 0);
}
