// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model day(int number) { return scene("earthworks", {{"day", static_cast<double>(number)}}); }

/// Volume between the ground and z = -10.
double volume_m3(const Model& model) {
  double volume = 0;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    if (model.triangle_faces[t] > 3) continue;
    const auto& [a, b, c] = model.triangles[t];
    const Vec3 &p = model.vertices[a], &q = model.vertices[b], &r = model.vertices[c];
    volume += cross(q - p, r - p).z / 2 * ((p.z + q.z + r.z) / 3 + 10);
  }
  return volume;
}

std::map<uint32_t, size_t> triangles_by_id(const Model& model) {
  std::map<uint32_t, size_t> out;
  for (const uint32_t id : model.triangle_faces) ++out[id];
  return out;
}

}  // namespace

TEST_CASE("scene_earthworks__heap_and_pit_have_their_volumes") {
  const double first = volume_m3(day(1)), second = volume_m3(day(2)), third = volume_m3(day(3));
  CHECK(second - first == doctest::Approx(3.14159265358979 * 1.5 * 1.5 / 3).epsilon(0.01).scale(0));
  CHECK(second - third == doctest::Approx(40.6).epsilon(0.002));
  CHECK(volume_m3(day(4)) == doctest::Approx(third).epsilon(1e-12));
}

TEST_CASE("scene_earthworks__ids_are_those_of_the_header_on_all_days") {
  for (int number = 1; number <= 4; ++number) {
    const auto ids = triangles_by_id(day(number));
    CHECK(ids.count(1) == 1);
    CHECK(ids.count(2) == (number >= 2));
    CHECK(ids.count(3) == (number >= 3));
    for (uint32_t id = 4; id <= 5; ++id) CHECK(ids.at(id) == 2);
    for (uint32_t id = 6; id <= 10; ++id) CHECK(ids.count(id) == (number <= 3));
    for (uint32_t id = 11; id <= 22; ++id) CHECK(ids.count(id) == (number >= 3));
  }
}

TEST_CASE("scene_earthworks__the_excavator_moves_six_metres") {
  const auto middle = [](const Model& model) {
    Vec3 sum;
    size_t n = 0;
    for (const Face& face : model.faces)
      if (model.parts[face.part].name == "body")
        for (const auto& triangle : model.triangles)
          if (model.triangle_faces[static_cast<size_t>(&triangle - model.triangles.data())] ==
              face.id)
            for (const uint32_t v : triangle) sum += model.vertices[v], ++n;
    return sum / static_cast<double>(n);
  };
  const Vec3 moved = middle(day(4)) - middle(day(3));
  CHECK(std::hypot(moved.x, moved.y) == doctest::Approx(6));
  CHECK_THROWS(day(5));
}
