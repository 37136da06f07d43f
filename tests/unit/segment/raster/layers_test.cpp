// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/layers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

std::vector<uint32_t> all_positions(const MadeScene& made) {
  std::vector<uint32_t> out(made.scene.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

// The image of the free points with the same pixels, by the definition.
bool is_image_of_the_points_left(const DepthImage& image, const SegmentScene& scene,
                                 const RasterSettings& settings) {
  std::vector<std::vector<std::pair<float, uint32_t>>> returns(image.size());
  for (uint32_t i = 0; i < scene.size(); ++i)
    if (scene.owner[i] == 0) {
      const auto depth = static_cast<float>(dot(scene.local(i), image.axes.n));
      returns[image.pixel_of(scene.local(i))].push_back({-depth, i});  // the nearest first
    }
  for (size_t p = 0; p < image.size(); ++p) {
    auto& own = returns[p];
    if (image.occupied[p] != (own.empty() ? 0 : 1)) return false;
    if (own.empty()) continue;
    std::sort(own.begin(), own.end());
    const auto& shown =
        settings.returns == PixelReturn::kNearest ? own[0] : own[(own.size() - 1) / 2];
    const auto off = static_cast<double>(image.pixels[p].g + shown.first);
    if (settings.grey_bits > 0 ? std::fabs(off) > 0.501 * image.quantum_m : off != 0) return false;
  }
  return true;
}

// Takes points as a plane does; the pixels they were in.
std::vector<uint32_t> take_some(MadeScene& made, const DepthImage& image, bool anywhere,
                                RandomStream& random) {
  std::vector<uint32_t> pixels;
  for (uint32_t i = 0; i < made.scene.size(); ++i) {
    const Vec3 p = made.scene.local(i);
    const bool inside = p.x > 0.5 && p.x < 2 && p.y > 0.5 && p.y < 2;
    if (made.scene.owner[i] != 0 || !(inside || anywhere) || random.uniform() > 0.2) continue;
    made.scene.owner[i] = 1;
    pixels.push_back(static_cast<uint32_t>(image.pixel_of(p)));
  }
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

}  // namespace

TEST_CASE("raster_layers__each_image_is_that_of_the_points_left") {
  const ImageAxes along[] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
  for (const PixelReturn returns : {PixelReturn::kNearest, PixelReturn::kMedian})
    for (const uint32_t grey_bits : {0u, 8u}) {
      MadeScene made(scattered(4000));
      RasterSettings settings;
      settings.returns = returns;
      settings.grey_bits = grey_bits;
      const std::vector<uint32_t> all = all_positions(made);
      RasterLayers layers(made.scene, settings, all);
      RandomStream random(5, 1);
      for (const ImageAxes& axes : along) {
        layers.look_along(axes, 0.1, made.task);
        CHECK(is_image_of_the_points_left(layers.image(), made.scene, settings));
        for (int layer = 1; layer < 6; ++layer) {
          CAPTURE(layer);
          // In the third layer from the sides of the box too.
          layers.look_behind(take_some(made, layers.image(), layer == 2, random), made.task);
          CHECK(is_image_of_the_points_left(layers.image(), made.scene, settings));
        }
      }
    }
}

TEST_CASE("raster_layers__each_point_is_in_its_pixel_and_in_no_other") {
  MadeScene made(scattered(3000));
  for (uint32_t i = 0; i < 3000; i += 3) made.scene.owner[i] = 1;
  const RasterSettings settings;
  const std::vector<uint32_t> all = all_positions(made);
  RasterLayers layers(made.scene, settings, all);
  layers.look_along({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0.1, made.task);
  std::vector<int> met(made.scene.size(), 0);
  for (size_t p = 0; p < layers.image().size(); ++p)
    for (const uint32_t i : layers.points_of(p)) {
      ++met[i];
      CHECK(layers.image().pixel_of(made.scene.local(i)) == p);
    }
  for (uint32_t i = 0; i < 3000; ++i) CHECK(met[i] == (i % 3 == 0 ? 0 : 1));
}

TEST_CASE("raster_layers__seeds_where_something_changed_are_those_of_the_whole_image_there") {
  Scene scene;
  RandomStream random(8, 0);
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 3, 0}, 6000, 0.002, random);
  scene.rectangle(2, {1, 1, 0.5}, {2, 0, 0}, {0, 1, 0}, 1500, 0.002, random);
  MadeScene made(scene.points);
  const RasterSettings settings;
  const std::vector<uint32_t> all = all_positions(made);
  RasterLayers layers(made.scene, settings, all);
  layers.look_along({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0.1, made.task);
  const DepthImage& image = layers.image();
  const PixelRule rule{.tolerance_m = 0.02};
  std::vector<uint32_t> changed;
  for (uint32_t i = 0; i < made.scene.size(); ++i)
    if (made.scene.local(i).z > 0.3) {
      made.scene.owner[i] = 1;
      changed.push_back(static_cast<uint32_t>(image.pixel_of(made.scene.local(i))));
    }
  layers.look_behind(changed, made.task);
  std::vector<uint32_t> wanted;
  for (const uint32_t seed : pixel_seeds(image, rule, made.task))
    if (std::any_of(changed.begin(), changed.end(), [&](uint32_t p) {
          const auto apart = [](uint32_t a, uint32_t b) { return a > b ? a - b : b - a; };
          return apart(p % image.columns, seed % image.columns) <= 1 &&
                 apart(p / image.columns, seed / image.columns) <= 1;
        }))
      wanted.push_back(seed);
  CHECK(pixel_seeds(image, rule, changed, made.task) == wanted);
  CHECK(wanted.size() > 100);
}
