// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/drawings/depth_image.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("depth_image__has_of_each_pixel_the_point_nearest_to_the_viewer") {
  const Cloud cloud = random_points(3000, 7);
  WriteSettings settings;
  settings.png_pixel_m = 2.5;
  Task task;
  for (const std::vector<double>& direction :
       {std::vector<double>{}, std::vector<double>{0, -1, 0}, std::vector<double>{1, 1, 0.5}}) {
    settings.png_direction = direction;
    const DepthRaster image = depth_image_of(cloud, settings, "a", task);
    std::vector<double> nearest(image.depths.size(), kNoDepth);
    for (size_t i = 0; i < cloud.size(); ++i) {
      const auto at = image.axes.of(cloud.point(i));
      const auto column = static_cast<size_t>((at[0] - image.low[0]) / 2.5),
                 row = image.rows - 1 - static_cast<size_t>((at[1] - image.low[1]) / 2.5);
      double& pixel = nearest[row * image.columns + column];
      pixel = std::max(pixel, at[2]);
    }
    CHECK(image.depths == nearest);
    CHECK(*std::ranges::max_element(nearest) ==
          doctest::Approx(image.low[2] + image.range_m).epsilon(1e-12));
  }
}
