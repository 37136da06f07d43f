// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "scan/scenes/grid_facade.h"
#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// A small school block against the depths that its header tells, rays, the volume of its balconies and its shares.

namespace {

/// 3 m of closed wall and three bays of 4 m, two storeys of 3 m, 2 m of wall above them.
GridFacade small_block() {
  return {.wall_width_m = 3,
          .bay_width_m = 4,
          .bays = 3,
          .storeys = 2,
          .storey_height_m = 3,
          .band_height_m = 0.3,
          .post_width_m = 0.4,
          .front_y = -0.5,
          .wall_y = 0,
          .breast_y = 0.1,
          .glass_y = 0.3,
          .mullion_y = -0.1,
          .breast_height_m = 1,
          .window_height_m = 1.7,
          .mullion_width_m = 0.2,
          .mullions = 1,
          .cornice_z = 8,
          .cornice_height_m = 0.4,
          .cornice_y = -1.5,
          .curtain_share = 0,
          .open_share = 0,
          .curtain_nearest_y = 0.4,
          .curtain_farthest_y = 0.6,
          .balcony_depth_m = 0};
}

Model block(const GridFacade& facade, uint64_t seed = 1) {
  SceneBuilder out{Transform{}};
  build_grid_facade(facade, {seed, 0}, out);
  return out.take();
}

size_t faces_in(const Model& model, const std::string& part_class) {
  return ids_of(model, part_class).size();
}

}  // namespace

TEST_CASE("grid_facade__each_element_stands_at_its_depth") {
  for (const bool has_lintel : {false, true}) {
    CAPTURE(has_lintel);
    GridFacade facade = small_block();
    if (has_lintel) facade.window_height_m = 1.4;  // of 2.7 m between floor and band 0.3 m are left
    CHECK(facade.width() == doctest::Approx(15));
    const Model model = block(facade);
    const auto is_at = [&](double x, double z, double y) {
      CAPTURE(x);
      CAPTURE(z);
      CHECK(std::abs(front_y(model, x, z) - y) < kRounding_m);
    };
    is_at(1.5, 4, 0);
    is_at(1.5, 8.2, -1.5);
    for (const double post : {3.2, 7.2, 11.2, 14.8}) is_at(post, 5.5, -0.5);
    for (int i = 0; i < 3; ++i) {
      is_at(5 + 4 * i, 7, 0);  // above the windows
      for (int k = 0; k < 2; ++k) {
        const double window = 4.2 + 4 * i, floor = 3 * k;
        is_at(window, floor + 0.5, 0.1);
        is_at(window, floor + 1.8, 0.3);
        is_at(window, floor + 2.6, has_lintel ? 0.1 : 0.3);
        is_at(window, floor + 2.8, -0.5);
        is_at(5 + 4 * i, floor + 1.8, -0.1);  // the mullion, amid the bay from post to post
        is_at(5 + 4 * i, floor + 0.9, 0.1);
      }
    }
  }
}

TEST_CASE("grid_facade__no_ray_from_the_front_gets_behind_the_glass_or_sees_a_back") {
  for (const double window_height : {1.7, 1.4})
    for (const double mullion_y : {-0.1, 0.2}) {
      CAPTURE(window_height);
      CAPTURE(mullion_y);
      GridFacade facade = small_block();
      facade.window_height_m = window_height;
      facade.mullion_y = mullion_y;  // before the breast walls, and behind them
      const Model model = block(facade);
      RandomStream random(2, 0);
      for (int k = 0; k < 1000; ++k) {
        const Vec3 eye{1 + 13 * random.uniform(), -3, 0.5 + 7 * random.uniform()};
        const Vec3 behind{15 * random.uniform(), 0.3, 8.4 * random.uniform()};
        const Hit hit = first_hit(model, eye, behind - eye);
        REQUIRE(hit.distance <= 1 + kRounding_m);
        REQUIRE(hit.is_front);
      }
    }
}

TEST_CASE("grid_facade__opens_and_curtains_the_told_shares_of_its_windows") {
  GridFacade facade = small_block();
  facade.bays = 20;
  facade.storeys = 10;
  facade.cornice_z = 32;
  facade.mullions = 3;
  facade.open_share = 0.1;
  facade.curtain_share = 0.3;
  constexpr size_t kWindows = 20 * 10 * 4;
  const Model model = block(facade);
  CHECK(parts_named(model, "window").size() == kWindows);
  const size_t glass = faces_in(model, "glass"), curtains = faces_in(model, "curtain");
  CHECK(is_binomial(kWindows - glass, kWindows, 0.1));
  CHECK(is_binomial(curtains, kWindows, 0.3));
  // Curtains are spread evenly between their bounds: 0.5 m on average, 0.2 m / sqrt 12 about it.
  double sum = 0;
  for (const Face& face : model.faces) {
    if (model.parts[face.part].part_class != "curtain") continue;
    CHECK(-face.plane.offset >= 0.4);
    CHECK(-face.plane.offset <= 0.6);
    sum -= face.plane.offset;
  }
  const double n = static_cast<double>(curtains);
  CHECK(std::abs(sum / n - 0.5) < 5 * 0.2 / std::sqrt(12 * n));
  CHECK(block(facade).triangle_faces == model.triangle_faces);
  CHECK(block(facade, 2).faces.size() != model.faces.size());
}

TEST_CASE("grid_facade__balconies_are_solid_trays_in_every_second_bay_above_the_ground_floor") {
  GridFacade facade = small_block();
  facade.balcony_depth_m = 0.8;
  const Model model = block(facade);
  const std::vector<uint32_t> balconies = parts_named(model, "balcony");
  REQUIRE(balconies.size() == 2);
  const double middles[] = {5.2, 13}, widths[] = {3.6 / 2, 3.2 / 2};  // the last bay has two posts
  for (size_t b = 0; b < 2; ++b) {
    // Slab, front and side parapets 0.1 m thick; the front of the house closes slab and sides.
    const double slab = widths[b] * 0.8 * 0.1, rail = (widths[b] + 2 * 0.7) * 0.1 * 1.0;
    const Shell shell = shell_of(model, ids_of(model, "balcony", balconies[b]), {0, -0.5, 0});
    CHECK(std::abs(shell.volume_m3 - slab - rail) < kRounding_m);
    CHECK(norm(shell.vector_area + Vec3{0, widths[b] * 0.1 + 2 * 0.1, 0}) < kRounding_m);
    for (const double aside : {-0.49, 0.0, 0.49})
      CHECK(front_y(model, middles[b] + aside * widths[b], 3.99) == doctest::Approx(-1.3));
    CHECK(front_y(model, middles[b], 4.01) > -0.5);
    CHECK(front_y(model, middles[b] + 0.51 * widths[b], 3.5) > -0.5);
  }
  CHECK(faces_in(block(small_block()), "balcony") == 0);
}
