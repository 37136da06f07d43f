// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>
#include <set>

#include "base/error.h"
#include "scan/truth.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

// The scenes after Boulaassal 2010 against their recipes.

namespace {

constexpr double kInsaTurn = 37 * std::numbers::pi / 180;

Truth truth_of(const Model& model) {
  Task task;
  return find_truth(model, 0.05, task);
}

/// The scene where its recipe draws it: without the turn and shift that it comes with.
Model straight_insa() {
  Task task;
  return build_scene(
      {.name = SceneName::kInsa, .rotation_rad = -kInsaTurn, .shift_m = {-1000, -500, -40}}, task);
}

Box3 box_of(const Model& model) {
  Box3 box;
  for (const auto& t : model.triangles)
    for (const uint32_t v : t) box.add(model.vertices[v]);
  return box;
}

std::vector<const Face*> faces_of_class(const Model& model, const std::string& part_class) {
  std::vector<const Face*> out;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == part_class) out.push_back(&face);
  return out;
}

size_t parts_of_class(const Model& model, const std::string& part_class) {
  return static_cast<size_t>(
      std::count_if(model.parts.begin(), model.parts.end(),
                    [&](const Part& p) { return p.part_class == part_class; }));
}

double area_of(const std::vector<const Face*>& faces) {
  double sum = 0;
  for (const Face* face : faces) sum += face->area_m2;
  return sum;
}

/// Depths y of the faces that look along -Y.
std::set<int> depths_mm(const std::vector<const Face*>& faces) {
  std::set<int> out;
  for (const Face* face : faces)
    if (face->plane.normal.y < -0.999)
      out.insert(static_cast<int>(std::lround(-1000 * face->plane.offset)));
  return out;
}

}  // namespace

TEST_CASE("scene_insa__is_the_68_m_of_posts_bands_and_windows_of_its_recipe") {
  const Model model = straight_insa();
  CHECK_NOTHROW(validate(model));
  const Box3 box = box_of(model);
  CHECK(box.min.x == doctest::Approx(0).epsilon(1e-9));
  CHECK(box.max.x == doctest::Approx(68));
  CHECK(box.max.z == doctest::Approx(22.3));  // a cornice of 0.3 m on 22 m
  CHECK(parts_of_class(model, "window") == 10 * 5 * 4);
  CHECK(parts_of_class(model, "car") == 2);
  CHECK(parts_of_class(model, "stair") == 1);
  CHECK(depths_mm(faces_of_class(model, "wall")) == std::set<int>{0});
  CHECK(depths_mm(faces_of_class(model, "post")) == std::set<int>{-500});
  CHECK(depths_mm(faces_of_class(model, "breast_wall")) == std::set<int>{100});
  CHECK(depths_mm(faces_of_class(model, "glass")) == std::set<int>{250});
  CHECK(depths_mm(faces_of_class(model, "mullion")) == std::set<int>{0});
  CHECK(depths_mm(faces_of_class(model, "cornice")) == std::set<int>{-1800});
  // The full wall of 8 x 22 m and ten pieces of 5.6 x 2 m above the windows, the last bay's 5.2 m wide.
  CHECK(area_of(faces_of_class(model, "wall")) == doctest::Approx(8 * 22 + (9 * 5.6 + 5.2) * 2));
  // Fifty breast walls 1 m high.
  CHECK(area_of(faces_of_class(model, "breast_wall")) == doctest::Approx(5 * (9 * 5.6 + 5.2)));
  // One lattice of eleven posts and five bands is one true plane.
  const Truth truth = truth_of(model);
  size_t lattices = 0;
  for (const TruePlane& p : truth.planes)
    if (p.plane.normal.y < -0.999 && std::abs(p.plane.offset - 0.5) < 1e-9) {
      ++lattices;
      CHECK(p.area_m2 == doctest::Approx(11 * 0.4 * 22 + 5 * 0.4 * (9 * 5.6 + 5.2)));
    }
  CHECK(lattices == 1);
  // Some windows are open, some have a curtain.
  const auto glass = faces_of_class(model, "glass").size(),
             curtains = faces_of_class(model, "curtain").size();
  CHECK(glass > 160);
  CHECK(glass < 195);
  CHECK(curtains > 20);
  CHECK(curtains < 60);
}

TEST_CASE("scene_insa__comes_turned_by_37_degrees_and_shifted") {
  const Model straight = straight_insa(), model = scene("insa");
  REQUIRE(straight.vertices.size() == model.vertices.size());
  const double c = std::cos(kInsaTurn), s = std::sin(kInsaTurn);
  for (size_t i = 0; i < model.vertices.size(); ++i) {
    const Vec3& p = straight.vertices[i];
    REQUIRE(norm(model.vertices[i] -
                 Vec3{1000 + c * p.x - s * p.y, 500 + s * p.x + c * p.y, 40 + p.z}) < 1e-10);
  }
  CHECK(scene("insa", {{"seed", 2}}).faces.size() != scene("insa", {{"seed", 1}}).faces.size());
}

