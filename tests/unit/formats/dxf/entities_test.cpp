// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Entities against the DXF Reference: its arbitrary axes, bulges of known arcs, places in space.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "formats/dxf/sections.h"
#include "unit/formats/dxf/tags.h"
#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;
using dxf::Version;

namespace {

const dxf::Layer kWallLayer{"WALL", 7, false};
constexpr uint64_t kFirstHandle = 0x100;

struct WrittenLine {
  std::vector<TagItem> items;
  uint64_t handles = 0;  ///< taken
};
WrittenLine written_line(const dxf::Polyline& line, Version version, const Model& model = {}) {
  dxf::Text text(version);
  uint64_t next = kFirstHandle;
  dxf::add_polyline(text, line, kWallLayer, model, next);
  return {tag_items(text.take()), next - kFirstHandle};
}

/// Corners on a circle about (3, -4, 5) in the plane of the normal.
dxf::Polyline round_line(const Vec3& normal, const std::vector<double>& angles) {
  const dxf::ObjectAxes axes = dxf::object_axes(normal);
  dxf::Polyline line;
  line.normal = normal;
  for (const double a : angles)
    line.corners.push_back(Vec3{3, -4, 5} + std::cos(a) * axes.x + std::sin(a) * axes.y);
  return line;
}

}  // namespace

TEST_CASE("dxf_entities__object_axes_follow_the_arbitrary_axis_algorithm") {
  RandomStream random(1, 1);
  const auto check = [](const Vec3& normal, const Vec3& level) {
    const dxf::ObjectAxes axes = dxf::object_axes(normal);
    CHECK(norm(axes.z - normalized(normal)) < 1e-15);
    CHECK(norm(cross(axes.x, axes.y) - axes.z) < 1e-15);
    CHECK(std::fabs(norm(axes.x) - 1) < 1e-15);
    CHECK(std::fabs(dot(axes.x, axes.z)) < 1e-15);
    // x is the direction of level x z: at right angles to both, on the side of the right hand.
    CHECK(std::fabs(dot(axes.x, level)) < 1e-15);
    CHECK(dot(cross(level, axes.z), axes.x) > 0);
    const Vec3 p{3, -4, 5}, q = axes.project(p);
    CHECK(norm(q.x * axes.x + q.y * axes.y + q.z * axes.z - p) < 1e-14);
  };
  for (int i = 0; i < 100; ++i)
    check({random.normal() + 3, random.normal(), random.normal()}, {0, 0, 1});
  for (const double z : {1.0, -1.0}) {
    check({0, 0, z}, {0, 1, 0});
    check({0.0156, -0.0156, z}, {0, 1, 0});  // both below 1/64 = 0.015625
    check({0.0158, 0, z}, {0, 0, 1});        // one of them beyond, as a unit vector
    check({0, -0.0158, z}, {0, 0, 1});
  }
}

TEST_CASE("dxf_entities__bulges_are_the_tangent_of_a_quarter_of_the_angle") {
  constexpr double kPi = std::numbers::pi;
  const Vec3 normal = normalized({1, 2, -0.5});
  // Arcs of 60, 90, 180 and 30 degrees.
  const std::vector<double> angles{0, kPi / 3, kPi * 5 / 6, kPi * 11 / 6};
  const double spans[] = {kPi / 3, kPi / 2, kPi, kPi / 6};
  dxf::Polyline line = round_line(normal, angles);
  for (const double span : spans) line.sagittas_m.push_back(1 - std::cos(span / 2));
  line.sagittas_m[1] *= -1;  // clockwise
  const WrittenLine modern = written_line(line, Version::kR2000);
  CHECK(modern.handles == 1);
  REQUIRE(modern.items.size() == 1);
  CHECK(modern.items[0].kind() == "LWPOLYLINE");
  CHECK(modern.items[0].text(90) == "4");
  CHECK(modern.items[0].all(10).size() == 4);
  const std::vector<std::string> bulges = modern.items[0].all(42);
  REQUIRE(bulges.size() == 4);
  const WrittenLine old = written_line(line, Version::kR12);
  REQUIRE(old.items.size() == 6);  // POLYLINE, four times VERTEX, SEQEND
  for (size_t i = 0; i < 4; ++i) {
    const double wanted = (i == 1 ? -1 : 1) * std::tan(spans[i] / 4);
    CHECK(Tag{42, bulges[i]}.number() == doctest::Approx(wanted).epsilon(1e-12));
    CHECK(old.items[i + 1].number(42) == doctest::Approx(wanted).epsilon(1e-12));
  }
  line.sagittas_m = {0, 0, 0, 0.1};
  CHECK(written_line(line, Version::kR2000).items[0].all(42).size() ==
        1);  // straight ones have none
}

