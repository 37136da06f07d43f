// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/ortho_files.h"

#include <doctest/doctest.h>

#include <sstream>

#include "unit/formats/fixtures.h"
#include "unit/report/pictures/ortho_scene.h"

using namespace jalon;
using namespace jalon::test;
using namespace ortho_scene;

namespace {

Orthoimage coloured() {
  const Scene wall = scene(0);
  Task task;
  return make_orthoimage(wall.cloud(), wall.model, {}, kMostOrthoPixels, task);
}

}  // namespace

TEST_CASE("ortho_files__the_world_file_tells_the_middle_of_the_first_pixel") {
  const Orthoimage image = coloured();
  std::istringstream lines(orthoimage_world(image));
  std::vector<double> values;
  for (double value = 0; lines >> value;) values.push_back(value);
  CHECK(values == std::vector<double>{image.pixel_m, 0, 0, -image.pixel_m,
                                      image.left_m + image.pixel_m / 2,
                                      image.top_m - image.pixel_m / 2});
}

TEST_CASE("ortho_files__the_extension_tells_the_files") {
  const Scene wall = scene(0);
  const Folder folder;
  Task task;
  const auto write = [&](const char* name) {
    write_orthoimage(wall.cloud(), wall.model, {}, folder.file(name), task);
  };
  write("a.png");
  CHECK(slurp(folder.file("a.png")).starts_with("\x89PNG"));
  CHECK(!slurp(folder.file("a.pgw")).empty());
  write("b.TIFF");
  CHECK(slurp(folder.file("b.TIFF")).starts_with("II*"));
  CHECK(folder.entries() == 3);
  CHECK(failure_of([&] { write("c.jpg"); }).status == Status::kUnsupported);
  CHECK(failure_of([&] { write("no/c.png"); }).status == Status::kIo);
  CHECK(failure_of([&] {
          write_orthoimage(wall.cloud(), {}, {}, folder.file("d.png"), task);
        }).status == Status::kDegenerate);
  CHECK(folder.entries() == 3);
}

TEST_CASE("ortho_files__numbers_go_into_a_tiff_as_they_are_and_holes_as_no_data") {
  const Scene wall = scene(0);
  Task task;
  OrthoimageSettings settings;
  settings.content = OrthoContent::kDistance;
  const Orthoimage image =
      make_orthoimage(wall.cloud(), wall.model, settings, kMostOrthoPixels, task);
  const std::string tiff = orthoimage_tiff(image, task);
  CHECK(tiff.find(std::string("-9999", 6)) != std::string::npos);
  CHECK(orthoimage_tiff(coloured(), task).find(std::string("-9999", 6)) == std::string::npos);
}

TEST_CASE("ortho_files__the_figure_has_axes_scale_and_the_size_of_a_pixel") {
  Task task;
  const std::string svg = orthoimage_svg(coloured(), "Orthoimage <1>", task);
  for (const char* wanted :
       {"Orthoimage &lt;1&gt;", "Height Z (m)", "Distance along the facade (m)", "pixel 3",
        "Colour of the points", "data:image/png;base64,"})
    CHECK(svg.find(wanted) != std::string::npos);
}
