// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The options of reading that all formats share: station, max_points, fields, and what they are together with a box.
#include "formats/wanted_points.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "formats/codecs/codecs.h"
#include "formats/formats.h"
#include "unit/formats/opened_file.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Points whose field "number" (and intensity) tells their place in the file.
Cloud numbered(size_t n) {
  Cloud cloud = random_points(n, 17);
  for (const char* name : {"number", "intensity"}) {
    auto column = std::make_shared<Column>(FieldInfo{name, ElementType::kUint16, 1, "", ""}, n);
    for (size_t i = 0; i < n; ++i) column->values<uint16_t>()[i] = static_cast<uint16_t>(i);
    cloud.fields.set(std::move(column));
  }
  return cloud;
}

std::vector<double> numbers_of(const Cloud& cloud) {
  const Column& column = cloud.fields.require("number");
  std::vector<double> out(cloud.size());
  load_converted(column, ElementType::kFloat64, out.data());
  return out;
}

std::vector<std::string> formats_with_fields() {
  std::vector<std::string> out{"las", "ply", "pcd", "csv", "ept.json"};
  if (has_codecs())
    for (const char* more : {"laz", "copc.laz", "e57"}) out.emplace_back(more);
  return out;
}

std::string name_of(const std::string& extension) {
  return extension == "ept.json" ? extension : "a." + extension;
}

/// test(path) of the cloud in a file of each format that has fields.
template <class Test>
void in_every_format(const Cloud& cloud, Test&& test) {
  for (const std::string& extension : formats_with_fields()) {
    CAPTURE(extension);
    const Folder folder;
    const std::string path = folder.file(name_of(extension));
    write(cloud, path);
    test(path);
  }
}

ReadSettings with_fields(const char* fields) {
  ReadSettings settings;
  settings.fields = fields;
  return settings;
}

}  // namespace

TEST_CASE("wanted_points__max_points_keeps_so_many_evenly_and_in_their_order_in_every_format") {
  const Cloud cloud = numbered(997);
  in_every_format(cloud, [&](const std::string& path) {
    const std::vector<double> all = numbers_of(read(path));
    for (const int64_t most : {1, 2, 100, 499, 996, 997, 5000}) {
      CAPTURE(most);
      ReadSettings settings;
      settings.max_points = most;
      const std::vector<double> kept = numbers_of(read(path, settings));
      REQUIRE(kept.size() == std::min<size_t>(997, static_cast<size_t>(most)));
      // Places in the file ascend in steps that differ by one at most.
      std::vector<std::ptrdiff_t> steps;
      std::ptrdiff_t before = 0;
      for (const double number : kept) {
        const std::ptrdiff_t at = std::ranges::find(all, number) - all.begin();
        if (number != kept.front()) steps.push_back(at - before);
        before = at;
      }
      for (const std::ptrdiff_t step : steps) {
        CHECK(step >= 997 / most);
        CHECK(step <= 997 / most + 1);
      }
    }
  });
}

TEST_CASE("wanted_points__fields_are_those_named_in_their_order_and_one_that_lacks_is_an_error") {
  const Cloud cloud = numbered(50);
  in_every_format(cloud, [&](const std::string& path) {
    const Cloud whole = read(path), one = read(path, with_fields("number"));
    REQUIRE(one.fields.size() == 1);
    CHECK(numbers_of(one) == numbers_of(whole));
    CHECK(one.point(49) == whole.point(49));
    const Cloud two = read(path, with_fields("number, intensity"));
    REQUIRE(two.fields.size() == 2);
    CHECK(two.fields.at(0)->info().name == "number");
    CHECK(read(path, with_fields("-")).fields.size() == 0);
    const Failure failure = failure_of([&] { read(path, with_fields("number colour")); });
    CHECK(failure.status == Status::kNotFound);
    CHECK_MESSAGE(has_text(failure.text, path + ": no field \"colour\"; there are: "),
                  failure.text);
    CHECK_MESSAGE(has_text(failure.text, "number"), failure.text);
  });
}

TEST_CASE("wanted_points__a_field_with_a_question_mark_may_be_missing") {
  const Cloud cloud = numbered(50);
  in_every_format(cloud, [&](const std::string& path) {
    const Cloud one = read(path, with_fields("red? number? green?"));
    REQUIRE(one.fields.size() == 1);
    CHECK(numbers_of(one) == numbers_of(read(path)));
    CHECK(read(path, with_fields("red?")).fields.size() == 0);
    CHECK(failure_of([&] { read(path, with_fields("number? red")); }).status == Status::kNotFound);
    CHECK(failure_of([&] { read(path, with_fields("?")); }).status == Status::kNotFound);
  });
}

