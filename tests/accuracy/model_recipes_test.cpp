// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Three facades of Boulaassal 2010, chapters 4 and 5, scanned, segmented and modelled with default
// parameters: openings, areas, vertices and arcs against the exact polygons of the scenes.
#include <doctest/doctest.h>

#include <map>
#include <numbers>

#include "modelling/facade/facade.h"
#include "recipe.h"
#include "wall_figures.h"

namespace jalon::model_recipes_test {

using namespace jalon::test;

namespace {

constexpr double kReach_spacings = 5;  // farthest vertex that can be meant

struct Tripod {
  double x, y, z, yaw_deg;  ///< yaw: of the scanner's +Y axis, clockwise from the scene's
};

std::vector<ScanStation> stations_of(const std::vector<Tripod>& tripods) {
  std::vector<ScanStation> out;
  for (const Tripod& t : tripods) {
    const double c = std::cos(t.yaw_deg * std::numbers::pi / 180),
                 s = std::sin(t.yaw_deg * std::numbers::pi / 180);
    ScanStation& station = out.emplace_back();
    station.name = "station " + std::to_string(out.size());
    station.pose.m = {c, s, 0, t.x, -s, c, 0, t.y, 0, 0, 1, t.z};
  }
  return out;
}

/// A scene of the recipe, its scan and the model of it.
struct Job {
  Model scene;
  CloudPtr cloud;
  Model model;

  Job(SceneName scene_name, const std::vector<Tripod>& tripods, const std::string& scanner_json,
      uint64_t seed) {
    Task task;
    scene = build_scene({.name = scene_name}, task);
    ParamSet scanner("scanner static", static_scanner_rows());
    scanner.from_json(scanner_json);
    auto settings = settings_from<StaticSettings>(scanner);
    settings.seed = seed;
    cloud = std::make_shared<const Cloud>(scan_static(scene, stations_of(tripods), settings, task));
    const Segmentation planes = segment_ransac(cloud, RansacSettings{}, task);
    model = model_facade(planes, FacadeSettings{}, task);
  }

  const std::string& part_class(const Face& face) const {
    return scene.parts[face.part].part_class;
  }

