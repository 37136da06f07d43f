// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What a facade's view tells: a label a segment with its numbers, residuals on the range of the chart, outlines
// that are those of the model.
#include "report/pages/facade_view.h"

#include <doctest/doctest.h>

#include <cmath>

#include "report/elevation/opening_list.h"
#include "unit/modelling/walls.h"
#include "unit/report/named_facade.h"

using namespace walls;

namespace {

Segmentation two_walls() {
  WallScan wall, other;
  wall.azimuth = other.azimuth = 0;
  wall.width = 6;
  other.width = 4;
  other.shift = {0, 3, 0};
  return segmentation_of({wall.points(), other.points()});
}

ViewScene scene_of(const Segmentation& s, const Model& model) {
  Task task;
  return facade_scene(s, model, list_openings(model, kTypeTolerance_m), 0.01, task);
}

}  // namespace

TEST_CASE("facade_view__points_have_their_label_and_residual_and_each_label_a_text_and_a_colour") {
  const Segmentation s = two_walls();
  const ViewScene scene = scene_of(s, {});
  REQUIRE(scene.clouds.size() == 1);
  const auto& channels = scene.clouds[0].channels;
  REQUIRE(channels.size() >= 2);
  CHECK(channels[0].name == "segments");
  CHECK(channels[0].colours.size() == s.segments.size() + 1);
  CHECK(scene.labels.size() == s.segments.size() + 1);
  for (size_t k = 0; k < s.segments.size(); ++k) {
    CHECK(scene.labels[k + 1].starts_with("plane " + std::to_string(s.segments[k].label)));
    CHECK(scene.labels[k + 1].find("mm") != std::string::npos);
  }
  CHECK(channels[1].low == -0.01);
  CHECK(channels[1].high == 0.01);
  for (size_t i = 0; i < s.cloud->size(); i += 97) {
    CHECK(channels[0].value(i) == s.labels->number(i));
    const double residual = s.residuals->number(i);
    CHECK((channels[1].value(i) == residual || std::isnan(residual)));
  }
  CHECK(dot(scene.along, scene.towards) == doctest::Approx(0));
  // The eye stands where the facade's frame looks from.
  CHECK(scene.towards.y == doctest::Approx(-s.T_facade_world.m[5]));
}

TEST_CASE("facade_view__outlines_are_the_models_and_openings_tell_sizes_with_sigma") {
  named_facade::Setting setting;
  setting.corner_variance = 4e-6;
  const Model model = named_facade::make(setting);
  const ViewScene scene = scene_of(two_walls(), model);
  size_t faces = 0, windows = 0, arched = 0;
  for (const ViewPart& part : scene.parts) {
    faces += part.is_opening ? 0 : 1;
    REQUIRE(!part.rings.empty());
    if (!part.is_opening) continue;
    CHECK(part.text.find("width ") != std::string::npos);
    if (!part.tag.starts_with("W")) continue;
    ++windows;
    CHECK(part.text.find("\xCF\x83") != std::string::npos);
    arched += part.rings[0].size() > 8 ? 1 : 0;  // arcs as chords
    Box3 box;
    for (const Vec3& p : part.rings[0]) box.add(p);
    CHECK(box.max.x - box.min.x == doctest::Approx(setting.window_width).epsilon(0.02).scale(0));
  }
  CHECK(faces == model.faces.size());
  CHECK(windows > 5);
  CHECK(arched > 0);
  for (const Vec3& p : model.vertices)
    for (int k = 0; k < 3; ++k) CHECK((p[k] >= scene.focus.min[k] && p[k] <= scene.focus.max[k]));
}