TEST_CASE("scene_insa__lets_no_ray_behind_its_front_but_through_windows") {
  for (const char* name : {"insa", "insa_surveyed", "residence"}) {
    CAPTURE(name);
    const Model model = std::string(name) == "insa" ? straight_insa() : scene(name);
    double deepest = 0;
    for (const Face* face : faces_of_class(model, "glass"))
      deepest = std::max(deepest, -face->plane.offset);
    const Cloud cloud =
        scanned(model, quiet_settings(0.004, {.stations = 4, .station_distance_m = 15}));
    const auto ids = values<uint32_t>(cloud, "face");
    const auto faces = faces_by_id(model);
    for (size_t i = 0; i < cloud.size(); ++i)
      if (model.parts[faces.at(ids[i]).front()->part].part_class != "curtain")
        REQUIRE(cloud.point(i).y < deepest + 1e-6);
  }
}

TEST_CASE("scene_insa_surveyed__has_the_depths_and_the_mullions_of_the_survey") {
  const Model model = scene("insa_surveyed");
  const Box3 box = box_of(model);
  CHECK(box.max.x == doctest::Approx(68));
  CHECK(box.max.z == doctest::Approx(22));
  CHECK(depths_mm(faces_of_class(model, "wall")) == std::set<int>{200});
  CHECK(depths_mm(faces_of_class(model, "post")) == std::set<int>{0});
  CHECK(depths_mm(faces_of_class(model, "breast_wall")) == std::set<int>{600});
  CHECK(depths_mm(faces_of_class(model, "glass")) == std::set<int>{700});
  CHECK(depths_mm(faces_of_class(model, "mullion")) == std::set<int>{400});
  for (const Face* curtain : faces_of_class(model, "curtain")) {
    CHECK(-curtain->plane.offset >= 0.8);
    CHECK(-curtain->plane.offset <= 1.0);
  }
  for (const Face* face : faces_of_class(model, "mullion"))
    if (face->plane.normal.y < -0.999) CHECK(face->area_m2 == doctest::Approx(0.30 * 2.43));
  CHECK(faces_of_class(model, "wall").front()->area_m2 == doctest::Approx(9 * 21.5));
}

TEST_CASE("scene_insa_surveyed__scanned_as_its_recipe_says_is_as_thick_as_the_survey") {
  // Table 3.4 of the source: planes 6-9 mm thick, 7.5 on average, from several stations with their misfit.
  const Model model = scene("insa_surveyed");
  const ScanStation stations[] = {station_at({5, -25, 1.7}), station_at({25, -30, 1.7}),
                                  station_at({45, -35, 1.7}), station_at({63, -40, 1.7})};
  const StaticSettings params{.horizontal_step_rad = 0.0029,
                              .vertical_step_rad = 0.0029,
                              .instrument = StaticSettings::Instrument::kGx,
                              .misfit_shift_m = 0.004,
                              .surfaces = {.glass_return_min = 0.05, .glass_return_max = 0.3},
                              .max_points = 200000};
  const Cloud cloud = scanned(model, params, stations);
  REQUIRE(cloud.size() == 200000);
  const Truth truth = truth_of(model);
  std::vector<std::vector<Vec3>> points(truth.planes.size());
  const auto segments = values<uint32_t>(cloud, "segment");
  for (size_t i = 0; i < cloud.size(); ++i)
    if (segments[i] != kNoSegment) points[segments[i] - 1].push_back(cloud.point(i));
  double sum = 0, planes = 0, least = 1, most = 0, area = 0;
  for (size_t k = 0; k < points.size(); ++k) {
    if (points[k].size() >= 20) area += truth.planes[k].area_m2;
    if (points[k].size() < 300) continue;
    PlaneFit fit;
    REQUIRE(fit_plane(points[k], fit));
    sum += fit.sigma;
    planes += 1;
    least = std::min(least, fit.sigma);
    most = std::max(most, fit.sigma);
  }
  const double density = 200000 / area;
  MESSAGE("FIGURE " << planes << " planes of 300 points: " << 1000 * least << " ... " << 1000 * most
                    << " mm, mean " << 1000 * sum / planes << "; " << density << " points/m2");
  CHECK(planes >= 10);
  CHECK(sum / planes > 0.006);
  CHECK(sum / planes < 0.009);
  CHECK(density > 60);
  CHECK(density < 150);
}

