// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "modelling/evaluation/model_evaluation.h"
#include "scan/scene.h"

using namespace jalon;

namespace {

ModelEvaluation evaluated(const Model& a, const Model& r, const char* json = "{}",
                          unsigned threads = 1) {
  ParamSet params("model_evaluation", model_evaluation_rows());
  params.from_json(json);
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return evaluate_model(a, r, settings_from<ModelEvaluationSettings>(params), task);
}

double total(const ModelEvaluation& e, const char* name) {
  return model_totals_table(e).require(name).number(0);
}

Model scene(const char* json) {
  ParamSet params("scene", scene_rows());
  params.from_json(json);
  Task task;
  return build_scene(settings_from<SceneSettings>(params), task);
}

using Corners = std::vector<Vec3>;

// An upright rectangle on y = depth, seen from -Y; clockwise where it is an opening.
Corners upright(double left, double bottom, double right, double top, double depth,
                bool opening = false) {
  Corners out{
      {left, depth, bottom}, {right, depth, bottom}, {right, depth, top}, {left, depth, top}};
  if (opening) out = {out[0], out[3], out[2], out[1]};
  return out;
}

size_t add(Model& model, const char* part_class, const std::vector<Corners>& rings) {
  Part part;
  part.name = part.part_class = part_class;
  model.parts.push_back(part);
  Face face;
  face.part = static_cast<uint32_t>(model.parts.size() - 1);
  face.plane = {{0, -1, 0}, -rings[0][0].y};
  return model.add_face(face, rings);
}

// A wall of 8 x 6 m with a window of 1.2 x 1.6 m, its pane 0.2 m behind; the window's borders out by this much.
Model wall(double out_m, const Vec3& shift = {}) {
  Model model;
  const double l = 3 - out_m, b = 2 - out_m, r = 4.2 + out_m, t = 3.6 + out_m;
  add(model, "wall", {upright(0, 0, 8, 6, 0), upright(l, b, r, t, 0, true)});
  add(model, "window", {upright(l, b, r, t, 0.2)});
  for (Vec3& v : model.vertices) v += shift;
  return model;
}

}  // namespace

TEST_CASE("model_evaluation__of_a_model_against_itself_gives_1_1_0_0_0") {
  for (const char* json :
       {R"({"name":"facade"})", R"({"name":"arches"})", R"({"name":"lycee"})", R"({"name":"room"})",
        R"({"name":"facade","shift_m":[652000,6861000,120]})"}) {
    const Model model = scene(json);
    for (const char* options :
         {"{}", R"({"formulas":"thesis","mode":"relative"})", R"({"compare":"openings"})"}) {
      const ModelEvaluation e = evaluated(model, model, options);
      CAPTURE(json);
      CAPTURE(options);
      if (e.pairs.empty()) continue;  // a room has no openings
      CHECK(e.pairs.size() == e.reference.size());
      for (const FacePair& pair : e.pairs)
        CHECK(e.automatic[pair.automatic].face == e.reference[pair.reference].face);
      for (const char* one :
           {"total_completeness", "total_correctness", "total_quality", "mean_quality"})
        CHECK(total(e, one) == 1);
      for (const char* zero :
           {"total_branching", "total_miss", "total_failure", "mean_omission", "max_distance",
            "unmatched_automatic", "unmatched_reference", "mean_angle"})
        CHECK(total(e, zero) == 0);
      CHECK(total(e, "mean_contour_f1") == doctest::Approx(1).epsilon(1e-12));
      CHECK(total(e, "mean_hausdorff") < 1e-9);
    }
  }
}

