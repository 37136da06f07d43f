// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/targets.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "unit/registration/target_scenes.h"

namespace jalon {
namespace {

using namespace test;

const std::vector<Vec3> kSite = {{8, 2, 0}, {-6, 7, 1.5}, {-9, -8, 0.5}, {5, -7, 3}, {1, 10, 4}};

struct Refusal {
  Status status = Status::kOk;
  std::string text;
};
Refusal refusal(const TargetSides& sides, const char* json = "{}") {
  try {
    registered(sides, json);
  } catch (const Error& error) {
    return {error.status(), error.what()};
  }
  return {};
}
bool says(const Refusal& refusal, const char* words) {
  return refusal.text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("targets__give_any_motion_back") {
  for (uint64_t draw = 0; draw < 50; ++draw) {
    RandomStream random(11, draw);
    const bool similar = draw % 2 == 1;
    const Transform truth = any_motion(random, similar ? 0.2 + 3 * random.uniform() : 1);
    std::vector<Vec3> places;
    for (int i = 0; i < 5; ++i) places.push_back(within(20, random));
    TargetSides sides = exact_sides(places, truth);
    std::swap(sides.reference[0], sides.reference[3]);
    const Registration r = registered(sides, similar ? R"({"transform": "similarity"})" : "{}");
    for (size_t i = 0; i < 12; ++i) CHECK(std::abs(r.pose.m[i] - truth.m[i]) < 1e-11);
    CHECK(r.rms_m < 1e-11);
    CHECK(r.converged);
    CHECK(std::fabs(r.scale - std::cbrt(truth.determinant())) < 1e-12);
  }
}

TEST_CASE("targets__lose_nothing_on_a_national_grid") {
  for (const char* json : {"{}", R"({"transform": "similarity"})"}) {
    RandomStream random(12, 0);
    Transform truth = any_motion(random, std::string(json) == "{}" ? 1 : 1.00004);
    truth.m[3] = 652318.25, truth.m[7] = 6861742.5, truth.m[11] = 143.125;
    const TargetSides sides = exact_sides(kSite, truth);
    const Registration r = registered(sides, json);
    for (const Vec3& p : kSite)
      CHECK(norm(r.pose.point(p) - truth.point(p)) < 4e-9);  // an ulp of the northing: 0.9 nm
    // The same with a scan that is on a grid of its own.
    TargetSides both = sides;
    for (Target& target : both.moving) target.xyz += Vec3{1'300'000, 4'200'000, 100};
    const Registration s = registered(both, json);
    for (size_t i = 0; i < kSite.size(); ++i)
      CHECK(norm(s.pose.point(both.moving[i].xyz) - sides.reference[i].xyz) < 8e-9);
    for (size_t i = 0; i < 36; ++i)
      CHECK(s.covariance[i] == doctest::Approx(r.covariance[i]).scale(0).epsilon(1e-6));
  }
}

TEST_CASE("targets__turn_with_their_frames") {
  RandomStream random(13, 0);
  const Transform truth = any_motion(random), other = any_motion(random);
  Layout layout{"site", kSite, {}, {}};
  for (const Vec3& p : kSite) {
    layout.reference.push_back(isotropic(0.002));
    layout.moving.push_back(along_ray(p, 0.004, 0.001));
  }
  TargetSides sides = measured_sides(layout, truth, random);
  const Registration r = registered(sides);
  for (Target& target : sides.reference) target.xyz = other.point(target.xyz);
  const Registration turned = registered(sides);
  const Transform expected = other * r.pose;
  for (size_t i = 0; i < 12; ++i) CHECK(std::fabs(turned.pose.m[i] - expected.m[i]) < 1e-9);
  for (size_t i = 0; i < kSite.size(); ++i)
    CHECK(turned.residuals.require("p_value").number(i) ==
          doctest::Approx(r.residuals.require("p_value").number(i)).scale(0).epsilon(1e-6));
  // Backwards it is the inverse.
  const TargetSides back{sides.moving, sides.reference};
  const Transform there = registered(back).pose * turned.pose;
  for (size_t i = 0; i < 12; ++i) CHECK(std::fabs(there.m[i] - Transform{}.m[i]) < 1e-7);
}

TEST_CASE("targets__mirrored_are_refused_by_name_of_the_fault") {
  RandomStream random(14, 0);
  TargetSides sides = exact_sides(kSite, any_motion(random));
  for (Target& target : sides.moving) std::swap(target.xyz.x, target.xyz.y);
  const Refusal swapped = refusal(sides);
  CHECK(swapped.status == Status::kDegenerate);
  CHECK(says(swapped, "mirror"));
  // Targets in one plane have no handedness.
  std::vector<Vec3> flat = kSite;
  for (Vec3& p : flat) p.z = 0;
  sides = exact_sides(flat, any_motion(random));
  for (Target& target : sides.moving) target.xyz.x *= -1;
  CHECK(refusal(sides).status == Status::kOk);
}

TEST_CASE("targets__that_fix_no_pose_are_refused") {
  RandomStream random(15, 0);
  const Transform truth = any_motion(random);
  TargetSides sides = exact_sides(std::span(kSite).first(2), truth);
  CHECK(refusal(sides).status == Status::kInsufficientData);
  CHECK(says(refusal(sides), "2 targets"));

  std::vector<Vec3> line;
  for (int i = 0; i < 5; ++i) line.push_back(Vec3{2, 1, 0.3} * static_cast<double>(i));
  sides = exact_sides(line, truth);
  CHECK(refusal(sides).status == Status::kDegenerate);
  CHECK(says(refusal(sides), "one line"));
  // A few millimetres beside the line, measured to a few millimetres: still none.
  for (auto* side : {&sides.reference, &sides.moving})
    for (Target& target : *side) target.xyz += within(0.005, random);
  CHECK(refusal(sides).status == Status::kDegenerate);
  CHECK(says(refusal(sides), "as far as their covariances tell"));
  CHECK(refusal(sides, R"({"sigma_m": 0.00001})").status == Status::kOk);
}

TEST_CASE("targets__that_are_no_targets_are_refused") {
  RandomStream random(16, 0);
  const TargetSides sides = exact_sides(kSite, any_motion(random));
  TargetSides wrong = sides;
  wrong.moving[3].xyz.z = NAN;
  CHECK(refusal(wrong).status == Status::kInvalidArgument);
  CHECK(says(refusal(wrong), "\"T3\""));
  wrong = sides;
  wrong.reference[1].name = "T4";
  CHECK(says(refusal(wrong), "reference targets 1 and 4 are both named \"T4\""));
  wrong = sides;
  wrong.moving[1].xyz = wrong.moving[2].xyz + Vec3{5e-5, 0, 0};
  CHECK(says(refusal(wrong), "lie at one place"));
  wrong = sides;
  wrong.moving[1].covariance = {1e-6, 2e-6, 0, 2e-6, 1e-6, 0, 0, 0, 1e-6};
  CHECK(says(refusal(wrong), "negative variance"));
  wrong.moving[1].covariance = {1e-6, 2e-7, 0, 0, 1e-6, 0, 0, 0, 1e-6};
  CHECK(says(refusal(wrong), "not symmetric"));
}

}  // namespace jalon