TEST_CASE("scene_residence__adds_balconies_1_2_m_deep") {
  const Model plain = scene("insa_surveyed"), model = scene("residence");
  CHECK(parts_of_class(plain, "balcony") == 0);
  CHECK(parts_of_class(model, "balcony") == 5 * 4);
  CHECK(depths_mm(faces_of_class(model, "balcony")) == std::set<int>{-1200});
  CHECK(model.faces.size() == plain.faces.size() + 20 * 9);
}

TEST_CASE("scene_surrounds__has_glass_behind_the_joinery_on_request") {
  const Model plain = scene("surrounds"), glazed = scene("surrounds", {{"glass_m", 0.02}});
  CHECK(truth_of(plain).planes.size() == 1 + 12 + 12);
  CHECK(truth_of(glazed).planes.size() == 1 + 12 + 12 + 12);
  CHECK(depths_mm(faces_of_class(glazed, "surround")) == std::set<int>{-60});
  CHECK(depths_mm(faces_of_class(glazed, "joinery")) == std::set<int>{200});
  CHECK(depths_mm(faces_of_class(glazed, "glass")) == std::set<int>{220});
  CHECK(area_of(faces_of_class(plain, "wall")) == doctest::Approx(12 * 9 - 12 * 1.5 * 2.1));
}

TEST_CASE("scene_unwanted__puts_trees_cars_and_people_before_the_wall_and_ghosts_behind") {
  const Model model = scene("unwanted");
  CHECK_NOTHROW(validate(model));
  CHECK(parts_of_class(model, "tree") == 3);
  CHECK(parts_of_class(model, "car") == 2);
  CHECK(parts_of_class(model, "pedestrian") == 2);
  CHECK(parts_of_class(model, "ghost") == 12);
  for (const Face* ghost : faces_of_class(model, "ghost")) {
    CHECK(-ghost->plane.offset >= 0.8);
    CHECK(-ghost->plane.offset <= 6);
  }
  const Box3 box = box_of(model);
  CHECK(box.max.z == doctest::Approx(9));
  CHECK(box.min.y < -6.5);
}

TEST_CASE("scenes_of_planes__have_the_planes_of_their_recipes") {
  struct Case {
    const char* name;
    std::vector<double> areas;
  };
  const Case cases[] = {{"std", {24, 16, 9, 7, 5, 1, 8, 2, 10, 2.25}},
                        {"normal", {100}},
                        {"strips", {12, 12, 12, 12, 12, 12}},
                        {"patches", {9, 9}},
                        {"sills", {60, 0.3, 0.3}},
                        {"robbery", {60, 2.5}}};
  for (const Case& c : cases) {
    CAPTURE(c.name);
    const Model model = scene(c.name);
    CHECK_NOTHROW(validate(model));
    const Truth truth = truth_of(model);
    REQUIRE(truth.planes.size() == c.areas.size());
    for (size_t i = 0; i < c.areas.size(); ++i)
      CHECK(truth.planes[i].area_m2 == doctest::Approx(c.areas[i]));
  }
  const Truth patches = truth_of(scene("patches"));
  CHECK(patches.planes[0].plane.offset == patches.planes[1].plane.offset);
  CHECK(box_of(scene("patches")).max.x == 7);  // 1 m apart
}

TEST_CASE("scene_sills_and_robbery__stand_off_the_wall_or_cross_it") {
  const auto level = [](const Model& model) {
    Box3 box;
    for (const auto& t : model.triangles)
      if (std::abs(model.vertices[t[0]].z - model.vertices[t[1]].z) < 1e-9 &&
          std::abs(model.vertices[t[0]].z - model.vertices[t[2]].z) < 1e-9)
        for (const uint32_t v : t) box.add(model.vertices[v]);
    return box;
  };
  CHECK(level(scene("sills")).max.y == 0);
  CHECK(level(scene("sills")).min.y == doctest::Approx(-0.3));
  CHECK(level(scene("sills", {{"gap_m", 0.05}})).max.y == doctest::Approx(-0.05).scale(0));
  CHECK(level(scene("robbery", {{"depth_m", 0.5}})).min.y == doctest::Approx(-0.5));
  SceneSettings options{.name = SceneName::kRobbery, .depth_m = 0.5};
  options.crossing = true;
  Task task;
  const Box3 crossing = level(build_scene(options, task));
  CHECK(crossing.min.y == doctest::Approx(-0.25));
  CHECK(crossing.max.y == doctest::Approx(0.25));
}