  /// Spacing of the points on all walls together: the side of the square that each has for itself.
  double spacing_m(const std::vector<Wall>& walls) const {
    const auto faces = cloud->fields.require("face").values<uint32_t>();
    std::map<uint32_t, double> points;
    for (const uint32_t id : faces) points[id] += 1;
    double area_m2 = 0, count = 0;
    for (const Wall& wall : walls)
      for (const Face& face : scene.faces)
        if (face.id == wall.face_id) area_m2 += face.area_m2, count += points[face.id];
    return std::sqrt(area_m2 / count);
  }
};

WallFigures figures(const Job& job, const std::vector<Wall>& walls, const Region& also_true,
                    double spacing_m) {
  WallFigures sum;
  for (const Wall& wall : walls)
    sum += compare_wall(modelled(job.model, wall), wall, also_true, kReach_spacings * spacing_m);
  return sum;
}

void expect_openings(const WallFigures& f) {
  CHECK(f.found_share() >= 0.95);
  CHECK(f.invented == 0);
}
void expect_areas(const WallFigures& f) {
  CHECK(f.completeness() >= 0.98);
  CHECK(f.correctness() >= 0.98);
}

/// Issue 4: "per axis RMS of vertices <= 0.3 x point spacing, bias <= 0.05 x spacing"; also away from the middle, so
/// that openings too large or too small show.
void expect_vertices(const AxisDeviations& deviations_m, double spacing_m) {
  for (size_t a = 0; a < kAxes; ++a) {
    CAPTURE(std::string(kAxisNames[a]));
    CHECK(deviations_m[a].rms() <= 0.3 * spacing_m);
    CHECK(std::fabs(deviations_m[a].bias()) <= 0.05 * spacing_m);
  }
}
void expect_arcs(const WallFigures& f, double spacing_m) {
  CHECK(f.arcs == f.heads);
  CHECK(f.centre_m.worst <= 0.5 * spacing_m);
  CHECK(f.radius_m.worst <= 0.5 * spacing_m);
}

uint64_t runs() { return is_full() ? 5 : 1; }

}  // namespace

TEST_CASE("DS3_arches__openings_areas_vertices_and_round_heads_are_true") {
  for (uint64_t seed = 1; seed <= runs(); ++seed) {
    const Job job(
        SceneName::kArches, {{2.5, -8, 1.7, 0}, {9, -8, 1.7, 0}},
        R"({"horizontal_step_rad": 0.002, "vertical_step_rad": 0.002, "range_noise_m": 0.003})",
        seed);
    const auto walls =
        true_walls(job.scene, [&](const Face& face) { return job.part_class(face) == "wall"; });
    REQUIRE(walls.size() == 2);
    const double spacing_m = job.spacing_m(walls);
    const WallFigures f = figures(job, walls, {}, spacing_m);
    MESSAGE("FIGURE DS3, seed " << seed << ": " << text_of(f, spacing_m));
    CHECK(f.openings == 8);
    expect_openings(f);
    expect_areas(f);
    CHECK(f.paired == f.corners);
    expect_vertices(f.vertices_m(), spacing_m);
    expect_arcs(f, spacing_m);
  }
}

TEST_CASE("DS2_lycee__openings_areas_vertices_and_round_heads_are_true") {
  for (uint64_t seed = 1; seed <= runs(); ++seed) {
    // The first tripod alone sees facade 1, past the two trees.
    const Job job(
        SceneName::kLycee,
        {{7, -16, 1.7, 0}, {19, -14, 1.7, 50}, {37, -18, 1.7, 0}, {62, -5, 1.7, -45}},
        R"({"horizontal_step_rad": 0.0015, "vertical_step_rad": 0.0015, "range_noise_m": 0.003,)"
        R"("horizontal_from_rad": -1.22, "horizontal_to_rad": 1.22})",
        seed);
    const auto walls =
        true_walls(job.scene, [&](const Face& face) { return job.part_class(face) == "wall"; });
    REQUIRE(walls.size() == 6);
    const double spacing_m = job.spacing_m(walls);
    const WallFigures f = figures(job, walls, {}, spacing_m);
    MESSAGE("FIGURE DS2, seed " << seed << ": " << job.cloud->size() << " points, "
                                << text_of(f, spacing_m));
    CHECK(f.openings == 8);
    expect_openings(f);
    expect_areas(f);
    CHECK(f.paired == f.corners);
    expect_vertices(f.vertices_m(), spacing_m);
    expect_arcs(f, spacing_m);
    // Windows 5, 7 and 8 stand behind the trees; 6 is the only one of their form that does not.
    std::string copies;
    for (const Part& part : job.model.parts)
      if (part.evidence == Evidence::kCopied && part.part_class == "window")
        copies += " " + part.name + " of " + job.model.parts[part.copied_from].name + ";";
    MESSAGE("FIGURE DS2, seed " << seed << ": copies" << copies);
  }
}

// What is an opening of DS1? The main plane is the lattice of posts and string courses; a draughtsman's openings in it
// are the bays that it frames on all four sides: 40. The bays of the ground floor stand on the ground and those of the
// attic end under the cornice: notches of the outline, which may be told as openings but need not be. So may the
// windows between the mullions, half a metre and more behind that plane.
TEST_CASE("DS1_insa__bays_areas_and_vertices_are_true") {
  for (uint64_t seed = 1; seed <= runs(); ++seed) {
    const Job job(
        SceneName::kInsaSurveyed,
        {{5, -30, 1.7, 0}, {25, -25, 1.7, 0}, {45, -40, 1.7, 0}, {63, -30, 1.7, 0}},
        R"({"instrument": "gx", "misfit_shift_m": 0.003, "max_points": 200000, "glass_return_min": 0.05,)"
        R"("glass_return_max": 0.3, "horizontal_step_rad": 0.0025, "vertical_step_rad": 0.0025})",
        seed);
    const auto walls = true_walls(job.scene, [&](const Face& face) {
      return face.area_m2 > 100 && std::fabs(face.plane.normal.y) > 0.99 &&
             (job.part_class(face) == "wall" || job.part_class(face) == "post");
    });
    REQUIRE(walls.size() == 2);
    Region notches;
    for (int bay = 0; bay < 10; ++bay) {
      const double x0 = 9 + 5.9 * bay + 0.4, x1 = bay < 9 ? 9 + 5.9 * (bay + 1) : 67.6;
      const WallAxes& axes = walls.back().axes;
      for (const auto& [low, high] : {std::pair{0.0, 3.85}, std::pair{21.0, 21.5}}) {
        const Vec2 a = axes.project({x0, 0, low}), b = axes.project({x1, 0, high});
        notches.push_back({{{a, {b.u, a.v}, b, {a.u, b.v}}}});
      }
    }
    for (const Face& face : job.scene.faces)
      if (job.part_class(face) == "glass")
        notches.push_back(
            drawn(job.scene, job.scene.rings[face.first_ring], true, walls.back().axes).region[0]);
    const double spacing_m = job.spacing_m(walls);
    const WallFigures f = figures(job, walls, notches, spacing_m);
    MESSAGE("FIGURE DS1, seed " << seed << ": " << job.cloud->size() << " points, "
                                << text_of(f, spacing_m));
    CHECK(f.openings == 40);
    expect_openings(f);
    expect_areas(f);
    // All corners of the lattice and of the closed wall beside it: a post's stub under the cornice is 0.4 x 0.5 m with
    // about five points along each side.
    CHECK(f.paired >= 0.99 * static_cast<double>(f.corners));
    expect_vertices(f.vertices_m(), spacing_m);
  }
}

}  // namespace jalon::model_recipes_test
