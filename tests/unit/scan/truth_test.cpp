// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "fixture.h"
#include "scan/truth.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kLeast_m2 = 0.05;

Truth truth_of(const Model& model, double least_m2 = kLeast_m2) {
  Task task;
  return find_truth(model, least_m2, task);
}

/// Two triangles a rectangle of the plane z = height.
void add_rectangle(Model& model, double x0, double x1, double y0, double y1, double height = 0, double slope = 0) {
  const auto first = static_cast<uint32_t>(model.vertices.size());
  for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
    model.vertices.push_back({x, y, height + slope * x});
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangles.push_back({first, first + 2, first + 3});
  model.triangle_faces.insert(model.triangle_faces.end(), 2, static_cast<uint32_t>(model.triangles.size() / 2));
}

}  // namespace

TEST_CASE("truth__joins_what_shares_an_edge_or_touches_and_nothing_else") {
  struct Case {
    const char* what;
    double x0, x1, y0, y1, height, slope;
    size_t planes;
  };
  const Case cases[] = {
      {"shares an edge", 2, 4, 0, 3, 0, 0, 1},
      {"touches part of an edge", 2, 4, 1, 2, 0, 0, 1},
      {"touches a corner", 2, 4, 3, 5, 0, 0, 1},
      {"overlaps", 1, 4, 1, 2, 0, 0, 1},
      {"lies inside", 0.5, 1, 0.5, 1, 0, 0, 1},
      {"a gap of 0.05 mm", 2.00005, 4, 0, 3, 0, 0, 1},
      {"a gap of 1 mm", 2.001, 4, 0, 3, 0, 0, 2},
      {"0.05 mm higher", 2, 4, 0, 3, 0.00005, 0, 1},
      {"1 mm higher", 2, 4, 0, 3, 0.001, 0, 2},
      {"tilted by 0.01 degrees", 2, 4, 0, 3, -2 * 1.745e-4, 1.745e-4, 2},
      {"far away", 20, 40, 0, 3, 0, 0, 2},
  };
  for (const Case& c : cases)
    for (const double far : {0.0, 6861000.0}) {
      CAPTURE(c.what);
      Model model;
      add_rectangle(model, 0, 2, 0, 3);
      add_rectangle(model, c.x0, c.x1, c.y0, c.y1, c.height, c.slope);
      for (Vec3& v : model.vertices) v.y += far;
      const Truth truth = truth_of(model);
      CHECK(truth.planes.size() == c.planes);
      CHECK(truth.triangle_segments[0] == 1);
      CHECK(truth.triangle_segments[1] == 1);
      CHECK(truth.triangle_segments[3] == c.planes);
    }
}

TEST_CASE("truth__counts_areas_and_leaves_out_small_groups") {
  Model model;
  add_rectangle(model, 0, 0.2, 0, 0.2);  // 0.04 m2
  add_rectangle(model, 5, 5.2, 0, 0.2);  // 0.04 and, touching it, 0.02 m2
  add_rectangle(model, 5.2, 5.4, 0, 0.1);
  add_rectangle(model, 9, 10, 0, 1);
  const Truth truth = truth_of(model);
  REQUIRE(truth.planes.size() == 2);
  CHECK(truth.planes[0].area_m2 == doctest::Approx(0.06));
  CHECK(truth.planes[0].face == 2);
  CHECK(truth.planes[1].area_m2 == doctest::Approx(1));
  CHECK(truth.triangle_segments == std::vector<uint32_t>{0, 0, 1, 1, 1, 1, 2, 2});
  CHECK(truth_of(model, 0).planes.size() == 3);
  CHECK(truth_of(Model{}).planes.empty());
}

TEST_CASE("truth__of_a_long_chain_of_patches_is_one_plane") {
  Model model;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) add_rectangle(model, i, i + 1, j + 0.5 * (i % 2), j + 1 + 0.5 * (i % 2));
  const Truth truth = truth_of(model);
  REQUIRE(truth.planes.size() == 1);
  CHECK(truth.planes[0].area_m2 == doctest::Approx(1600));
}

TEST_CASE("truth__leaves_out_curved_surfaces_of_scenes_but_takes_every_triangle_of_a_mesh") {
  const Model street = scene("street");
  const auto faces = faces_by_id(street);
  const Truth truth = truth_of(street);
  for (size_t t = 0; t < street.triangles.size(); ++t)
    if (!faces.contains(street.triangle_faces[t])) REQUIRE(truth.triangle_segments[t] == kNoSegment);
  // The 28 planes of the measurements without the six of glass, whose panes stand apart.
  const auto large = std::count_if(truth.planes.begin(), truth.planes.end(),
                                   [](const TruePlane& p) { return p.area_m2 > 2; });
  CHECK(large == 1 + 6 + 15);

  Model cube = scene("box");
  cube.faces.clear();
  CHECK(truth_of(cube).planes.size() == 6);  // five sides and the ground
}

TEST_CASE("truth__adds_up_to_the_area_of_the_faces_and_gives_their_planes") {
  for (const char* name : {"facade", "street", "insa", "lycee", "arches", "residence"}) {
    CAPTURE(name);
    const Model model = scene(name);
    const auto faces = faces_by_id(model);
    const Truth truth = truth_of(model, 0);
    double of_faces = 0, of_planes = 0;
    for (const Face& face : model.faces) of_faces += face.area_m2;
    for (const TruePlane& p : truth.planes) {
      of_planes += p.area_m2;
      const Plane& plane = faces.at(p.face).front()->plane;
      REQUIRE(norm(p.plane.normal - plane.normal) < 1e-9);
      REQUIRE(std::abs(p.plane.offset - plane.offset) < 1e-9);
    }
    CHECK(of_planes == doctest::Approx(of_faces).epsilon(1e-9));
    for (size_t t = 0; t < model.triangles.size(); ++t)
      if (const uint32_t s = truth.triangle_segments[t]; s != kNoSegment)
        for (const uint32_t v : model.triangles[t])
          REQUIRE(std::abs(truth.planes[s - 1].plane.distance(model.vertices[v])) < 1e-6);
  }
}
