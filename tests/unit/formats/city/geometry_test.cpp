// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The grid of vertices against its own step; the order of surfaces against scenes whose buildings are known.
#include "formats/city/geometry.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "formats/city/parts.h"
#include "model/chords.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Part city_part(const char* part_class, uint64_t parent) {
  Part part;
  part.name = part_class;
  part.part_class = part_class;
  part.parent = parent;
  return part;
}

double largest_coordinate(const Vec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

}  // namespace

TEST_CASE("city_geometry__gutters_are_installed_on_the_building_above_them") {
  Model model;
  for (const auto& [part_class, parent] : {std::pair<const char*, uint64_t>{"building", kNoParent},
                                           {"wall", 0},
                                           {"gutter", 0},
                                           {"gutter", kNoParent}})
    model.parts.push_back(city_part(part_class, parent));
  for (uint32_t part = 1; part < 4; ++part) {
    Face face;
    face.part = part;
    const double x = part;
    model.add_face(face, {{{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 0, 1}}});
  }
  city::Grid grid(model, 0.001);
  Task task;
  const city::City city = city::arrange(model, grid, task);
  REQUIRE(city.objects.size() == 3);
  CHECK(city.objects.at(0).geometries.at(0).surfaces.size() == 1);
  CHECK(city.objects.at(2).parent == 0);
  CHECK(city.objects.at(2).geometries.at(0).surfaces.size() == 1);
  CHECK(city.objects.at(kNoPart).geometries.at(0).surfaces.size() == 1);  // of no building
}

TEST_CASE("city_grid__keeps_every_place_once_and_to_half_a_step") {
  constexpr double kStep_m = 0.01;
  constexpr double kRounding_m = 4e-9;  // four roundings of numbers below 2^23
  RandomStream random(1, 1);
  Model model;
  for (int i = 0; i < 400; ++i)
    model.vertices.push_back({652000.3 + 0.2 * random.uniform(), 6861000.7 + 0.2 * random.uniform(),
                              -3.4 + 0.1 * random.uniform()});
  city::Grid grid(model, kStep_m);
  CHECK(grid.translate() == Vec3{652000, 6861000, -4});  // whole metres
  std::vector<uint32_t> index;
  for (const Vec3& p : model.vertices) {
    index.push_back(grid.add(p));
    CHECK(largest_coordinate(grid.place(index.back()) - p) <= kStep_m / 2 + kRounding_m);
    CHECK(grid.add(grid.place(index.back())) == index.back());
  }
  CHECK(std::set(grid.steps().begin(), grid.steps().end()).size() == grid.steps().size());
  CHECK(*std::ranges::max_element(index) + 1 == grid.steps().size());
  size_t merged = 0;  // pairs further apart than a step with one index
  for (size_t i = 0; i < index.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      merged += index[i] == index[j] &&
                largest_coordinate(model.vertices[i] - model.vertices[j]) > kStep_m + kRounding_m;
  CHECK(merged == 0);
}

TEST_CASE("city_grid__refuses_steps_that_whole_numbers_of_json_cannot_count") {
  Model model;
  model.vertices = {{0, 0, 0}, {0, 1e9, 0}};
  city::Grid fine(model, 1e-6);  // 10^15 steps
  const Vec3 far = fine.place(fine.add({0, 1e9, 0}));
  CHECK(norm(far - model.vertices[1]) <= 0.5e-6 + 2.4e-7);  // half a step and two roundings
  const Failure failure = failure_of([&] { city::Grid(model, 1e-7); });  // 10^16 > 2^53
  CHECK(failure.status == Status::kLimit);
  CHECK(failure.text.find("city_scale_m") != std::string::npos);
  CHECK(city::Grid(Model{}, 1e-7).steps().empty());
}

TEST_CASE(
    "city_arrange__solids_stand_apart_and_holes_without_joinery_are_closed_by_their_own_edge") {
  const Model model = with_chords(House().model(), 0.001);
  Task task;
  city::Grid grid(model, 1e-4);
  const city::City city = arrange(model, grid, task);
  REQUIRE(city.objects.size() == 1);
  const city::Object& house = city.objects.at(0);
  REQUIRE(house.geometries.size() == 2);
  CHECK(house.geometries[0].solid);
  CHECK(house.geometries[0].surfaces.size() == 6);
  CHECK_FALSE(house.geometries[1].solid);
  CHECK(city.has_openings);
  CHECK(city.dropped == 0);
  std::vector<int> seen(model.faces.size(), 0);
  for (uint32_t p = 0; p < model.parts.size(); ++p)
    for (const uint32_t f : city.faces_of_part[p]) {
      CHECK(model.faces[f].part == p);
      ++seen[f];
    }
  CHECK(std::ranges::all_of(seen, [](int n) { return n == 1; }));
  // Door, copy and round window have no surface of their own; the first window has its pane.
  std::vector<std::string> closed;
  for (uint32_t p = 0; p < model.parts.size(); ++p)
    if (city.closing[p] != 0) closed.push_back(model.parts[p].name);
  CHECK(closed == std::vector<std::string>{"door", "window 2", "round"});
  const std::vector<city::Surface>& loose = house.geometries[1].surfaces;
  CHECK(loose.size() == model.faces.size() - 6 + closed.size());
  const auto wall =
      std::ranges::max_element(loose, {}, [](const auto& s) { return s.rings.size(); });
  for (const city::Surface& surface : loose)
    if (surface.part < model.parts.size() && city.closing[surface.part] != 0) {
      REQUIRE(surface.rings.size() == 1);
      std::vector<uint32_t> hole = surface.rings[0];
      std::ranges::reverse(hole);  // the opening looks where the wall looks, its hole the other way
      CHECK(std::ranges::count(wall->rings, hole) == 1);
    }
}

TEST_CASE("city_arrange__triangles_go_to_the_nearest_building_and_small_ones_are_counted") {
  Model model;
  model.parts = {city_part("building", kNoParent), city_part("building", 0), city_part("wall", 1),
                 city_part("mesh", kNoParent)};
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.0001, 0}};
  model.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 2, 3}, {0, 1, 3}, {0, 3, 1}, {1, 0, 3}};
  model.triangle_faces = {2, 3, 0, 0, 0, 0};
  Task task;
  city::Grid grid(model, 0.001);
  const city::City city = arrange(model, grid, task);
  CHECK(city.dropped == 3);  // those with two corners in one place
  REQUIRE(city.objects.size() == 3);
  CHECK(city.objects.at(0).parent == kNoPart);
  CHECK(city.objects.at(1).parent == 0);
  CHECK(city.objects.at(kNoPart).parent == kNoPart);
  for (const auto& [part, object] : city.objects) {
    REQUIRE(object.geometries.size() == 1);
    CHECK(object.geometries[0].surfaces.size() == 1);
  }
  CHECK(city.objects.at(1).geometries[0].surfaces[0].part == 2);
  CHECK_FALSE(city.has_openings);
}
