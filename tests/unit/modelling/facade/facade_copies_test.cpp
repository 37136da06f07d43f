// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/edit.h"
#include "unit/modelling/facade_scenes.h"
#include "unit/modelling/model_checks.h"
#include "unit/modelling/walls.h"

using namespace facades;

namespace {

// Coordinates that a shift by whole metres leaves exact.
Vec3 grid_point(double x, double y, double z) {
  return {walls::snapped(x), walls::snapped(y), walls::snapped(z)};
}

// In the plane y = -3.5, between the eye and the fourth window of the upper row.
constexpr walls::Rectangle kScreen{8.13, 3.46, 9.11, 4.74};

// A wall of 14 x 7 m with two rows of five windows, panes 20 cm behind, as one eye sees them past a screen that hides
// one window whole.
Segmentation seen_past_a_screen(const Vec3& shift, const walls::Rectangle& screen = kScreen) {
  const Vec3 eye{7, -9, 3};
  std::vector<walls::Rectangle> windows;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 2; ++j)
      windows.push_back({1 + 2.7 * i, 1 + 3.0 * j, 2.1 + 2.7 * i, 2.6 + 3.0 * j});
  const auto sees = [&](const Vec3& p) {
    const Vec3 q = eye + (p - eye) * ((-3.5 - eye.y) / (p.y - eye.y));
    return !screen.contains(q.x, q.z);
  };
  const auto window_at = [&](double x, double z) {
    return std::any_of(windows.begin(), windows.end(),
                       [&](const auto& w) { return w.contains(x, z); });
  };
  std::vector<Vec3> wall, pane, front;
  RandomStream random(5, 1);
  const double step = 0.025;
  for (double x = 0.01; x < 14; x += step)
    for (double z = 0.01; z < 7; z += step) {
      const Vec3 p = grid_point(x, 0.002 * random.normal(), z), q = grid_point(x, 0.2, z);
      const Vec3 crossing = eye + (q - eye) * (-eye.y / (q.y - eye.y));
      if (!window_at(x, z) && sees(p)) wall.push_back(p + shift);
      if (window_at(x, z) && window_at(crossing.x, crossing.z) && sees(q))
        pane.push_back(q + shift);
      if (screen.contains(x, z)) front.push_back(grid_point(x, -3.5, z) + shift);
    }
  Segmentation out = walls::segmentation_of({wall, pane, front});
  Cloud cloud = *out.cloud;
  Station station;
  station.has_pose = true;
  for (int k = 0; k < 3; ++k) station.pose.m[static_cast<size_t>(4 * k + 3)] = (eye + shift)[k];
  station.count = cloud.size();
  cloud.stations = {station};
  out.cloud = std::make_shared<const Cloud>(cloud);
  return out;
}

void check_sound(const Model& model) {
  for (const Face& face : model.faces) CHECK(checks::ring_fault(model, face) == "");
  for (const Solid& solid : model.solids) CHECK(checks::solid_fault(model, solid) == "");
}

}  // namespace

TEST_CASE(
    "facade: a hidden window of a regular grid is completed and marked, and its veto closes the "
    "wall") {
  const Segmentation segmentation = seen_past_a_screen({});
  for (const char* options : {"{}", "{\"solids\": true}"}) {
    const Model model = facade_of(segmentation, options);
    const auto windows = parts_of(model, "window");
    REQUIRE(windows.size() == 10);
    size_t copies = 0, copy = 0;
    for (const size_t w : windows)
      if (model.parts[w].evidence == Evidence::kCopied) ++copies, copy = w;
    REQUIRE(copies == 1);
    REQUIRE(model.parts[copy].copied_from < model.parts.size());
    CHECK(model.parts[model.parts[copy].copied_from].part_class == "window");
    // The window hidden is the fourth of the upper row.
    CHECK(model.parts[copy].name == "window 2.4");
    const Box3 box = box_of_part(model, child_of(model, copy, "joinery"));
    CHECK(std::fabs(box.min.x - 9.1) < 0.02);
    CHECK(std::fabs(box.max.z - 5.6) < 0.02);
    check_sound(model);
    const Model less = without_copy(model, copy);
    validate(less);
    check_sound(less);
    CHECK(parts_of(less, "window").size() == 9);
    double before = 0, after = 0;
    for (const Face& face : model.faces)
      before += model.parts[face.part].part_class == "wall" ? face.area_m2 : 0;
    for (const Face& face : less.faces)
      after += less.parts[face.part].part_class == "wall" ? face.area_m2 : 0;
    const double window_m2 = (box.max.x - box.min.x) * (box.max.z - box.min.z);
    CHECK(std::fabs(after - before - window_m2 * (model.solids.empty() ? 1 : 2)) < 1e-6);
  }
  CHECK(parts_of(facade_of(segmentation, "{\"patterns\": false}"), "window").size() == 9);
}

TEST_CASE("facade_copies__leave_without_data_what_else_was_hidden") {
  // Hides the wall 1.1 m below the window too.
  walls::Rectangle screen = kScreen;
  screen.bottom = 2.8;
  const Model model = facade_of(seen_past_a_screen({}, screen));
  const auto windows = parts_of(model, "window");
  CHECK(windows.size() == 10);
  CHECK(std::any_of(windows.begin(), windows.end(),
                    [&](size_t w) { return model.parts[w].evidence == Evidence::kCopied; }));
  const auto unmeasured = parts_of(model, "no_data");
  REQUIRE(!unmeasured.empty());
  Box3 box;
  for (const size_t part : unmeasured) box += box_of_part(model, part);
  CHECK(box.min.z == doctest::Approx(2.67).epsilon(0.03));
  check_sound(model);
}

TEST_CASE("facade: a national grid moves the model and changes nothing else") {
  const Vec3 shift{652000, 6861000, 128};
  const Model here = facade_of(seen_past_a_screen({})),
              there = facade_of(seen_past_a_screen(shift));
  REQUIRE(here.vertices.size() == there.vertices.size());
  REQUIRE(here.parts.size() == there.parts.size());
  double worst = 0, bent = 0;
  for (size_t i = 0; i < here.vertices.size(); ++i)
    worst = std::max(worst, norm(there.vertices[i] - shift - here.vertices[i]));
  for (const Face& face : there.faces) bent = std::max(bent, checks::flatness(there, face));
  MESSAGE("FIGURE facade on a national grid: vertices within "
          << 1e9 * worst << " nm, faces plane within " << 1e9 * bent << " nm");
  CHECK(worst < 2e-9);  // rounding of the vertices themselves ...
  CHECK(bent < 1e-9);   // ... and of those of one face
}
