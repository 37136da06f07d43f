// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What is decided before a LAS file is written: steps that hold the coordinates, the version, the records that stay.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formats/las/plan.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kInt32 = 2147483647.0;

Cloud cloud_of(const std::vector<double>& coordinates) {
  Buffer<double> xyz(coordinates.size());
  for (size_t i = 0; i < coordinates.size(); ++i) xyz[i] = coordinates[i];
  return make_cloud(std::move(xyz));
}

las::Plan plan_of(const Cloud& cloud, const WriteSettings& settings = {}) {
  Task task;
  return las::make_plan(cloud, "a.las", settings, task);
}

WriteSettings of_version(LasVersion version) {
  WriteSettings settings;
  settings.las_version = version;
  return settings;
}

las::Record named_record(const char* user, const std::string& text) {
  return las::make_record(user, 3, "", text.data(), text.size());
}

// A cloud as a file with these records gives it: two points on steps of 0.01 about (1000, 1000, 1000).
Cloud from_file(const std::vector<las::Record>& vlrs, const std::vector<las::Record>& evlrs = {}) {
  LasBytes file;
  file.minor = evlrs.empty() ? 2 : 4;
  file.format = evlrs.empty() ? 0 : 6;
  file.record_bytes = evlrs.empty() ? 20 : 30;
  file.offset = 1000;
  file.vlrs = vlrs;
  file.evlrs = evlrs;
  file.add_point(1, 2, 3);
  file.add_point(-7, 12345, 9);
  const Folder folder;
  spill(folder.file("a.las"), file.bytes());
  return read(folder.file("a.las"));
}

std::string users_of(const std::vector<las::Record>& records) {
  std::string users;
  for (const las::Record& record : records) users += (users.empty() ? "" : " ") + record.user;
  return users;
}

}  // namespace

TEST_CASE("las_plan__steps_are_a_tenth_of_a_millimetre_or_the_least_power_of_ten_that_fits") {
  RandomStream random(3, 7);
  for (int round = 0; round < 200; ++round) {
    const double extent = std::pow(10.0, 14 * random.uniform() - 2);
    const double centre = 1e7 * (random.uniform() - 0.5);
    std::vector<double> xyz;
    for (const double side : {-0.5, 0.5})
      for (int k = 0; k < 3; ++k) xyz.push_back(centre + side * extent);
    const las::Plan plan = plan_of(cloud_of(xyz));
    for (int k = 0; k < 3; ++k) {
      const double offset = plan.offset[k], scale = plan.scale[k];
      CHECK(offset == std::floor(offset));
      const double reach = std::max(std::fabs(xyz[0] - offset), std::fabs(xyz[3] - offset));
      CHECK(reach / scale <= kInt32);
      CHECK(std::log10(scale) == doctest::Approx(std::round(std::log10(scale))));
      if (scale > 0.00011) CHECK(reach / scale > kInt32 / 10.001);  // no smaller step would do
      CHECK(scale >= 0.0001);
    }
  }
  const Failure failure = failure_of([] {
    WriteSettings fine;
    fine.scale = 1e-6;
    plan_of(cloud_of({0, 0, 0, 5000, 0, 0}), fine);  // 2.5e9 steps either way
  });
  CHECK(failure.status == Status::kLimit);
  CHECK(has_text(failure.text, "a.las: coordinates from 0 to 5000 "));
}

TEST_CASE("las_plan__a_wanted_step_is_metres_also_where_the_file_is_in_feet") {
  Cloud cloud = cloud_of({1200, 2400, 0, 1200, 2400, 0});
  cloud.crs = "EPSG:2263";  // US survey feet of 1200 / 3937 m
  WriteSettings settings;
  settings.scale = 0.002;
  const las::Plan plan = plan_of(cloud, settings);
  CHECK(plan.scale.x == doctest::Approx(0.002 * 3937 / 1200).epsilon(1e-14).scale(0));
  CHECK(std::fabs(plan.offset.x - 3937) <= 1);  // whole feet
  CHECK(std::fabs(plan.offset.y - 7874) <= 1);
  CHECK(plan.offset.y == std::floor(plan.offset.y));
}

TEST_CASE("las_plan__the_steps_of_the_file_stay_while_they_give_every_coordinate_back") {
  const Cloud cloud = from_file({});
  const las::Plan same = plan_of(cloud);
  CHECK(same.scale == Vec3{0.01, 0.01, 0.01});
  CHECK(same.offset == Vec3{1000, 1000, 1000});
  for (size_t k = 0; k < 6; ++k) {
    Buffer<double> xyz(6);
    for (size_t i = 0; i < 6; ++i) xyz[i] = cloud.xyz()[i] + (i == k ? 0.005 : 0);
    Cloud moved = make_cloud(std::move(xyz));
    moved.attachments = cloud.attachments;
    CHECK(plan_of(moved).scale == Vec3{0.0001, 0.0001, 0.0001});
  }
  WriteSettings settings;
  settings.scale = 0.5;
  CHECK(plan_of(cloud, settings).scale == Vec3{0.5, 0.5, 0.5});
}

TEST_CASE("las_plan__1_4_is_taken_for_what_1_2_cannot_say_and_records_of_the_file_stay") {
  Cloud plain = cloud_of({0, 0, 0});
  CHECK(plan_of(plain).version_minor == 2);
  CHECK(plan_of(plain, of_version(LasVersion::k14)).format == 6);
  plain.crs = "PROJCS[\"p\",UNIT[\"metre\",1]]";
  CHECK(plan_of(plain).version_minor == 4);
  CHECK(plan_of(plain, of_version(LasVersion::k12)).version_minor == 2);
  plain.crs = "PROJCS[\"" + std::string(70000, 'p') + "\",UNIT[\"metre\",1]]";
  CHECK(plan_of(plain).evlrs.size() == 1);
  CHECK(failure_of([&] { plan_of(plain, of_version(LasVersion::k12)); }).status == Status::kLimit);

  const las::Record metric = las::crs_records("EPSG:2154")[0];
  const las::Record extra =
      extra_bytes_record({las::descriptor_of({"gone", ElementType::kFloat32, 1, "", ""}, "gone")});
  Cloud cloud = from_file({named_record("first", "1"), metric, named_record("laszip encoded", ""),
                           extra, named_record("last", "2")});
  CHECK(users_of(plan_of(cloud).vlrs) == "first LASF_Projection last");
  cloud.crs = "EPSG:32631";
  CHECK(users_of(plan_of(cloud).vlrs) == "first last LASF_Projection");
  cloud.crs = "";
  CHECK(users_of(plan_of(cloud).vlrs) == "first last");
  cloud.crs = "EPSG:2154";
  const float heights[] = {1, 2};
  cloud.fields.set(make_column<float>({"h"}, heights));
  const las::Plan with_field = plan_of(cloud);  // described where the file described its own
  CHECK(users_of(with_field.vlrs) == "first LASF_Projection LASF_Spec last");
  CHECK(with_field.record_bytes == 24);

  const Cloud extended = from_file({}, {extended_record("long", 1, "text")});
  CHECK(users_of(plan_of(extended).evlrs) == "long");
  KeptLog log;
  CHECK(las::make_plan(extended, "a", of_version(LasVersion::k12), log.task()).evlrs.empty());
  REQUIRE(log.warnings().size() == 1);
  CHECK(has_text(log.warnings()[0], "long 1 is left out"));
}