TEST_CASE("model_evaluation__counts_areas_contours_and_vertices_of_a_window_2_cm_too_wide") {
  const ModelEvaluation e = evaluated(wall(0.02), wall(0));
  REQUIRE(e.pairs.size() == 2);
  const double window = 1.2 * 1.6, wider = 1.24 * 1.64;
  CHECK(e.pairs[0].areas.reference_m2 == doctest::Approx(48 - window).epsilon(1e-12));
  CHECK(e.pairs[0].areas.deficit_m2() == doctest::Approx(wider - window).epsilon(1e-9));
  CHECK(e.pairs[0].areas.excess_m2() == 0);
  CHECK(e.pairs[1].areas.excess_m2() == doctest::Approx(wider - window).epsilon(1e-9));
  CHECK(e.pairs[1].areas.deficit_m2() == 0);
  CHECK(e.pairs[1].same_class);
  CHECK(e.pairs[1].borders.automatic.mean_m ==
        doctest::Approx(0.02).epsilon(0.01).scale(0));  // corners are farther
  CHECK(e.pairs[1].borders.hausdorff_m == doctest::Approx(0.02 * std::sqrt(2.0)).epsilon(1e-9));
  CHECK(e.pairs[1].borders.reference.max_m == doctest::Approx(0.02).epsilon(1e-9).scale(0));
  CHECK(evaluated(wall(0.021), wall(0)).pairs[1].borders.f1 < 0.02);
  CHECK(evaluated(wall(0.019), wall(0)).pairs[1].borders.f1 > 0.98);
  // 4 corners of the wall, 4 of its opening, 4 of the pane; the latter off along and up, never out.
  CHECK(e.vertices.size() == 12);
  CHECK(total(e, "rms_along") == doctest::Approx(0.02 * std::sqrt(2.0 / 3)).epsilon(1e-9));
  CHECK(total(e, "rms_out") == 0);
  CHECK(total(e, "mean_dx") == doctest::Approx(0).epsilon(1e-12));
  CHECK(total(e, "rms_dx") == doctest::Approx(total(e, "rms_along")));
  CHECK(total(e, "rms_dz") == doctest::Approx(total(e, "rms_up")));
}

TEST_CASE("model_evaluation__gives_the_same_on_a_national_grid_and_with_any_threads") {
  const Vec3 far{652000, 6861000, 150};
  const ModelEvaluation e = evaluated(wall(0.02), wall(0)),
                        f = evaluated(wall(0.02, far), wall(0, far), "{}", 4);
  REQUIRE(e.pairs.size() == f.pairs.size());
  for (size_t i = 0; i < e.pairs.size(); ++i) {
    CHECK(e.pairs[i].areas.intersection_m2 ==
          doctest::Approx(f.pairs[i].areas.intersection_m2).epsilon(1e-4));
    CHECK(e.pairs[i].borders.hausdorff_m ==
          doctest::Approx(f.pairs[i].borders.hausdorff_m).epsilon(1e-6));
  }
  const ModelEvaluation again = evaluated(wall(0.02, far), wall(0, far), "{}", 1);
  for (size_t i = 0; i < f.pairs.size(); ++i) {
    CHECK(f.pairs[i].areas.intersection_m2 == again.pairs[i].areas.intersection_m2);
    CHECK(f.pairs[i].borders.automatic.rms_m == again.pairs[i].borders.automatic.rms_m);
  }
}

TEST_CASE("model_evaluation__relative_takes_a_common_shift_off") {
  const Vec3 shift{0.03, -0.02, 0.01};
  const ModelEvaluation absolute = evaluated(wall(0, shift), wall(0)),
                        relative = evaluated(wall(0, shift), wall(0), R"({"mode":"relative"})");
  CHECK(total(absolute, "mean_dx") == doctest::Approx(0.03));
  CHECK(total(absolute, "mean_out") == doctest::Approx(0.02));  // the face looks along -Y
  CHECK(total(absolute, "total_quality") < 1);
  CHECK(norm(absolute.shift) == 0);
  CHECK(norm(relative.shift + shift) < 1e-12);
  CHECK(total(relative, "rms_distance") < 1e-12);
  CHECK(total(relative, "total_quality") == 1);
}

