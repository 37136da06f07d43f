// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The unit that a user gives for a file: its coordinates become metres, nothing else changes.
#include <doctest/doctest.h>

#include <string>

#include "formats/formats.h"
#include "formats/units/file_unit.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("file_unit__each_unit_has_its_length_in_metres") {
  CHECK(metres_of(FileUnit::kAuto) == 1);
  CHECK(metres_of(FileUnit::kMetres) == 1);
  CHECK(metres_of(FileUnit::kMillimetres) == 0.001);
  CHECK(metres_of(FileUnit::kCentimetres) == 0.01);
  CHECK(metres_of(FileUnit::kFeet) == 0.3048);
  CHECK(metres_of(FileUnit::kUsSurveyFeet) == 1200.0 / 3937.0);
}

TEST_CASE("file_unit__coordinates_of_text_and_ply_become_metres_and_fields_stay") {
  const Folder folder;
  spill(folder.file("a.xyz"), "#x y z height\n1000 2000 -500 7000\n4 5 6 8\n");
  for (const std::string name : {"a.xyz", "a.ply"}) {
    CAPTURE(name);
    if (name == "a.ply") write(read(folder.file("a.xyz")), folder.file(name));
    ReadSettings settings;
    settings.unit = FileUnit::kMillimetres;
    const Cloud cloud = read(folder.file(name), settings);
    CHECK(cloud.point(0) == Vec3{1000 * 0.001, 2000 * 0.001, -500 * 0.001});
    CHECK(cloud.fields.require("height").number(0) == 7000);
    settings.unit = FileUnit::kMetres;
    CHECK(read(folder.file(name), settings).point(0) == Vec3{1000, 2000, -500});
  }
}

TEST_CASE("file_unit__an_index_built_before_is_not_that_of_the_scaled_points") {
  Task task;
  Cloud cloud = make_cloud(Buffer<double>(9));
  const auto before = cloud.index;
  CHECK(in_metres(cloud, FileUnit::kMetres, task).index == before);
  CHECK(in_metres(cloud, FileUnit::kFeet, task).index != before);
}
