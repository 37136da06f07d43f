// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "cloud/sections/sections.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

// Four walls of 6 x 4 m about a place on the national grid, 3 m high.
Cloud walls() {
  RandomStream random(8, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 200000; ++i) {
    const double z = 3 * random.uniform(), s = 6 * random.uniform(), t = 4 * random.uniform();
    points.push_back(i % 2 == 0 ? Vec3{s, i % 4 == 0 ? 0.0 : 4.0, z}
                                : Vec3{i % 4 == 1 ? 0.0 : 6.0, t, z});
  }
  return cloud_of(shifted(points, kFar));
}

TEST_CASE("section_tables__count_points_lines_and_vertices") {
  Task task;
  SectionSettings settings;
  settings.at_m = {121, 122, 200};
  const Sections sections = cut_sections(walls(), {}, settings, task);
  const FieldTable cuts = section_table(sections), lines = section_line_table(sections),
                   vertices = section_vertex_table(sections);
  REQUIRE(cuts.require("at").count() == 3);
  CHECK(cuts.require("lines").values<uint64_t>()[0] == 1);
  CHECK(cuts.require("lines").values<uint64_t>()[2] == 0);
  CHECK(cuts.require("points").values<uint64_t>()[2] == 0);
  for (const char* measured : {"rms", "max"}) {
    CHECK(!std::isnan(cuts.require(measured).values<double>()[0]));
    CHECK(std::isnan(cuts.require(measured).values<double>()[2]));
  }
  CHECK(cuts.require("length").values<double>()[0] == doctest::Approx(20).epsilon(0.001));
  CHECK(cuts.require("max").values<double>()[0] < 1e-6);
  const auto of_section = lines.require("section").values<uint32_t>();
  const auto first = lines.require("first").values<uint64_t>();
  const auto count = lines.require("vertices").values<uint32_t>();
  uint64_t next = 0;
  for (size_t k = 0; k < of_section.size(); ++k) {
    CHECK(first[k] == next);
    CHECK(lines.require("closed").values<uint8_t>()[k] == 1);
    next += count[k];
  }
  REQUIRE(vertices.require("uv").count() == next);
  const auto uv = vertices.require("uv").values<double>();
  const auto xyz = vertices.require("xyz").values<double>();
  const auto origin = cuts.require("origin").values<double>();
  CHECK(xyz[0] == origin[0] + uv[0]);  // seen from above: u is x, v is y
  CHECK(xyz[1] == origin[1] + uv[1]);
  CHECK(xyz[2] == 121);
}

}  // namespace
}  // namespace jalon