TEST_CASE("model_evaluation__counts_missing_and_invented_faces_in_the_totals") {
  Model found = wall(0), truth = wall(0);
  add(found, "window", {upright(6, 2, 7, 3, 0.2)});
  add(truth, "door", {upright(1, 0, 2, 2.1, 0.2)});
  add(found, "no_data", {upright(0, 4, 2, 6, 0)});
  const ModelEvaluation e = evaluated(found, truth);
  CHECK(e.pairs.size() == 2);
  CHECK(total(e, "unmatched_automatic") == 1);
  CHECK(total(e, "unmatched_reference") == 1);
  CHECK(total(e, "total_completeness") == doctest::Approx(48 / 50.1).epsilon(1e-12));
  CHECK(total(e, "total_correctness") == doctest::Approx(48.0 / 49).epsilon(1e-12));
  CHECK(total(e, "mean_completeness") == 1);
  const ModelEvaluation doors = evaluated(found, truth, R"({"classes":"door, gate"})");
  CHECK(doors.pairs.empty());
  CHECK(doors.reference.size() == 1);
  CHECK(doors.automatic.empty());
}

TEST_CASE("model_evaluation__goes_by_plane_where_a_wall_is_cut_differently") {
  Model halves, truth;
  add(halves, "wall", {upright(0, 0, 5, 6, 0)});
  add(halves, "wall", {upright(5, 0, 8, 6, 0)});
  add(truth, "wall", {upright(0, 0, 8, 6, 0.01)});
  CHECK(total(evaluated(halves, truth), "total_completeness") == doctest::Approx(30.0 / 48));
  const ModelEvaluation planes = evaluated(halves, truth, R"({"group":"plane"})");
  CHECK(total(planes, "total_completeness") == doctest::Approx(1));
  CHECK(planes.automatic[0].merged == 2);
  CHECK(planes.pairs[0].distance_m == doctest::Approx(0.01));  // in front, where the normal points
  // A mesh of the same wall.
  Model mesh;
  mesh.vertices = upright(0, 0, 8, 6, 0);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_faces = {0, 1};
  CHECK(total(evaluated(mesh, truth), "total_quality") == doctest::Approx(1));
  CHECK(total(evaluated(mesh, halves), "total_quality") == doctest::Approx(1));
  CHECK(total(evaluated(halves, mesh), "total_quality") == doctest::Approx(1));
}

TEST_CASE("model_evaluation__knows_arcs") {
  // A door of 1.2 x 2.2 m with a semicircular head against the rectangle of the same size.
  Model round, square;
  add(round, "door", {{{0, 0, 0}, {1.2, 0, 0}, {1.2, 0, 1.6}, {0, 0, 1.6}}});
  round.sagittas = {0, 0, 0.6, 0};
  add(square, "door", {upright(0, 0, 1.2, 2.2, 0)});
  const double head = std::numbers::pi * 0.36 / 2;
  const ModelEvaluation e = evaluated(round, square);
  REQUIRE(e.pairs.size() == 1);
  CHECK(e.pairs[0].areas.automatic_m2 == doctest::Approx(1.2 * 1.6 + head).epsilon(1e-3));
  CHECK(e.pairs[0].areas.deficit_m2() == doctest::Approx(0.72 - head).epsilon(1e-2).scale(0));
  CHECK(e.pairs[0].areas.excess_m2() < 1e-4);
  CHECK(e.pairs[0].borders.hausdorff_m ==
        doctest::Approx(0.6 * std::sqrt(2.0) - 0.6).epsilon(1e-3));
  // As an opening, whose ring runs the other way round.
  Model wall_round;
  add(wall_round, "wall",
      {upright(-3, 0, 4, 5, 0), {{0, 0, 1}, {0, 0, 2.6}, {1.2, 0, 2.6}, {1.2, 0, 1}}});
  wall_round.sagittas = {0, 0, 0, 0, 0, -0.6, 0, 0};
  const ModelEvaluation o = evaluated(wall_round, wall_round, R"({"compare":"openings"})");
  REQUIRE(o.pairs.size() == 1);
  CHECK(o.pairs[0].areas.automatic_m2 == doctest::Approx(1.2 * 1.6 + head).epsilon(1e-3));
}