TEST_CASE("wanted_points__of_one_station_are_its_points_with_its_pose") {
  const Cloud cloud = two_stations();
  std::vector<std::string> extensions{"las", "ply", "xyz"};
  if (has_codecs()) extensions.emplace_back("e57");
  for (const std::string& extension : extensions) {
    CAPTURE(extension);
    const Folder folder;
    const std::string path = folder.file("a." + extension);
    write(cloud, path);
    ReadSettings settings;
    for (const char* told : {"east", "2"}) {
      settings.station = told;
      const Cloud east = read(path, settings);
      REQUIRE(east.size() == 11);
      CHECK(norm(east.point(0) - cloud.point(9)) <= 0.0001);
      REQUIRE(east.stations.size() == 1);
      CHECK(east.stations[0].name == "east");
      CHECK(east.stations[0].count == 11);
    }
    settings.station = "1";
    CHECK(read(path, settings).stations.at(0).has_pose);
    settings.station = "north";
    const Failure failure = failure_of([&] { read(path, settings); });
    CHECK(failure.status == Status::kNotFound);
    CHECK_MESSAGE(has_text(failure.text, path + ": no station \"north\"; there are: west"),
                  failure.text);
  }
  const Folder folder;
  write(random_points(5, 1), folder.file("a.las"));
  ReadSettings first;
  first.station = "1";
  CHECK(has_text(failure_of([&] { read(folder.file("a.las"), first); }).text, "have none"));
}

TEST_CASE("wanted_points__of_stations_with_one_name_are_told_by_their_numbers") {
  Cloud cloud = two_stations();
  cloud.stations[0].name = "east";
  const Folder folder;
  const std::string path = folder.file("a.las");
  write(cloud, path);
  ReadSettings settings;
  settings.station = "east";
  const Failure failure = failure_of([&] { read(path, settings); });
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK_MESSAGE(has_text(failure.text, path + ": 2 stations are named \"east\": their numbers tell "
                                              "them apart, 1 or 2"),
                failure.text);
  settings.station = "2";
  CHECK(read(path, settings).size() == 11);
}

TEST_CASE("wanted_points__the_box_comes_before_the_number_and_both_before_the_fields") {
  const Folder folder;
  const Cloud cloud = numbered(2000);
  write(cloud, folder.file("a.las"));
  const Vec3 middle = cloud.point(0);
  ReadSettings settings;
  settings.box = {-1e9, -1e9, -1e9, middle.x, 1e9, 1e9};
  const std::vector<double> inside = numbers_of(read(folder.file("a.las"), settings));
  REQUIRE(inside.size() > 100);
  settings.max_points = 50;
  settings.fields = "number";
  const Cloud part = read(folder.file("a.las"), settings);
  CHECK(part.size() == 50);
  for (const double number : numbers_of(part)) CHECK(std::ranges::count(inside, number) == 1);
  Task task;
  spill(folder.file("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const ReadSettings& of_clouds : {with_fields("number"), settings})
    CHECK(failure_of([&] { read_model(folder.file("a.obj"), of_clouds, task); }).status ==
          Status::kUnsupported);
}

TEST_CASE("wanted_points__of_pieces_are_those_of_the_whole") {
  const Cloud cloud = numbered(1000);
  Task task;
  ReadSettings settings;
  settings.fields = "number";
  for (const int64_t most : {1, 3, 333, 999}) {
    settings.max_points = most;
    const std::vector<double> whole = numbers_of(wanted_points(cloud, "a", settings, task));
    std::vector<double> of_pieces;
    for (const auto& [first, count] : {std::pair(0, 1), std::pair(1, 498), std::pair(499, 501)}) {
      std::vector<uint64_t> indices(static_cast<size_t>(count));
      for (size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<uint64_t>(first) + i;
      const auto start = static_cast<uint64_t>(first);
      const Cloud kept =
          wanted_points(select(cloud, indices, task), start, 1000, "a", settings, task);
      for (const double number : numbers_of(kept)) of_pieces.push_back(number);
    }
    CHECK(of_pieces == whole);
  }
}
