// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/rigid_motion.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"
#include "base/random.h"
#include "geometry/adjustment.h"

using namespace jalon;

namespace {

Vec3 random_vector(RandomStream& random) {
  return {random.normal(), random.normal(), random.normal()};
}

double largest_difference(const Transform& a, const Transform& b) {
  double out = 0;
  for (size_t i = 0; i < 12; ++i) out = std::max(out, std::fabs(a.m[i] - b.m[i]));
  return out;
}

}  // namespace

TEST_CASE("rotation_by__turns_anticlockwise_about_its_direction_and_is_rigid") {
  const Transform quarter = rotation_by({0, 0, std::numbers::pi / 2});
  CHECK(norm(quarter.point({1, 0, 5}) - Vec3{0, 1, 5}) < 1e-15);
  RandomStream random(1, 2);
  for (int i = 0; i < 300; ++i) {
    const double angle = std::pow(10, 12 * random.uniform() - 11);  // small ones by their series
    const Vec3 rotation = angle * normalized(random_vector(random));
    const Transform t = rotation_by(rotation);
    CHECK(largest_difference(t * rotation_by(-rotation), Transform{}) < 1e-14);
    CHECK(t.determinant() == doctest::Approx(1));
    CHECK(norm(t.point(rotation) - rotation) <= 1e-14 * (1 + angle));
    // Rodrigues' formula term by term.
    const Vec3 p = random_vector(random), k = normalized(rotation);
    const Vec3 expected =
        std::cos(angle) * p + std::sin(angle) * cross(k, p) + (1 - std::cos(angle)) * dot(k, p) * k;
    CHECK(norm(t.point(p) - expected) < 1e-13);
  }
}

TEST_CASE("rotation_vector__is_the_inverse_of_rotation_by_up_to_half_a_turn") {
  RandomStream random(2, 2);
  for (int i = 0; i < 300; ++i) {
    const double angle = i % 3 == 0 ? 1e-10 * random.uniform() : 3.1 * random.uniform();
    const Vec3 rotation = angle * normalized(random_vector(random));
    CHECK(norm(rotation_vector(rotation_by(rotation)) - rotation) < 1e-12);
  }
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0.6, -0.8, 0}}) {
    const Vec3 half = rotation_vector(rotation_by(std::numbers::pi * axis));
    CHECK(norm(half) == doctest::Approx(std::numbers::pi));
    CHECK(norm(cross(half, axis)) < 1e-7);  // either sense is the same turn
  }
  CHECK(norm(rotation_vector(Transform{})) == 0);
}

TEST_CASE("motion_about__centre_goes_where_the_shift_says") {
  const Vec3 centre{652000, 6861000, 40}, shift{0.5, -0.25, 1};
  const Transform t = motion_about(centre, {0.1, -0.3, 0.2}, shift);
  CHECK(norm(t.point(centre) - (centre + shift)) < 1e-8);
  CHECK(norm(rotation_vector(t) - Vec3{0.1, -0.3, 0.2}) < 1e-12);
}

TEST_CASE("motion_model__derivatives_are_those_of_its_own_move") {
  RandomStream random(3, 2);
  const MotionModel model(motion_about({1, 2, 3}, {0.3, 0.2, -0.4}, {1, 0, -2}), {1, 2, 3});
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 20; ++i) {
    const PlanePair pair{5 * random_vector(random), 5 * random_vector(random),
                         normalized(random_vector(random))};
    Coefficients<6> j{}, unused{};
    const double d = model.residual(pair, j);
    CHECK(d == doctest::Approx(dot(pair.normal, model.motion().point(pair.from) - pair.to)));
    for (size_t k = 0; k < 6; ++k) {
      Coefficients<6> step{};
      step[k] = kStep;
      MotionModel moved = model;
      moved.move(step);
      CHECK((moved.residual(pair, unused) - d) / kStep ==
            doctest::Approx(j[k]).epsilon(1e-4).scale(1));
    }
  }
}

TEST_CASE("motion_model__adjusts_to_the_motion_that_made_the_pairs") {
  RandomStream random(4, 2);
  const Transform truth = motion_about({0, 0, 0}, {0.05, -0.02, 0.1}, {0.3, 0.1, -0.2});
  std::vector<PlanePair> pairs;
  for (int i = 0; i < 60; ++i) {
    const Vec3 p = 3 * random_vector(random), n = normalized(random_vector(random));
    const Vec3 along = cross(n, random_vector(random));  // another point of the same plane
    pairs.push_back({p, truth.point(p) + along, n});
  }
  MotionModel model(Transform{}, {0, 0, 0});
  Adjusted<6> adjusted;
  Task task;
  REQUIRE(adjust<MotionModel>(pairs, {INFINITY, false}, task, model, adjusted));
  CHECK(largest_difference(model.motion(), truth) < 1e-9);
}

TEST_CASE("require_rigid__takes_rotations_and_tells_what_is_wrong_with_the_rest") {
  const auto told = [](const Transform& t) -> std::string {
    try {
      require_rigid(t, "pose 1");
    } catch (const Error& error) {
      CHECK(error.status() == Status::kInvalidArgument);
      return error.what();
    }
    return "";
  };
  const auto with = [](size_t i, double value) {
    Transform t;
    t.m[i] = value;
    return t;
  };
  CHECK(told(Transform()) == "");
  CHECK(told(with(0, 1 + 1e-7)) == "");
  CHECK(told(motion_about({1e6, -5, 3}, {0.3, -2, 1}, {7, 8, 9})) == "");
  const std::string lengths =
      "pose 1 is no rigid motion: the columns of its 3 x 3 part have the lengths ";
  Transform zeros;
  zeros.m.fill(0);
  CHECK(told(zeros).rfind(lengths + "0.000000, 0.000000 and 0.000000", 0) == 0);
  CHECK(told(with(0, 1.001)).rfind(lengths + "1.001000, 1.000000 and 1.000000", 0) == 0);
  CHECK(told(with(1, 0.01)).find("square to one another within 1e-6") != std::string::npos);
  CHECK(told(with(10, -1)) == "pose 1 is no rigid motion: it mirrors (determinant -1)");
  CHECK(told(with(0, NAN)).find("not finite") != std::string::npos);
  CHECK(told(with(3, INFINITY)).find("not finite") != std::string::npos);
}
