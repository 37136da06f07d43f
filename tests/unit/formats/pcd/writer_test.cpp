// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/pcd/pcd.h"

#include <doctest/doctest.h>

#include "geometry/rotation.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("pcd_writer__gives_every_bit_back_with_fields_colours_normals_and_station") {
  constexpr size_t kPoints = 20000;  // more than a chunk of 16384
  Cloud cloud = random_points(kPoints, 7);
  RandomStream random(5, 2);
  for (const char* name : {"red", "green", "blue"})
    cloud.fields.set(random_column(name, ElementType::kUint8, 1, kPoints, random));
  cloud.fields.set(random_column("normal", ElementType::kFloat32, 3, kPoints, random));
  for (const ElementType type : {ElementType::kInt8, ElementType::kUint16, ElementType::kInt32,
                                 ElementType::kUint64, ElementType::kFloat64})
    cloud.fields.set(random_column(std::string("of ") + name_of(type), type, 2, kPoints, random));
  cloud.crs = "EPSG:2154";
  Station station;
  station.has_pose = true;
  const Matrix3 turn = rotation_zyx({0.1, 0.2, 3});
  for (size_t i = 0; i < 9; ++i) station.pose.m[4 * (i / 3) + i % 3] = turn.m[i];
  station.pose.m[3] = 652000.5;
  station.count = kPoints;
  cloud.stations.push_back(station);

  const Folder folder;
  write(cloud, folder.file("a.pcd"));
  const Cloud back = read(folder.file("a.pcd"));
  REQUIRE(back.size() == kPoints);
  CHECK(std::equal(cloud.xyz().begin(), cloud.xyz().end(), back.xyz().begin()));
  REQUIRE(back.fields.size() == cloud.fields.size());
  for (const ColumnPtr& column : cloud.fields) {
    std::string name = column->info().name;
    std::replace(name.begin(), name.end(), ' ', '_');
    CAPTURE(name);
    const Column& other = back.fields.require(name);
    CHECK(other.info().type == column->info().type);
    CHECK(std::memcmp(other.raw(), column->raw(), column->bytes()) == 0);
  }
  CHECK(std::string(back.crs) == "EPSG:2154");
  REQUIRE(back.stations.size() == 1);
  for (size_t i = 0; i < 12; ++i)
    CHECK(std::abs(back.stations[0].pose.m[i] - station.pose.m[i]) < 1e-15 * 1e6);
}

TEST_CASE("pcd_writer__a_field_that_would_be_padding_gets_a_name") {
  Cloud cloud = random_points(3, 1);
  RandomStream random(1, 1);
  for (const char* name : {"_", "x", "rgb", "two words"})
    cloud.fields.set(random_column(name, ElementType::kInt16, 1, 3, random));
  const Folder folder;
  write(cloud, folder.file("a.pcd"));
  CHECK(slurp(folder.file("a.pcd")).find("FIELDS x y z field x_2 rgb two_words\n") !=
        std::string::npos);
  CHECK(read(folder.file("a.pcd")).fields.size() == 4);
}
