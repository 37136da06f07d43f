// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What is said to be seen against scans of the same scenes, and against a screen whose shadow is known.
#include <doctest/doctest.h>

#include "scan/grammar/truth.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

namespace {

struct Surveyed {
  Model model;
  SceneSurvey survey;
  FacadeTruth truth;
  Cloud cloud;

  explicit Surveyed(const SceneSettings& settings) {
    Task task;
    model = build_scene(settings, task);
    survey = scene_survey(settings);
    truth = facade_truth(settings, {}, task);
    cloud = scan_static(model, survey.stations, survey.scanner, task);
  }
  Vec2 place(const TruthWall& wall, const Vec3& p) const {
    return {dot(p - wall.origin, wall.along), dot(p - wall.origin, wall.up)};
  }
};

Outline ring_of(const TruthContour& contour) {
  Contour out;
  for (const TruthCorner& c : contour) out.push_back({c.at, c.sagitta_m});
  return chords_of(out);
}

/// A wall of 4 x 3 m with one window, and a station 5 m before its middle.
struct Screened {
  FacadeTruth truth;
  SceneSurvey survey;
  Model model;
  explicit Screened(bool has_screen) {
    BareSketch s;
    s.at().outline = jalon::contour_of(Rect{0, 4, 0, 3});
    PlannedOpening o;
    o.shape = Shape::flat({1.5, 2.5, 1, 2});
    s.sketch.open(s.wall, o);
    truth = truth_of(s.plan, Transform{});
    survey.stations = {station_at({2, -5, 1.5})};
    SceneBuilder out{Transform{}};
    // Half-way: its shadow on the wall is twice as wide. It covers the left half of the window.
    if (has_screen)
      out.face(out.part("screen", "screen"), {{0, -2.5, 0}, {1, 0, 0}, {0, 0, 1}},
               {1.5, 2.0, 0, 3});
    else out.face(out.part("glass", "glass"), {{0, -2.5, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 4, 0, 3});
    model = out.take();
    Task task;
    look(model, survey, truth, task);
  }
};

}  // namespace

TEST_CASE("look__a_screen_hides_its_shadow_and_glass_hides_nothing") {
  const Screened clear(false), screened(true);
  CHECK(clear.truth.walls[0].seen_share == 1);
  CHECK(clear.truth.openings[0].area_seen_share == 1);
  CHECK(clear.truth.openings[0].outline_seen_share == 1);
  // Points of one station: 5 m x 0.0016 rad straight ahead.
  CHECK(clear.truth.openings[0].spacing_m == doctest::Approx(0.008).epsilon(0.03).scale(0));
  CHECK(clear.truth.openings[0].width_spacings == doctest::Approx(125).epsilon(0.03));
  CHECK(screened.truth.openings[0].area_seen_share == doctest::Approx(0.5).epsilon(0.1).scale(0));
  CHECK(screened.truth.openings[0].outline_seen_share ==
        doctest::Approx(0.5).epsilon(0.1).scale(0));
  // A strip of 1 x 3 m less the half of the window, of 12 - 1 m2.
  CHECK(screened.truth.walls[0].hidden_share == doctest::Approx(2.5 / 11).epsilon(0.1).scale(0));
  CHECK(screened.truth.walls[0].raster.at({1.75, 0.5}) == Sight::kHidden);
  CHECK(screened.truth.walls[0].raster.at({2.25, 0.5}) == Sight::kSeen);
  CHECK(screened.truth.walls[0].raster.at({2.25, 1.5}) == Sight::kOpening);
}

TEST_CASE("look__what_no_station_looks_at_is_never_seen") {
  Screened scene(false);
  scene.survey.scanner.horizontal_from_rad = 0;
  scene.survey.scanner.horizontal_to_rad = 1;
  Task task;
  scene.truth.walls[0].raster.cells.clear();
  look(scene.model, scene.survey, scene.truth, task);
  CHECK(scene.truth.walls[0].never_share == doctest::Approx(0.5).epsilon(0.05).scale(0));
  CHECK(scene.truth.openings[0].area_seen_share == doctest::Approx(0.5).epsilon(0.05).scale(0));
}

TEST_CASE("look__points_of_walls_lie_in_their_planes_and_not_in_openings") {
  for (const FacadeKind kind : all_kinds()) {
    CAPTURE(static_cast<int>(kind));
    const Surveyed s(grammar_scene(kind, 11, {.spacing_m = 0.06, .misfit_m = 0.001}));
    const auto faces = values<uint32_t>(s.cloud, "face");
    const auto segments = values<uint32_t>(s.cloud, "segment");
    const double sigma_m = std::hypot(s.survey.scanner.range_noise_m, 0.001);
    const std::vector<uint32_t> parts = parts_named(s.model, "wall");
    for (size_t w = 0; w < s.truth.walls.size(); ++w) {
      const TruthWall& wall = s.truth.walls[w];
      const std::set<uint32_t> ids = ids_of(s.model, "wall", parts[w]);
      std::vector<Outline> openings;
      for (const TruthOpening& o : s.truth.openings)
        if (o.wall == w) openings.push_back(ring_of(o.contour));
      const Outline outline = ring_of(wall.outline);
      size_t n = 0, off = 0;
      for (size_t i = 0; i < faces.size(); ++i) {
        if (!ids.contains(faces[i]) || segments[i] == 0) continue;  // no mixed pixels
        ++n;
        off += std::abs(dot(s.cloud.point(i) - wall.origin, wall.normal)) > 4 * sigma_m;
        const Vec2 place = s.place(wall, true_point(s.cloud, i));
        REQUIRE(contains(outline, place));
        for (const Outline& ring : openings) REQUIRE_FALSE(contains(ring, place));
      }
      CHECK(static_cast<double>(off) <= 1e-3 * static_cast<double>(n) + 1);
    }
  }
}

TEST_CASE("look__cells_that_are_seen_have_points_and_hidden_ones_have_none") {
  for (const FacadeKind kind : all_kinds()) {
    CAPTURE(static_cast<int>(kind));
    const Surveyed s(
        grammar_scene(kind, 12, {.spacing_m = 0.03, .misfit_m = 0, .occluders = BySeed::kYes}));
    const auto faces = values<uint32_t>(s.cloud, "face");
    const TruthWall& wall = s.truth.walls[0];
    const SightRaster& raster = wall.raster;
    const std::set<uint32_t> ids = ids_of(s.model, "wall", parts_named(s.model, "wall")[0]);
    std::vector<size_t> count(raster.cells.size(), 0);
    for (size_t i = 0; i < faces.size(); ++i)
      if (ids.contains(faces[i])) {
        const Vec2 d = s.place(wall, true_point(s.cloud, i)) - raster.low;
        const auto column = static_cast<size_t>(d.u / raster.cell_m),
                   row = static_cast<size_t>(d.v / raster.cell_m);
        if (column < raster.columns && row < raster.rows) ++count[row * raster.columns + column];
      }
    double seen = 0, seen_hit = 0, hidden = 0, hidden_points = 0, seen_points = 0;
    for (size_t c = 0; c < count.size(); ++c) {
      if (raster.cells[c] == Sight::kSeen) {
        seen += 1, seen_hit += count[c] > 0;
        seen_points += static_cast<double>(count[c]);
      }
      if (raster.cells[c] == Sight::kHidden) {
        hidden += 1;
        hidden_points += static_cast<double>(count[c]);
      }
    }
    // Cells at shadows' edges and behind leaves are judged by their middle; far up the points are farther apart.
    CHECK(seen_hit > 0.9 * seen);
    if (hidden > 100) CHECK(hidden_points / hidden < 0.5 * seen_points / seen);
  }
}
