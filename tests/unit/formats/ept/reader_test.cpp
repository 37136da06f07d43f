// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>

#include "formats/ept/ept.h"
#include "unit/formats/ept/ept_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Of the point whose number the field "id" is, for each point; coordinates within half a step.
void check_same(const Cloud& cloud, const Cloud& back) {
  REQUIRE(back.size() == cloud.size());
  const std::vector<uint32_t> ids = ids_of(back);
  double worst = 0;
  std::vector<int> seen(cloud.size());
  for (size_t i = 0; i < back.size(); ++i) {
    ++seen[ids[i]];
    for (int k = 0; k < 3; ++k)
      worst = std::max(worst, std::fabs(back.point(i)[k] - cloud.point(ids[i])[k]));
  }
  CHECK(seen == std::vector<int>(cloud.size(), 1));
  CHECK(worst <= 0.00005 + 1e-9);
}

}  // namespace

TEST_CASE("ept_reader__gives_all_points_fields_crs_and_stations_back") {
  Cloud cloud = wall_and_ground(30000, 41);
  RandomStream random(41, 2);
  for (const auto type : {ElementType::kInt8, ElementType::kUint16, ElementType::kInt64,
                          ElementType::kFloat32, ElementType::kFloat64})
    cloud.fields.set(random_column(name_of(type), type, 1, cloud.size(), random));
  cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, cloud.size(), random));
  cloud.fields.set(random_column("intensity", ElementType::kUint16, 1, cloud.size(), random));
  cloud.crs = std::string("EPSG:2154");
  cloud.stations = {{std::string("west"), false, {}, 0, 20000},
                    {std::string("east"), false, {}, 20000, 10000}};
  const EptFolder set(cloud);
  const Cloud back = read(set.path());
  check_same(cloud, back);
  CHECK(back.fields.size() == cloud.fields.size());
  const std::vector<uint32_t> ids = ids_of(back);
  const std::vector<uint64_t> rows(ids.begin(), ids.end());
  for (const ColumnPtr& column : cloud.fields)
    CHECK(same_values(*gather(*column, rows), back.fields.require(column->info().name)));
  CHECK(has_text(back.crs.str(), "Lambert-93"));
  REQUIRE(back.stations.size() == 2);
  CHECK(back.stations[1].name.str() == "east");
  CHECK(back.stations[1].count == 10000);
  CHECK(std::all_of(ids.begin(), ids.begin() + 20000, [](uint32_t id) { return id < 20000; }));
}

TEST_CASE("ept_reader__a_box_and_a_spacing_read_their_nodes_alone") {
  const Cloud cloud = wall_and_ground(30000, 42);
  const EptFolder set(cloud);
  ReadSettings settings;
  settings.box = {652000, 6861000, 100, 652010, 6861005, 104};
  size_t inside = 0;
  const Cloud whole = read(set.path());
  for (size_t i = 0; i < whole.size(); ++i)
    inside += Box3{{652000, 6861000, 100}, {652010, 6861005, 104}}.contains(whole.point(i)) ? 1 : 0;
  CHECK(inside > 100);
  CHECK(read(set.path(), settings).size() == inside);
  settings = {};
  settings.spacing_m = 1000;
  const size_t root = read(set.path(), settings).size();
  CHECK(root < cloud.size());
  CHECK(root * 16 == std::filesystem::file_size(set.file("ept-data/0-0-0-0.bin")));
  std::filesystem::remove(set.file("ept-data/1-0-0-0.bin"));
  CHECK(read(set.path(), settings).size() == root);  // the file was not wanted
  CHECK(failure_of([&] { read(set.path()); }).status == Status::kNotFound);
}

TEST_CASE("ept_reader__a_cancel_ends_it") {
  const EptFolder set(wall_and_ground(100, 43));
  const std::atomic<bool> cancel = true;
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK(failure_of([&] { read_cloud(set.path(), {}, task); }).status == Status::kCancelled);
}

TEST_CASE("ept_reader__damaged_bytes_end_in_an_error_or_in_points") {
  const EptFolder set(wall_and_ground(300, 44));
  RandomStream random(44, 3);
  int refused = 0;
  for (const char* name : {"ept.json", kRootHierarchy}) {
    const std::string good = slurp(set.file(name));
    for (int i = 0; i < 150; ++i) {
      std::string bad = good;
      if (i % 5 == 0) bad.resize(random.below(bad.size()));
      else bad[random.below(bad.size())] = static_cast<char>(random.below(256));
      spill(set.file(name), bad);
      const Failure failure = failure_of([&] { CHECK(read(set.path()).size() <= 300); });
      refused += failure.status != Status::kOk ? 1 : 0;
      CHECK((failure.status == Status::kOk || has_text(failure.text, ".json") ||
             has_text(failure.text, ".bin")));
    }
    spill(set.file(name), good);
  }
  CHECK(refused > 100);
}