TEST_CASE("scene_lycee__is_a_chain_of_six_facades_with_eight_arched_windows") {
  const Model model = scene("lycee");
  CHECK_NOTHROW(validate(model));
  CHECK(parts_of_class(model, "facade") == 6);
  CHECK(parts_of_class(model, "window") == 8);
  const auto walls = faces_of_class(model, "wall");
  REQUIRE(walls.size() == 6);
  std::vector<double> corners;
  for (size_t i = 0; i + 1 < 6; ++i) {
    const double turn = std::acos(dot(walls[i]->plane.normal, walls[i + 1]->plane.normal));
    corners.push_back(180 - turn * 180 / std::numbers::pi);
  }
  for (const double angle : corners)
    CHECK((std::abs(angle - 135) < 1e-6 || std::abs(angle - 90) < 1e-6));
  // Segment of a circle of chord 1.2 and rise 0.2, and half a disc.
  const double radius = (0.36 + 0.04) / 0.4, half = std::asin(0.6 / radius);
  const double segmental = 1.2 * 1.8 + radius * radius * (half - std::sin(half) * std::cos(half));
  const double round = 1.2 * 1.4 + std::numbers::pi * 0.36 / 2;
  CHECK(walls[0]->ring_count == 9);
  CHECK(walls[0]->area_m2 == doctest::Approx(14 * 15 - 4 * segmental - 4 * round).epsilon(1e-5));
  CHECK(depths_mm(faces_of_class(model, "joinery")) == std::set<int>{200, 250});
  for (const Face* sill : faces_of_class(model, "sill"))
    if (sill->plane.normal.y < -0.999) CHECK(sill->area_m2 == doctest::Approx(0.10 * 1.4).scale(0));
  CHECK(depths_mm(faces_of_class(model, "sill")) == std::set<int>{-120});
}

TEST_CASE("scene_lycee__trees_shade_windows_5_7_and_8_by_half_to_four_fifths") {
  const Model model = scene("lycee");
  Model bare = model;  // without the leaves
  const auto faces = faces_by_id(model);
  const Box3 front = [&] {
    Box3 box;
    box.add(Vec3{-1, -8, 0});
    box.add(Vec3{13, -1, 15});
    return box;
  }();
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> ids;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const bool leaf = !faces.contains(model.triangle_faces[t]) &&
                      front.contains(model.vertices[model.triangles[t][0]]);
    if (!leaf) triangles.push_back(model.triangles[t]), ids.push_back(model.triangle_faces[t]);
  }
  bare.triangles = triangles;
  bare.triangle_faces = ids;
  const ScanStation station = station_at({7, -16, 1.7});
  const Cloud shaded = scanned(model, quiet_settings(0.003), {&station, 1}),
              clear = scanned(bare, quiet_settings(0.003), {&station, 1});
  const auto seen = [](const Cloud& cloud, int window) {
    const double u = 3.5 * ((window - 1) % 4 + 0.5), v = window <= 4 ? 5 : 10;
    double n = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Vec3 p = cloud.point(i);
      n += p.y > -0.3 && p.y < 0.4 && std::abs(p.x - u) < 0.75 && p.z > v - 0.15 && p.z < v + 2.15;
    }
    return n;
  };
  for (int window = 1; window <= 8; ++window) {
    const double shadow = 1 - seen(shaded, window) / seen(clear, window);
    MESSAGE("FIGURE window " << window << ": " << 100 * shadow << " % in shadow");
    const bool behind_tree = window == 5 || window == 7 || window == 8;
    CHECK(shadow >= (behind_tree ? 0.5 : 0));
    CHECK(shadow <= (behind_tree ? 0.8 : 0.05));
  }
}

TEST_CASE("scene_arches__has_the_areas_of_its_ten_polygons") {
  const Model model = scene("arches");
  CHECK_NOTHROW(validate(model));
  const auto walls = faces_of_class(model, "wall");
  REQUIRE(walls.size() == 2);
  CHECK(signed_area(flat_ring(model, *walls[0], 0)) == doctest::Approx(96));
  CHECK(signed_area(flat_ring(model, *walls[1], 0)) == doctest::Approx(33.6));
  const auto panes = faces_of_class(model, "pane");
  REQUIRE(panes.size() == 8);
  size_t square = 0, arched = 0;
  for (const Face* pane : panes) {
    if (std::abs(pane->area_m2 - 2.56) < 1e-9) ++square;
    if (std::abs(pane->area_m2 - 2.4855) < 1e-3) ++arched;
  }
  CHECK(square == 5);
  CHECK(arched == 3);
}

TEST_CASE("scenes__take_a_shift_and_refuse_a_wrong_one") {
  SceneSettings options;
  options.shift_m = {652000, 6861000, 35};
  Task task;
  const Model here = scene("facade"), there = build_scene(options, task);
  for (size_t i = 0; i < here.vertices.size(); ++i)
    REQUIRE(norm(there.vertices[i] - here.vertices[i] - Vec3{652000, 6861000, 35}) < 2e-9);
  options.shift_m = {1, 2};
  CHECK_THROWS_AS(build_scene(options, task), Error);
}
