// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/ortho_points.h"

#include <doctest/doctest.h>

#include "unit/report/pictures/ortho_scene.h"

using namespace jalon;
using namespace ortho_scene;

TEST_CASE("ortho_points__the_spacing_is_that_of_the_part_that_they_cover") {
  Scene wall = scene(0.4);
  Task task;
  const auto spacing = [&](const Scene& s) {
    const Cloud cloud = s.cloud();
    const PlacedFacade facade = facades_side_by_side(s.model).at(0);
    return OrthoPoints(cloud, facade, {}, task).spacing_m(task);
  };
  const double whole_m = spacing(wall);
  CHECK(std::fabs(whole_m / kStep_m - 1) < 0.05);
  // A scan of the lower left quarter.
  Scene part = wall;
  part.points.clear(), part.red.clear(), part.green.clear(), part.blue.clear();
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 75; ++k)
      part.add_point((i + 0.5) * kStep_m, (k + 0.5) * kStep_m, 0, {1, 2, 3});
  CHECK(std::fabs(spacing(part) / kStep_m - 1) < 0.1);
}

TEST_CASE("ortho_points__what_is_no_number_is_not_shown") {
  const Scene wall = scene(0);
  Cloud cloud = wall.cloud(false);
  std::vector<float> intensity(wall.points.size(), 2);
  for (size_t i = 0; i < 150; ++i) intensity[i] = NAN;  // the first column of points
  intensity[400] = 5;
  cloud.fields.set(make_column<float>({"intensity"}, intensity));
  OrthoimageSettings settings;
  settings.pixel_m = kStep_m;
  settings.fill = 0;
  Task task;
  const Orthoimage image = make_orthoimage(cloud, wall.model, settings, kMostOrthoPixels, task);
  CHECK(image.content == OrthoContent::kIntensity);
  size_t in_first = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    if (image.has_data[i] == 0) continue;
    CHECK(std::isfinite(image.values[i]));
    in_first += i % image.columns == 0 ? 1 : 0;
  }
  CHECK(in_first == 0);
  std::ranges::fill(intensity, NAN);
  cloud.fields.set(make_column<float>({"intensity"}, intensity));
  CHECK(make_orthoimage(cloud, wall.model, settings, kMostOrthoPixels, task).content ==
        OrthoContent::kDistance);
}

TEST_CASE("ortho_points__colours_of_16_bits_and_of_floats_are_those_of_8") {
  const Scene wall = scene(0);
  OrthoimageSettings settings;
  settings.pixel_m = kStep_m;
  Task task;
  const auto colours = [&](auto factor) {
    using T = decltype(factor);
    Cloud cloud = wall.cloud(false);
    const std::vector<uint8_t>* parts[] = {&wall.red, &wall.green, &wall.blue};
    const char* names[] = {"red", "green", "blue"};
    for (int k = 0; k < 3; ++k) {
      std::vector<T> values;
      for (const uint8_t v : *parts[k]) values.push_back(static_cast<T>(v * factor));
      cloud.fields.set(make_column<T>({names[k]}, values));
    }
    return make_orthoimage(cloud, wall.model, settings, kMostOrthoPixels, task).colours;
  };
  const auto eight = colours(uint8_t{1});
  CHECK(colours(uint16_t{256}) == eight);
  CHECK(colours(1.0f / 255) == eight);
}
