// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// E57 files of ours as our reader sees them: stations with poses, fields in their types.
#include <doctest/doctest.h>

#include <cmath>

#include "formats/codecs/codecs.h"
#include "formats/e57/e57.h"
#include "geometry/rotation.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr size_t kPoints = 40000;

bool skipped() {
  if (has_codecs()) return false;
  MESSAGE("skipped: built without JALON_WITH_RUST_FORMATS");
  return true;
}

Transform pose_of(double yaw, const Vec3& at) {
  const Matrix3 r = rotation_zyx({0.01, -0.02, yaw});
  Transform pose;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < 3; ++k) pose.m[4 * i + k] = r.m[3 * i + k];
    pose.m[4 * i + 3] = at[static_cast<int>(i)];
  }
  return pose;
}

/// Two stations with poses, points of none between them, and fields of many types.
Cloud survey(uint64_t seed) {
  Cloud cloud = random_points(kPoints, seed);
  cloud.stations = {{"west & <east>", true, pose_of(2.5, {652001, 6861002, 101.5}), 0, 15000},
                    {"no pose", false, {}, 20000, 10},
                    {"ö ]]> ö", true, pose_of(-3, {652010, 6860990, 99}), 20010, kPoints - 20010}};
  RandomStream random(seed, 2);
  const auto add = [&](const char* name, ElementType type, uint32_t components = 1) {
    cloud.fields.set(random_column(name, type, components, kPoints, random));
  };
  add("intensity", ElementType::kFloat32);
  for (const char* name : {"red", "green", "blue"}) add(name, ElementType::kUint8);
  add("label", ElementType::kInt32);
  add("flag", ElementType::kUint8);
  add("own_i2", ElementType::kInt16);
  add("own f8", ElementType::kFloat64);
  add("residual", ElementType::kFloat32);
  auto row = std::make_shared<Column>(FieldInfo{"row", ElementType::kUint32, 1, "", ""}, kPoints);
  for (size_t i = 0; i < kPoints; ++i) row->values<uint32_t>()[i] = static_cast<uint32_t>(i % 777);
  cloud.fields.set(row);
  cloud.crs = "EPSG:2154";
  return cloud;
}

void check_field(const Cloud& a, const Cloud& b, const char* name, const char* as = nullptr) {
  CAPTURE(name);
  const Column &from = a.fields.require(name), &to = b.fields.require(as != nullptr ? as : name);
  CHECK(to.info().type == from.info().type);
  REQUIRE(to.count() == from.count());
  size_t differing = 0;
  for (size_t i = 0; i < from.count(); ++i) differing += from.number(i) == to.number(i) ? 0 : 1;
  CHECK(differing == 0);
}

double farthest(const Cloud& a, const Cloud& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(a.point(i) - b.point(i)));
  return most;
}

}  // namespace

TEST_CASE("e57_writer__stations_poses_and_fields_come_back") {
  if (skipped()) return;
  const Folder folder;
  const Cloud cloud = survey(4);
  write(cloud, folder.file("a.e57"));
  const Cloud back = read(folder.file("a.e57"));
  REQUIRE(back.size() == kPoints);
  CHECK(farthest(cloud, back) < 5e-9);  // two turns at coordinates of seven digits
  REQUIRE(back.stations.size() == 4);
  const size_t firsts[] = {0, 15000, 20000, 20010};
  for (size_t s = 0; s < 4; ++s) CHECK(back.stations[s].first == firsts[s]);
  CHECK(back.stations[0].name.str() == "west & <east>");
  CHECK(back.stations[1].name.str() == "points");
  CHECK(back.stations[3].name.str() == "ö ]] > ö");
  CHECK_FALSE(back.stations[1].has_pose);
  CHECK_FALSE(back.stations[2].has_pose);
  for (const size_t s : {size_t{0}, size_t{3}}) {
    REQUIRE(back.stations[s].has_pose);
    const Transform& wanted = cloud.stations[s == 0 ? 0 : 2].pose;
    for (size_t k = 0; k < 12; ++k)
      CHECK(back.stations[s].pose.m[k] == doctest::Approx(wanted.m[k]).epsilon(1e-12));
  }
  CHECK(std::string(back.crs) == "EPSG:2154");
  for (const char* name :
       {"intensity", "red", "green", "blue", "label", "flag", "own_i2", "residual", "row"})
    check_field(cloud, back, name);
  check_field(cloud, back, "own f8", "own_f8");
}

TEST_CASE("e57_writer__scaled_coordinates_keep_half_a_step_and_take_less_room") {
  if (skipped()) return;
  const Folder folder;
  Cloud cloud = random_points(kPoints, 8);
  cloud.stations = {{"a", true, pose_of(1, {652000, 6861000, 100}), 0, kPoints}};
  WriteSettings settings;
  settings.scale = 0.001;
  write(cloud, folder.file("step.e57"), settings);
  write(cloud, folder.file("whole.e57"));
  const Cloud back = read(folder.file("step.e57"));
  CHECK(farthest(cloud, back) <= 0.0005 * std::sqrt(3.0) + 5e-9);
  CHECK(slurp(folder.file("step.e57")).size() * 3 < slurp(folder.file("whole.e57")).size());
}

TEST_CASE("e57_writer__normals_are_turned_into_the_scanners_frame_and_back") {
  if (skipped()) return;
  const Folder folder;
  Cloud cloud = random_points(100, 2);
  cloud.stations = {{"a", true, pose_of(0.7, {652000, 6861000, 100}), 0, 100}};
  std::vector<float> normals(300, 0.0f);
  for (size_t i = 0; i < 100; ++i) normals[3 * i + i % 3] = 1;
  cloud.fields.set(make_column<float>({"normal", ElementType::kFloat32, 3, "", ""}, normals));
  write(cloud, folder.file("a.e57"));
  const Cloud back = read(folder.file("a.e57"));
  const auto found = back.fields.require("normal").values<float>();
  for (size_t i = 0; i < 300; ++i) CHECK(std::fabs(found[i] - normals[i]) < 1e-6f);
}

TEST_CASE("e57_writer__empty_clouds_the_same_bytes_again_and_a_cancel_that_leaves_the_old_file") {
  if (skipped()) return;
  const Folder folder;
  write(Cloud{}, folder.file("a.e57"));
  CHECK(read(folder.file("a.e57")).size() == 0);
  const Cloud cloud = survey(6);
  write(cloud, folder.file("b.e57"));
  write(cloud, folder.file("c.e57"));
  CHECK(slurp(folder.file("b.e57")) == slurp(folder.file("c.e57")));
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const std::string old = slurp(folder.file("b.e57"));
  CHECK(failure_of([&] { write_cloud(cloud, folder.file("b.e57"), {}, task); }).status ==
        Status::kCancelled);
  CHECK(slurp(folder.file("b.e57")) == old);
  CHECK(folder.entries() == 3);
}
