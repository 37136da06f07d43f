// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Round heads and their jambs.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "modelling/edges/adjust/arc_tangency.h"

using namespace jalon;

namespace {

constexpr double kJambSigma = 0.001, kArcSigma = 0.01;

/// A post 2 m wide whose round head was measured with this circle.
struct Head {
  EdgeShape before, after, arc;
  EdgeInformation information{};

  explicit Head(const Circle& circle) {
    const Vec2 right{2, 0}, right_top{2, 3}, left{0, 0}, left_top{0, 3};
    before = straight_shape(right, right_top);
    after = straight_shape(left_top, left);
    before.sigma_m = after.sigma_m = kJambSigma;
    before.source = after.source = EdgeSource::kDensity;
    arc.is_arc = true;
    arc.circle = circle;
    arc.turn = 1;
    arc.sigma_m = kArcSigma;
    arc.source = EdgeSource::kReveal;
    arc.set_ends({2, 3}, {0, 3});
    for (size_t k = 0; k < 3; ++k) information[4 * k] = 1 / (kArcSigma * kArcSigma);
  }
  void touch() { touch_jambs(information, 0.02, before, arc, after); }
};

}  // namespace

TEST_CASE("arc_tangency__jambs_touch_the_arc_which_is_half_a_circle_between_them") {
  Head head({{1.01, 3}, 0.98});
  head.touch();
  const Circle& c = head.arc.circle;
  CHECK(head.before.line.distance(c.centre) == doctest::Approx(c.radius).epsilon(1e-12));
  CHECK(head.after.line.distance(c.centre) == doctest::Approx(c.radius).epsilon(1e-12));
  CHECK(head.arc.length_m == doctest::Approx(std::numbers::pi * c.radius));
  CHECK(head.arc.first.v == doctest::Approx(c.centre.v));
  CHECK(norm(head.arc.first - c.centre) == doctest::Approx(c.radius));
  CHECK(head.before.line.direction == Vec2{0, 1});
  CHECK(head.before.sigma_m <= kJambSigma);
  CHECK(head.after.sigma_m <= kJambSigma);
}

TEST_CASE("arc_tangency__moves_arc_and_jambs_as_little_as_their_weights_ask") {
  Head head({{1.01, 3}, 0.98});
  const Circle measured = head.arc.circle;
  head.touch();
  const auto cost = [&](const Circle& c) {
    const Vec2 off = c.centre - measured.centre;
    const double grown = c.radius - measured.radius, right = 2 - c.centre.u - c.radius,
                 left = c.centre.u - c.radius;
    return (dot(off, off) + grown * grown) / (kArcSigma * kArcSigma) +
           (right * right + left * left) / (kJambSigma * kJambSigma);
  };
  const Circle& found = head.arc.circle;
  for (const double du : {-1e-4, 0.0, 1e-4})
    for (const double dv : {-1e-4, 0.0, 1e-4})
      for (const double dr : {-1e-4, 0.0, 1e-4})
        if (du != 0 || dv != 0 || dr != 0)
          CHECK(cost({found.centre + Vec2{du, dv}, found.radius + dr}) > cost(found));
}

TEST_CASE("arc_tangency__changes_nothing_where_the_arc_is_no_round_head_of_its_neighbours") {
  const auto is_unchanged = [](Head head) {
    const Circle circle = head.arc.circle;
    const Vec2 right = head.before.line.point, left = head.after.line.point;
    head.touch();
    return head.arc.circle.centre == circle.centre && head.arc.circle.radius == circle.radius &&
           head.before.line.point == right && head.after.line.point == left &&
           head.before.sigma_m == kJambSigma;
  };
  CHECK(!is_unchanged(Head({{1, 3}, 0.99})));
  CHECK(is_unchanged(Head({{1, 3}, 0.9})));  // a set-off head
  Head leaning({{1, 3}, 0.99});
  leaning.after = straight_shape({0, 3}, {0.3, 0});
  leaning.after.sigma_m = kJambSigma;
  CHECK(is_unchanged(leaning));
  Head straight({{1, 3}, 0.99});
  straight.arc.is_arc = false;
  CHECK(is_unchanged(straight));
  Head segmental({{1, 2}, 1.4});  // rises from the jambs at 45 degrees
  segmental.arc.sigma_m = 1;
  CHECK(is_unchanged(segmental));
}
