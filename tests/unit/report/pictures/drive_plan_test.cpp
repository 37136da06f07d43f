// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/drive_plan.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace {

// A wall along the x axis of 10 m, in two strips, and a drive before it.
StripScene wall() {
  StripScene scene;
  scene.blocks = scene.facades = 1;
  for (uint32_t s = 0; s < 2; ++s) {
    scene.strips.push_back({0, 0, {0, -1}, -8});
    const double from = 5.0 * s, to = from + 5;
    scene.corners.insert(scene.corners.end(), {{from, 8, 0}, {to, 8, 0}, {to, 8, 3}});
    scene.face_of.push_back(s), scene.strip_of_face.push_back(s), scene.block_of_face.push_back(0);
  }
  return scene;
}

Trajectory drive() {
  Trajectory out;
  out.times_s = {0, 1, 2};
  out.positions = {{0, 0, 1}, {5, 0, 1}, {10, 0, 1}};
  return out;
}

JointAdjustment adjusted(const Vec2& by) {
  JointAdjustment out;
  out.trajectory.times_s = {0, 2};
  out.trajectory.by_m = {by, by};
  out.trajectory_sigmas = out.trajectory_priors = {{0.1, 0.1}, {0.1, 0.1}};
  out.strip_points = {20, 0};
  return out;
}

bool says(const std::string& svg, const char* text) { return svg.find(text) != std::string::npos; }

}  // namespace

TEST_CASE("drive_plan_factor__enlarges_to_the_paper_and_never_shrinks") {
  CHECK(drive_plan_factor(0.01, 1, 8) == 500);
  CHECK(drive_plan_factor(0.008, 1, 8) == doctest::Approx(1000));
  CHECK(drive_plan_factor(0.9, 1, 8) == 5);
  CHECK(drive_plan_factor(30, 1, 8) == 1);
  CHECK(drive_plan_factor(0, 1, 8) == 1);
  for (double greatest = 1e-4; greatest < 4; greatest *= 1.3)
    CHECK(drive_plan_factor(greatest, 1, 8) * greatest <= 8 * (1 + 1e-12));
}

TEST_CASE("drive_plan__says_by_how_much_corrections_are_enlarged") {
  const Trajectory given = drive();
  const std::string svg = drive_plan(wall(), adjusted({0.02, 0}), given, nullptr);
  CHECK(says(svg, "adjusted x 20"));
  CHECK_FALSE(says(svg, ">true"));
}

TEST_CASE("drive_plan__of_no_correction_enlarges_nothing") {
  CHECK(says(drive_plan(wall(), adjusted({}), drive(), nullptr), "adjusted, 95 %"));
}

TEST_CASE("drive_plan__draws_the_truth_as_far_as_it_reaches") {
  Trajectory truth = drive();
  truth.times_s = {0.5, 1, 1.5};
  const std::string svg = drive_plan(wall(), adjusted({0.02, 0}), drive(), &truth);
  CHECK(says(svg, "true x "));
}

TEST_CASE("drive_plan__tells_walls_that_points_hold_from_the_others") {
  const std::string svg = drive_plan(wall(), adjusted({0.02, 0}), drive(), nullptr);
  CHECK(says(svg, "stroke=\"#b5b5b5\" stroke-width=\"0.3\""));
  CHECK(says(svg, "stroke=\"#1a1a1a\" stroke-width=\"0.5\""));
}
