// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/glb/meshes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "formats/face_geometry.h"

using namespace jalon;

namespace {

double area_of(const glb::Mesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.corners.size(); i += 3) {
    const auto at = [&](size_t k) {
      const auto& p = mesh.places[mesh.corners[i + k]];
      return Vec3{p[0], p[1], p[2]};
    };
    sum += norm(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return sum;
}

}  // namespace

TEST_CASE("glb_meshes__a_wall_with_a_hole_keeps_its_area_and_the_opening_is_an_outline") {
  Model model;
  model.parts = {{"wall", "wall"}, {"window", "window"}};
  Face face;
  face.plane = {{0, -1, 0}, 0};
  face.sigma_m = 0.003;
  face.area_m2 = 11;
  const Vec3 o{652000.5, 6861000, 100.25};
  model.add_face(face,
                 {{o, o + Vec3{4, 0, 0}, o + Vec3{4, 0, 3}, o + Vec3{0, 0, 3}},
                  {o + Vec3{1, 0, 1}, o + Vec3{1, 0, 2}, o + Vec3{2, 0, 2}, o + Vec3{2, 0, 1}}});
  model.rings[1].part = 1;
  Task task;
  const Vec3 origin = whole_metre_corner(model);
  CHECK(origin == Vec3{652000, 6861000, 100});
  const auto meshes = glb::meshes_of(model, origin, task);
  REQUIRE(meshes.size() == 2);
  CHECK(meshes[0].part == 0);
  CHECK(area_of(meshes[0]) == doctest::Approx(11));
  CHECK(meshes[0].sigma_m == 0.003);
  for (const auto& n : meshes[0].normals) CHECK(n == glb::Float3{0, -1, 0});
  CHECK(meshes[1].corners.empty());
  CHECK(meshes[1].outline_ends.size() == 8);
  CHECK(meshes[1].outline_places[0] == glb::Float3{1.5f, 0, 1.25f});
}

TEST_CASE("glb_meshes__loose_triangles_are_a_mesh_of_their_own_without_flat_ones") {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  model.triangles = {{0, 1, 2}, {0, 1, 3}};
  model.triangle_faces = {5, 5};
  Task task;
  const auto meshes = glb::meshes_of(model, {}, task);
  REQUIRE(meshes.size() == 1);
  CHECK(meshes[0].part == kNoPart);
  CHECK(meshes[0].corners.size() == 3);
  CHECK(meshes[0].normals[0] == glb::Float3{0, 0, 1});
  CHECK(glb::meshes_of({}, {}, task).empty());
}