TEST_CASE("dxf_entities__an_arc_beyond_every_number_is_refused_and_no_other") {
  dxf::Polyline line;
  line.normal = {0, 0, 1};
  line.corners = {{0, 0, 0}, {0.001, 0, 0}, {1e4, 1, 0}};
  line.sagittas_m = {0, 1.7e308, 0};  // on an edge of 10 km
  for (const Version version : {Version::kR12, Version::kR2000}) {
    std::vector<std::string> bulges;
    for (const TagItem& item : written_line(line, version).items)
      for (const std::string& bulge : item.all(42)) bulges.push_back(bulge);
    REQUIRE(bulges.size() == 1);
    CHECK(Tag{42, bulges[0]}.number() == doctest::Approx(3.4e304));
  }
  line.sagittas_m = {1.7e308, 0, 0};  // on one of a millimetre
  for (const Version version : {Version::kR12, Version::kR2000}) {
    dxf::Text text(version);
    uint64_t next = kFirstHandle;
    const Failure failure =
        failure_of([&] { dxf::add_polyline(text, line, kWallLayer, {}, next); });
    CHECK(failure.status == Status::kUnsupported);
    CHECK(failure.text.find("group 42") != std::string::npos);
  }
}

TEST_CASE("dxf_entities__corners_come_back_to_their_place_flat_or_bent") {
  Model model;
  model.parts.resize(2);
  model.parts[1].name = "pane\n7";
  model.parts[1].part_class = "joinery";
  model.parts[1].evidence = Evidence::kCopied;
  model.parts[1].copied_from = 0;
  model.parts[0].name = "its source";
  RandomStream random(2, 1);
  for (int round = 0; round < 20; ++round) {
    const Vec3 normal = normalized({random.normal(), random.normal(), random.normal()});
    dxf::Polyline line = round_line(normal, {0.1, 0.9, 2, 4, 5.5});
    line.part = 1;
    line.face_id = 12;
    const auto place_of = [&](double x, double y, double z) {
      const dxf::ObjectAxes axes = dxf::object_axes(normal);
      return x * axes.x + y * axes.y + z * axes.z;
    };
    const WrittenLine flat = written_line(line, Version::kR2000, model);
    REQUIRE(flat.items.size() == 1);
    const TagItem& item = flat.items[0];
    for (size_t i = 0; i < 5; ++i) {
      const double x = Tag{10, item.all(10)[i]}.number(), y = Tag{20, item.all(20)[i]}.number();
      CHECK(norm(place_of(x, y, item.number(38)) - line.corners[i]) < 1e-14);
    }
    CHECK(item.all(1000) == std::vector<std::string>{"face=12", "part=pane 7", "number=1",
                                                     "class=joinery", "evidence=copied",
                                                     "copied_from=its source"});
    line.corners[2] += 1e-5 * normal;  // ten times what passes for flat
    for (const Version version : {Version::kR12, Version::kR2000}) {
      const WrittenLine bent = written_line(line, version, model);
      REQUIRE(bent.items.size() == 7);
      CHECK(bent.items.front().number(70) == 1 + 8);  // closed, in space
      CHECK(bent.items.back().kind() == "SEQEND");
      CHECK(bent.handles == 7);
      for (size_t i = 0; i < 5; ++i)
        CHECK(Vec3{bent.items[i + 1].number(10), bent.items[i + 1].number(20),
                   bent.items[i + 1].number(30)} == line.corners[i]);  // to the last bit
    }
  }
}

TEST_CASE("dxf_entities__triangles_repeat_their_last_corner_and_labels_stand_in_their_plane") {
  dxf::Text text(Version::kR2000);
  uint64_t next = kFirstHandle;
  dxf::add_triangle(text, {Vec3{1, 2, 3}, Vec3{4, 5, 6}, Vec3{7, 8, 9.5}}, kWallLayer, next);
  const Vec3 normal = normalized({0.2, -1, 0.1}), at{10, 20, 30};
  dxf::add_label(text, {at, normal, 0.75, "17", 0}, kWallLayer, next);
  CHECK(next == kFirstHandle + 2);
  const std::vector<TagItem> items = tag_items(text.take());
  REQUIRE(items.size() == 2);
  CHECK(items[0].kind() == "3DFACE");
  CHECK(items[0].text(5) == "100");
  CHECK(items[1].text(5) == "101");
  CHECK(items[0].text(8) == "WALL");
  for (const int axis : {10, 20, 30}) {
    CHECK(items[0].text(axis + 2) == items[0].text(axis + 3));
    CHECK(items[0].number(axis + 1) == items[0].number(axis) + 3);
  }
  CHECK(items[0].text(32) == "9.5");
  CHECK(items[1].kind() == "TEXT");
  CHECK(items[1].text(1) == "17");
  CHECK(items[1].number(40) == 0.75);
  CHECK(items[1].text(72) + items[1].text(73) == "12");  // centred both ways about group 11
  const dxf::ObjectAxes axes = dxf::object_axes(normal);
  const Vec3 place =
      items[1].number(11) * axes.x + items[1].number(21) * axes.y + items[1].number(31) * axes.z;
  CHECK(norm(place - at) < 1e-13);
}
