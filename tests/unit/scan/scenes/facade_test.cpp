// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"
#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// The town house against the rectangle that its front must fill, and against what rays meet in each bay.

namespace {

const SceneSettings kHouses[] = {
    {},
    {.width_m = 13, .height_m = 12.5, .storeys = 4, .bays = 5, .doors = 1, .frame_m = 0.03},
    {.width_m = 9, .height_m = 6, .storeys = 2, .bays = 4, .doors = 4, .cornice_m = 0},
    {.width_m = 4,
     .height_m = 4,
     .storeys = 1,
     .bays = 1,
     .doors = 0,
     .reveal_m = 0.5,
     .ground_m = 0}};

/// Bays of the doors, counted from 0, from their names "door STOREY.BAY".
std::vector<int> door_bays(const Model& model) {
  std::vector<int> out;
  for (const uint32_t p : parts_named(model, "door")) {
    const std::string& name = model.parts[p].name;
    out.push_back(std::atoi(name.c_str() + name.find('.') + 1) - 1);
  }
  return out;
}

}  // namespace

TEST_CASE("scene_facade__its_faces_fill_the_front_once_whatever_the_sizes") {
  for (const SceneSettings& house : kHouses) {
    CAPTURE(house.bays);
    const Model model = built(build_facade, house);
    CHECK_NOTHROW(validate(model));
    double front = 0;
    for (const Face& face : model.faces)
      if (face.plane.normal.y < -0.5) front += face.area_m2;
    CHECK(front == doctest::Approx(house.width_m * house.height_m));
    RandomStream random(1, 0);
    for (int k = 0; k < 200; ++k) {
      const double x = house.width_m * random.uniform(), z = house.height_m * random.uniform();
      const Hit hit = first_hit(model, {x, -50, z}, {0, 1, 0});
      REQUIRE(hit.is_front);
      REQUIRE(hit.distance - 50 < 1.5 * house.reveal_m + house.frame_m + kRounding_m);
    }
  }
}

TEST_CASE("scene_facade__has_one_opening_in_each_bay_with_the_depth_of_its_storey") {
  const double storey_depths[] = {1.25, 1, 0.75, 1.25};  // of the parameter, as its row says
  for (const SceneSettings& house : kHouses) {
    CAPTURE(house.bays);
    const Model model = built(build_facade, house);
    const std::vector<int> doors = door_bays(model);
    CHECK(parts_named(model, "window").size() + doors.size() ==
          static_cast<size_t>(house.bays * house.storeys));
    const double bay = house.width_m / static_cast<double>(house.bays),
                 storey = (house.height_m - 0.5) / static_cast<double>(house.storeys);
    for (int s = 0; s < house.storeys; ++s)
      for (int b = 0; b < house.bays; ++b) {
        const bool is_door = s == 0 && std::count(doors.begin(), doors.end(), b) == 1;
        const double depth = house.reveal_m * (is_door ? 1.5 : storey_depths[s]);
        const double met = front_y(model, bay * (b + 0.5), storey * (s + 0.6));
        CHECK(met == doctest::Approx(depth + (is_door ? 0 : house.frame_m)));
      }
  }
}

TEST_CASE("scene_facade__spreads_its_doors_evenly_over_the_bays") {
  for (int bays = 1; bays <= 12; ++bays)
    for (int doors = 1; doors <= 14; ++doors) {
      CAPTURE(bays);
      CAPTURE(doors);
      const Model model =
          built(build_facade, {.width_m = 2.0 * bays, .storeys = 1, .bays = bays, .doors = doors});
      const std::vector<int> at = door_bays(model);
      REQUIRE(at.size() == static_cast<size_t>(std::min(bays, doors)));
      const double even = static_cast<double>(bays) / static_cast<double>(at.size());
      for (size_t d = 1; d < at.size(); ++d) CHECK(std::abs(at[d] - at[d - 1] - even) < 1);
      CHECK(std::abs(at.front() - (bays - 1 - at.back())) <= 1);  // as far from both ends
    }
}

TEST_CASE("scene_facade__ground_lies_before_the_plinth_and_in_the_doorways_to_their_leaves") {
  const Model model = built(build_facade, {.width_m = 8, .bays = 4, .doors = 1, .ground_m = 3});
  const std::vector<int> doors = door_bays(model);
  REQUIRE(doors.size() == 1);
  const double door_x = 2.0 * doors[0] + 1, leaf = 1.5 * 0.20;
  const auto has_ground = [&](double x, double y) {
    return std::abs(first_hit(model, {x, y, 0.2}, {0, 0, -1}).distance - 0.2) < kRounding_m;
  };
  for (const double x : {-3.99, 0.5, door_x, 7.5, 11.99}) {
    CHECK(has_ground(x, -2.99));
    CHECK(has_ground(x, -0.06));
    CHECK(!has_ground(x, -3.01));
    CHECK(has_ground(x, leaf - 0.01) == (x == door_x));
    CHECK(!has_ground(x, leaf + 0.01));
  }
  CHECK(!has_ground(-4.01, -1));
  CHECK(parts_named(built(build_facade, {.ground_m = 0}), "ground").empty());
}

TEST_CASE("scene_facade__ground_of_any_depth_is_sound_and_reaches_into_every_doorway") {
  for (const double ground_m : {1e-6, 0.02, 0.05, 0.0500001, 0.06, 1.0})
    for (const int doors : {0, 1, 2, 4})
      for (const double reveal_m : {0.0, 0.2}) {
        CAPTURE(ground_m);
        CAPTURE(doors);
        CAPTURE(reveal_m);
        const Model model = built(
            build_facade,
            {.width_m = 8, .bays = 4, .doors = doors, .reveal_m = reveal_m, .ground_m = ground_m});
        for (const Face& face : model.faces) CHECK(is_sound(model, face));
        const bool has_ground = doors > 0 || ground_m > 0.05;  // the plinth's depth
        CHECK(ids_of(model, "ground").empty() != has_ground);
        CHECK(parts_named(model, "ground").size() == (has_ground ? 1 : 0));
        for (const int bay : door_bays(model))
          for (const double y : {-0.9 * ground_m, 0.99 * 1.5 * reveal_m})
            CHECK(std::abs(first_hit(model, {2.0 * bay + 1, y, 0.2}, {0, 0, -1}).distance - 0.2) <
                  kRounding_m);
      }
}

TEST_CASE("scene_facade__refuses_bays_below_1_60_m_and_storeys_below_2_20_m_by_name") {
  const auto refusal = [](const SceneSettings& settings) -> std::string {
    try {
      built(build_facade, settings);
    } catch (const Error& e) {
      CHECK(e.status() == Status::kInvalidArgument);
      return e.what();
    }
    return {};
  };
  CHECK(refusal({.width_m = 16, .bays = 10}).empty());
  CHECK(refusal({.width_m = 16, .bays = 11}).find("11 bays") != std::string::npos);
  CHECK(
      refusal({.height_m = 7.11, .storeys = 3}).empty());  // the cornice's 0.5 m and three storeys
  CHECK(refusal({.height_m = 7.09, .storeys = 3}).find("3 storeys") != std::string::npos);
}
