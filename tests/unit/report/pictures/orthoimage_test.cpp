// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Orthoimages against a wall whose colours tell where they are.
#include "report/pictures/orthoimage.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/report/pictures/ortho_scene.h"

using namespace jalon;
using namespace ortho_scene;

namespace {

Orthoimage image_of(const Scene& scene, OrthoimageSettings settings, bool in_colour = true) {
  Task task;
  return make_orthoimage(scene.cloud(in_colour), scene.model, settings, kMostOrthoPixels, task);
}

std::array<int, 3> colour_at(const Orthoimage& image, size_t x, size_t y) {
  const uint8_t* c = image.colours.data() + 3 * (y * image.columns + x);
  return {c[0], c[1], c[2]};
}

Status status_of(const Scene& scene, const OrthoimageSettings& settings, bool in_colour = true) {
  try {
    image_of(scene, settings, in_colour);
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

}  // namespace

TEST_CASE("orthoimage__each_pixel_shows_what_lies_there_however_the_wall_is_turned") {
  for (const double angle : {0.0, 0.4, 1.9, 3.0, 4.6}) {
    const Scene wall = scene(angle);
    OrthoimageSettings settings;
    settings.pixel_m = kStep_m;
    const Orthoimage image = image_of(wall, settings);
    CHECK(image.content == OrthoContent::kColour);
    // Rounding at map coordinates may put the wall's end into one more pixel.
    REQUIRE(image.columns - 200 <= 1);
    REQUIRE(image.rows - 150 <= 1);
    CHECK(std::fabs(image.left_m) < 1e-6);
    const size_t first = static_cast<size_t>(std::lround((image.top_m - 103) / kStep_m));
    for (size_t y = 0; y < 150; ++y)
      for (size_t x = 0; x < 200; ++x) {
        const double s = (static_cast<double>(x) + 0.5) * kStep_m,
                     z = (149.5 - static_cast<double>(y)) * kStep_m;
        const std::array<int, 3> wanted =
            is_window(s, z) ? std::array{0, 0, 200}
                            : std::array{200, static_cast<int>(x), static_cast<int>(149 - y)};
        if (image.has_data[(y + first) * image.columns + x] == 0 ||
            colour_at(image, x, y + first) != wanted) {
          CAPTURE(x);
          CAPTURE(y);
          FAIL("another colour");
        }
      }
  }
}

TEST_CASE("orthoimage__what_lies_before_hides_what_lies_behind_within_the_depths_shown") {
  Scene wall = scene(0.7);
  wall.add_point(1.01, 0.51, 0.3, {9, 9, 9});   // a lamp before the wall
  wall.add_point(1.51, 0.51, 1.5, {8, 8, 8});   // a tree farther away
  wall.add_point(2.51, 1.51, -1.5, {7, 7, 7});  // a room behind the window
  OrthoimageSettings settings;
  settings.pixel_m = kStep_m;
  const Orthoimage image = image_of(wall, settings);
  const auto at = [&](double s, double z) {
    return colour_at(image, static_cast<size_t>((s - image.left_m) / kStep_m),
                     static_cast<size_t>((image.top_m - 100 - z) / kStep_m));
  };
  CHECK(at(1.01, 0.51) == std::array{9, 9, 9});
  CHECK(at(1.51, 0.51) == std::array{200, 75, 25});
  CHECK(at(2.51, 1.51) == std::array{0, 0, 200});
  settings.in_front_m = 2;
  CHECK(colour_at(image_of(wall, settings), 75, image.rows - 26) == std::array{8, 8, 8});
}

TEST_CASE("orthoimage__the_first_content_that_the_cloud_tells_is_taken") {
  const Scene wall = scene(0);
  const auto content = [&](Cloud cloud) {
    Task task;
    return make_orthoimage(cloud, wall.model, {}, kMostOrthoPixels, task).content;
  };
  CHECK(content(wall.cloud()) == OrthoContent::kColour);
  CHECK(content(wall.cloud(false)) == OrthoContent::kDistance);
  Cloud grey = wall.cloud(false);
  std::vector<uint16_t> intensity(wall.points.size(), 0);
  grey.fields.set(make_column<uint16_t>({"intensity"}, intensity));
  CHECK(content(grey) == OrthoContent::kDistance);  // the field is there, nothing was measured
  intensity[7] = 3;
  grey.fields.set(make_column<uint16_t>({"intensity"}, intensity));
  CHECK(content(grey) == OrthoContent::kIntensity);
}

TEST_CASE("orthoimage__distances_are_metres_before_the_front_plane") {
  OrthoimageSettings settings;
  settings.pixel_m = kStep_m;
  settings.content = OrthoContent::kDistance;
  const Orthoimage image = image_of(scene(0.4), settings);
  const auto at = [&](double s, double z) {
    return image.values[static_cast<size_t>((image.top_m - 100 - z) / kStep_m) * image.columns +
                        static_cast<size_t>((s - image.left_m) / kStep_m)];
  };
  CHECK(std::fabs(at(0.51, 0.51)) < 1e-6);
  CHECK(std::fabs(at(2.51, 1.51) + kDepth_m) < 1e-6);
  const OrthoColours colours = colours_of(image);
  CHECK(colours(0).red > 230);
  CHECK(colours(-kDepth_m).blue > colours(-kDepth_m).red);
}

TEST_CASE("orthoimage__pixels_without_points_have_no_data_but_for_small_holes") {
  Scene wall = scene(0);
  Scene holed = wall;
  holed.points.clear(), holed.red.clear(), holed.green.clear(), holed.blue.clear();
  for (size_t i = 0; i < wall.points.size(); ++i) {
    const Vec3 p = wall.points[i] - wall.foot;
    const bool is_hole = (p.x > 0.2 && p.x < 0.22 && p.z > 0.2 && p.z < 0.22) ||
                         (p.x > 1 && p.x < 1.5 && p.z > 0.2 && p.z < 0.7);
    if (!is_hole) holed.add_point(p.x, p.z, -p.y, {wall.red[i], 1, 1});
  }
  OrthoimageSettings settings;
  settings.pixel_m = kStep_m;
  const auto holes = [&](int64_t fill) {
    settings.fill = fill;
    const Orthoimage image = image_of(holed, settings);
    size_t count = 0;
    for (size_t y = 2; y + 2 < image.rows; ++y)
      for (size_t x = 2; x + 2 < image.columns; ++x)
        count += image.has_data[y * image.columns + x] == 0 ? 1 : 0;
    return count;
  };
  CHECK(holes(0) == 1 + 25 * 25);
  const size_t left = holes(1);
  CHECK(left <= 25 * 25);
  CHECK(left >= 25 * 25 - 4);  // corners at most
  const RgbaImage shown = rgba_of(image_of(holed, settings));
  const size_t clear = static_cast<size_t>(std::ranges::count(shown.pixels, uint8_t{0}));
  CHECK(clear >= 4 * left);  // transparent
}

TEST_CASE("orthoimage__pixels_are_told_by_the_spacing_and_have_a_bound") {
  const Scene wall = scene(0);
  const double pixel_m = image_of(wall, {}).pixel_m;
  CHECK(pixel_m >= 0.030);
  CHECK(pixel_m <= 0.031);
  Task task;
  CHECK(make_orthoimage(wall.cloud(), wall.model, {}, 100, task).size() <= 140);
  OrthoimageSettings fine;
  fine.pixel_m = 1e-5;
  CHECK(status_of(wall, fine) == Status::kLimit);
}

TEST_CASE("orthoimage__what_cannot_be_shown_is_told") {
  Scene wall = scene(0);
  OrthoimageSettings second;
  second.facade = 2;
  CHECK(status_of(wall, second) == Status::kInvalidArgument);
  OrthoimageSettings colour;
  colour.content = OrthoContent::kColour;
  CHECK(status_of(wall, colour, false) == Status::kInsufficientData);
  Scene far = wall;
  for (Vec3& p : far.points) p.y -= 50;
  CHECK(status_of(far, {}) == Status::kInsufficientData);
  wall.model = {};
  CHECK(status_of(wall, {}) == Status::kDegenerate);
  Task task;
  CHECK(!find_orthoimage(wall.cloud(), wall.model, {}, kMostOrthoPixels, task));
  CHECK(!find_orthoimage(far.cloud(), far.model, {}, kMostOrthoPixels, task));
}
