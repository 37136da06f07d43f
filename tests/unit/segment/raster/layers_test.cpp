// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/layers.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "segment/raster/pixel_growth.h"
#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Points at random in a box: several in most pixels, of many depths.
std::vector<Vec3> scattered(size_t count) {
  RandomStream random(11, 0);
  std::vector<Vec3> points;
  for (size_t i = 0; i < count; ++i)
    points.push_back({4 * random.uniform(), 3 * random.uniform(), 2 * random.uniform()});
  return points;
}

bool same_bits(const DepthImage& a, const DepthImage& b) {
  if (a.columns != b.columns || a.rows != b.rows || !(a.low == b.low) || a.pixel_m != b.pixel_m ||
      a.occupied != b.occupied || a.quantum_m != b.quantum_m)
    return false;
  for (size_t p = 0; p < a.size(); ++p)
    if (a.occupied[p] != 0 && (a.pixels[p].u != b.pixels[p].u || a.pixels[p].v != b.pixels[p].v ||
                               a.pixels[p].g != b.pixels[p].g))
      return false;
  return true;
}

}  // namespace

TEST_CASE("raster_layers__each_image_is_that_of_the_points_left_to_the_bit") {
  const ImageAxes along[] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
  for (const PixelReturn returns : {PixelReturn::kNearest, PixelReturn::kMedian})
    for (const uint32_t grey_bits : {0u, 8u}) {
      MadeScene made(scattered(4000));
      RasterSettings settings;
      settings.returns = returns;
      settings.grey_bits = grey_bits;
      RasterLayers layers(made.scene, settings);
      RandomStream random(5, 1);
      size_t kept_pixels = 0;
      for (const ImageAxes& axes : along) {
        layers.look_along(axes);
        for (int layer = 0; layer < 6; ++layer) {
          CAPTURE(layer);
          layers.show(0.1, made.task);
          CHECK(same_bits(layers.image(), depth_image(made.scene, settings, axes, 0.1, made.task)));
          const auto& changed = layers.changed();
          if (!changed.empty())
            kept_pixels += static_cast<size_t>(std::count(changed.begin(), changed.end(), 0));
          // What a plane takes is in the middle of the box or, in the third layer, on its sides too.
          for (size_t k = 0; k < layers.points(); ++k) {
            const uint32_t i = layers.position(k);
            const Vec3 p = made.scene.local(i);
            const bool inside = p.x > 0.5 && p.x < 2 && p.y > 0.5 && p.y < 2;
            if ((inside || layer == 2) && random.uniform() < 0.2) made.scene.owner[i] = 1;
          }
          layers.drop_taken();
          CHECK(layers.points() == static_cast<size_t>(std::count(made.scene.owner.begin(),
                                                                  made.scene.owner.end(), 0u)));
        }
      }
      CHECK((kept_pixels > 0) == (returns == PixelReturn::kNearest));
    }
}

TEST_CASE("raster_layers__seeds_of_what_changed_are_those_of_the_whole_image") {
  Scene scene;
  RandomStream random(8, 0);
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 3, 0}, 6000, 0.002, random);
  scene.rectangle(2, {1, 1, 0.5}, {2, 0, 0}, {0, 1, 0}, 1500, 0.002, random);
  MadeScene made(scene.points);
  const RasterSettings settings;
  RasterLayers layers(made.scene, settings);
  layers.look_along({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const PixelRule rule{.tolerance_m = 0.02};
  PixelSeeds kept;
  for (int layer = 0; layer < 3; ++layer) {
    layers.show(0.1, made.task);
    kept.look_at(layers.image(), rule, layers.changed(), made.task);
    PixelSeeds whole;
    whole.look_at(layers.image(), rule, {}, made.task);
    CHECK(kept.in_order() == whole.in_order());
    CHECK_FALSE(kept.in_order().empty());
    CHECK(layers.changed().empty() == (layer == 0));
    for (size_t k = 0; k < layers.points(); ++k)
      if (made.scene.local(layers.position(k)).z > 0.3 && k % 2 == 0)
        made.scene.owner[layers.position(k)] = 1;
    layers.drop_taken();
  }
}