TEST_CASE("model_evaluation__pairs_corners_but_no_joints_of_chords") {
  // A wall with a corner too many on its upper border and a round corner drawn as chords.
  Model drawn, arc;
  Corners corners{{0, 0, 0}, {4, 0, 0}};
  for (int k = 0; k <= 12; ++k) {
    const double a = k * std::numbers::pi / 24;
    corners.push_back({3 + std::cos(a), 0, 2 + std::sin(a)});
  }
  corners.push_back({1, 0, 3});
  corners.push_back({0, 0, 3});
  add(drawn, "wall", {corners});
  add(arc, "wall", {{{0, 0, 0}, {4, 0, 0}, {4, 0, 2}, {3, 0, 3}, {0, 0, 3}}});
  arc.sagittas = {0, 0, 1 - std::sqrt(0.5), 0, 0};
  CHECK(evaluated(drawn, drawn).vertices.size() == 3);
  CHECK(evaluated(arc, arc).vertices.size() == 5);
  CHECK(evaluated(drawn, arc).vertices.size() == 3);
  CHECK(evaluated(drawn, drawn, R"({"corner_angle_rad":0})").vertices.size() == corners.size());
  CHECK(total(evaluated(drawn, arc), "total_quality") > 0.999);
}

TEST_CASE("model_evaluation__takes_empty_models_and_faces_without_area") {
  Model flat;
  add(flat, "wall", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
  add(flat, "wall", {{{0, 0, 0}, {1, 0, 0}}});
  const ModelEvaluation e = evaluated(flat, Model{});
  CHECK(e.pairs.empty());
  CHECK(e.automatic.empty());
  CHECK(std::isnan(total(e, "total_completeness")));
  CHECK(evaluated(wall(0), Model{}).unpaired.automatic_m2 == doctest::Approx(48));
}

TEST_CASE("model_evaluation__holds_deviations_against_the_vertices_covariances") {
  const double sx = 0.004, sy = 0.002, sz = 0.006;
  Model truth, found;
  RandomStream random(11, 1);
  for (int k = 0; k < 500; ++k) add(truth, "window", {upright(3 * k, 0, 3 * k + 2, 2, 0)});
  found = truth;
  for (Vec3& v : found.vertices)
    v += Vec3{sx * random.normal(), sy * random.normal(), sz * random.normal()};
  CHECK(std::isnan(total(evaluated(found, truth), "within_95")));
  found.vertex_covariances.assign(found.vertices.size(),
                                  {sx * sx, 0, 0, 0, sy * sy, 0, 0, 0, sz * sz});
  const ModelEvaluation e = evaluated(found, truth);
  CHECK(e.vertices.size() == 2000);
  MESSAGE("FIGURE vertices within their 95 % ellipsoid: ", total(e, "within_95"));
  CHECK(total(e, "within_95") > 0.935);
  CHECK(total(e, "within_95") < 0.965);
  CHECK(std::isnan(normalised_deviation({1, 0, 0}, {std::nan(""), 0, 0, 0, 0, 0, 0, 0, 0})));
  CHECK(normalised_deviation({0.02, 0, 0}, {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4}) ==
        doctest::Approx(2));
  // A flat ellipsoid: what lies in it is measured, what leaves it cannot be.
  CHECK(normalised_deviation({0.02, 0, 0}, {1e-4, 0, 0, 0, 0, 0, 0, 0, 1e-4}) ==
        doctest::Approx(2));
  CHECK(std::isinf(normalised_deviation({0.02, 0.001, 0}, {1e-4, 0, 0, 0, 0, 0, 0, 0, 1e-4})));
}
