// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/sections.h"

#include <doctest/doctest.h>

#include <numbers>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

// A barrel vault of radius 3 m on walls 2 m high, along the y axis, 8 m long.
std::vector<Vec3> tunnel(uint64_t seed, size_t n) {
  RandomStream random(seed, 9);
  std::vector<Vec3> points;
  const double arc = 3 * std::numbers::pi, whole = arc + 4;
  for (size_t i = 0; i < n; ++i) {
    const double along = whole * random.uniform(), y = 8 * random.uniform(),
                 off = 0.004 * random.normal();
    if (along < 2) points.push_back({-3 - off, y, along});
    else if (along > 2 + arc) points.push_back({3 + off, y, along - 2 - arc});
    else {
      const double turn = (along - 2) / 3;
      points.push_back({-(3 + off) * std::cos(turn), y, 2 + (3 + off) * std::sin(turn)});
    }
  }
  return points;
}

double off_outline(const Vec2& p) {
  return p.v <= 2 ? std::fabs(std::fabs(p.u) - 3) : std::fabs(std::hypot(p.u, p.v - 2) - 3);
}

Sections along_axis(const Cloud& cloud, const Vec3& shift, uint32_t threads = 0) {
  Task task({.threads = threads});
  SectionSettings settings;
  settings.step_m = 2;
  const std::vector<Vec3> axis{shift, shift + Vec3{0, 8, 0}};
  return cut_sections(cloud, axis, settings, task);
}

TEST_CASE("sections__of_a_tunnel_follow_its_outline_within_the_tolerance") {
  const Sections sections = along_axis(cloud_of(tunnel(1, 400000)), {});
  CHECK(sections.kind == SectionKind::kAlignment);
  REQUIRE(sections.sections.size() == 5);
  CHECK(sections.name(2) == "STATION 4.000");
  for (const Section& section : sections.sections) {
    REQUIRE(section.lines.size() == 1);
    const SectionLine& line = section.lines[0];
    CHECK(line.points == section.points);
    CHECK(line.length_m == doctest::Approx(3 * std::numbers::pi + 4).epsilon(0.003).scale(0));
    CHECK(line.rms_m < 0.02);
    for (const Vec2& p : line.vertices) CHECK(off_outline(p) < 0.02 + 0.004);  // with one sigma
  }
}

TEST_CASE("sections__the_same_bits_for_any_threads_and_any_order") {
  const std::vector<Vec3> points = tunnel(2, 100000);
  std::vector<Vec3> reversed(points.rbegin(), points.rend());
  const Sections one = along_axis(cloud_of(points), {}, 1);
  for (const Sections& other :
       {along_axis(cloud_of(points), {}, 2), along_axis(cloud_of(points), {}, 7),
        along_axis(cloud_of(reversed), {}, 2)}) {
    REQUIRE(other.sections.size() == one.sections.size());
    for (size_t s = 0; s < one.sections.size(); ++s) {
      REQUIRE(other.sections[s].lines.size() == one.sections[s].lines.size());
      for (size_t k = 0; k < one.sections[s].lines.size(); ++k)
        CHECK(other.sections[s].lines[k].vertices == one.sections[s].lines[k].vertices);
    }
  }
}

TEST_CASE("sections__lose_nothing_on_the_national_grid") {
  const std::vector<Vec3> points = tunnel(3, 100000);
  const Sections near = along_axis(cloud_of(points), {}),
                 far = along_axis(cloud_of(shifted(points, kFar)), kFar);
  for (size_t s = 0; s < near.sections.size(); ++s) {
    const auto &a = near.sections[s].lines, &b = far.sections[s].lines;
    REQUIRE(a.size() == b.size());
    for (size_t k = 0; k < a.size(); ++k) {
      REQUIRE(a[k].vertices.size() == b[k].vertices.size());
      for (size_t i = 0; i < a[k].vertices.size(); ++i) {
        CHECK(std::fabs(a[k].vertices[i].u - b[k].vertices[i].u) < 1e-6);
        CHECK(std::fabs(a[k].vertices[i].v + kFar.z - b[k].vertices[i].v) < 1e-6);
      }
    }
  }
}

TEST_CASE("sections__names_tell_places_apart") {
  Task task;
  SectionSettings settings;
  settings.at_m = {1, 1.00001, 2};
  const Sections sections = cut_sections(cloud_of({{0, 0, 0}}), {}, settings, task);
  CHECK(sections.name(0) == "Z 1.00000");
  CHECK(sections.name(1) == "Z 1.00001");
  CHECK(sections.name(2) == "Z 2.000");
  settings.direction = {1, 0, 0};
  CHECK(cut_sections(cloud_of({{0, 0, 0}}), {}, settings, task).name(2) == "D 2.000");
}

TEST_CASE("sections__of_poor_clouds_are_empty_or_refused") {
  Task task;
  SectionSettings settings;
  settings.at_m = {0};
  CHECK(status_of([&] { cut_sections(cloud_of({}), {}, settings, task); }) ==
        Status::kInsufficientData);
  CHECK(cut_sections(cloud_of({{1, 2, 0}}), {}, settings, task).sections[0].lines.empty());
  CHECK(cut_sections(cloud_of(std::vector<Vec3>(1000, Vec3{1, 2, 0})), {}, settings, task)
            .sections[0]
            .points == 1000);
}

}  // namespace
}  // namespace jalon
