// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/wall_claims.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace jalon::wall_claims_test {

namespace {

// Two facades 8 to 9 m apart that look east, each of two strips 1.5 m wide and 9 m high, seen from x = 30; one wall of
// points. The second facade stands on the wall and has all of its points, as after a loop.
struct TwoWalls {
  StripScene scene;
  JointPoints points;
  JointPlaces places;
  JointSettings settings;
  std::vector<PointMatch> matches;
  std::vector<double> weights;

  explicit TwoWalls(double first_x, double second_x, double second_turn = 0) {
    settings.sigma_block_x_m = settings.sigma_block_y_m = settings.sigma_strip_m = 0.01;
    settings.sigma_facade_m = 2;
    scene.blocks = 1, scene.facades = 2;
    facade(0, first_x, 0), facade(1, second_x, second_turn);
    places.trajectory = {{}, {}};
    places.model = {{{}}, {0, -second_x}, std::vector<double>(4, 0)};
  }
  // Matched to the strip of the second facade that is before it.
  void point(double y, double z) {
    const Vec3 at{0, y, z}, from{30, y, 3};
    points.at.push_back(at), points.origin.push_back(from);
    points.direction.push_back(normalized(at - from));
    points.normal.push_back({1, 0});
    points.places.push_back({0, 0});
    points.index.push_back(static_cast<uint32_t>(points.index.size()));
    matches.push_back({y < 1.5 ? 2u : 3u, MatchState::kMatched, 0});
    weights.push_back(1);
  }
  void wall(double from_m, double to_m) {
    for (double y = 0.25; y < 3; y += 0.5)
      for (double z = from_m; z < to_m; z += 0.25) point(y, z);
  }
  std::vector<FacadeClaim> claims(unsigned threads = 1) const {
    Task task(Task::Hooks{.threads = threads});
    return wall_claims({points, scene, places, matches, weights}, settings, task);
  }

 private:
  void facade(uint32_t number, double x, double turn) {
    const Vec2 n{std::cos(turn), std::sin(turn)};
    const Vec3 way{-n.v * 1.5, n.u * 1.5, 0}, up{0, 0, 9};
    for (int k = 0; k < 2; ++k) {
      const auto strip = static_cast<uint32_t>(scene.strips.size());
      const Vec3 p = Vec3{x, 0, 0} + way * k;
      scene.strips.push_back({0, number, n, n.u * p.x + n.v * p.y, 0});
      for (const Vec3& c : {p, p + way, p + way + up, p, p + way + up, p + up})
        scene.corners.push_back(c);
      scene.face_of.insert(scene.face_of.end(), {strip, strip});
      scene.strip_of_face.push_back(strip), scene.block_of_face.push_back(0);
    }
  }
};

}  // namespace

TEST_CASE("wall_claims__of_a_wall_between_two_parallel_facades__are_worth_more_for_the_nearer") {
  // 0.8 m before one facade, 8 m behind the other, which has come to stand there.
  TwoWalls walls(0.8, -8);
  walls.wall(0.5, 8.5);
  const std::vector<FacadeClaim> claims = walls.claims();
  REQUIRE(claims.size() == 2);
  CHECK(claims[0].facade == 1);
  CHECK(claims[0].offset_m == doctest::Approx(8));
  CHECK(claims[0].stands_there);
  CHECK(claims[1].facade == 0);
  CHECK(claims[1].offset_m == doctest::Approx(-0.8));
  CHECK(!claims[1].stands_there);
  // Both explain all of the points: the prior tells them apart.
  const double prior = (8 * 8 - 0.8 * 0.8) / 4 / 2;
  CHECK(claims[1].worth - claims[0].worth == doctest::Approx(prior));
  const FacadeExchange found = exchange_facades(claims, 2);
  REQUIRE(found.moves.size() == 2);
  CHECK(found.moves[0].facade == 1);
  CHECK(found.moves[0].offset_m == 0);
  CHECK(found.moves[1].facade == 0);
  CHECK(found.moves[1].offset_m == doctest::Approx(-0.8));
}

TEST_CASE("wall_claims__of_facades_that_are_as_likely__leave_both_doubtful") {
  TwoWalls walls(3.4, -4.6);
  walls.wall(0.5, 8.5);
  const FacadeExchange found = exchange_facades(walls.claims(), 2);
  CHECK(found.moves.empty());
  CHECK(found.doubtful == std::vector<uint32_t>{0, 1});
}

TEST_CASE("wall_claims__of_a_facade_that_would_be_off_by_more_than_three_sigmas__count_as_well") {
  // 6.4 m before one facade and 4.7 m behind the other: 13 times as likely.
  TwoWalls walls(6.4, -4.7);
  walls.wall(0.5, 8.5);
  const std::vector<FacadeClaim> claims = walls.claims();
  REQUIRE(claims.size() == 2);
  CHECK(claims[1].facade == 0);
  CHECK(claims[1].offset_m == doctest::Approx(-6.4));
  const FacadeExchange found = exchange_facades(claims, 2);
  CHECK(found.moves.empty());
  CHECK(found.doubtful == std::vector<uint32_t>{0, 1});
}

TEST_CASE("wall_claims__of_a_facade_that_is_turned_from_the_wall__are_worth_less") {
  // 3 degrees: 0.16 m over 3 m, of strips that are surer than that.
  TwoWalls straight(3.4, -4.6), turned(3.4, -4.6, 0.052);
  straight.wall(0.5, 8.5), turned.wall(0.5, 8.5);
  CHECK(turned.claims()[0].worth < straight.claims()[0].worth - 10);
  CHECK(turned.claims()[1].worth == doctest::Approx(straight.claims()[1].worth));
}

TEST_CASE("wall_claims__of_a_facade_that_beams_go_through__are_worth_less") {
  TwoWalls whole(3.4, -4.6), open(3.4, -4.6);
  whole.wall(0.5, 8.5), open.wall(0.5, 8.5);
  // Behind the upper half, on no strip.
  for (int k = 0; k < 10; ++k) {
    open.point(1, 8.6);
    const Vec3 from = open.points.origin.back(), way = open.points.direction.back();
    open.points.at.back() = from + way * (38 / -way.x);
    open.matches.back() = {};
    open.weights.back() = 0;
  }
  CHECK(open.claims()[0].worth == doctest::Approx(whole.claims()[0].worth - 5));
}

TEST_CASE("wall_claims__of_two_on_one_wall__do_not_both_count_a_point_whose_beam_ends_on_neither") {
  TwoWalls walls(0.8, -5.2);
  walls.wall(0.5, 8.5);
  walls.places.model.facades[0] = -0.8;
  // The lower third is the first one's by its beams, the next one nobody's.
  const auto all = static_cast<double>(walls.points.size());
  for (size_t i = 0; i < walls.points.size(); ++i)
    if (walls.points.at[i].z < 3) walls.matches[i].strip -= 2;
    else if (walls.points.at[i].z < 5) walls.matches[i] = {}, walls.weights[i] = 0;
  double own = 0;
  for (const FacadeClaim& claim : walls.claims()) {
    CHECK(claim.stands_there);
    if (claim.facade == claim.wall) own += claim.worth;
  }
  const double prior = (5.2 * 5.2 + 0.8 * 0.8) / 4 / 2;
  CHECK(own == doctest::Approx(all - prior));
}

TEST_CASE("wall_claims__beyond_the_sigma_or_with_few_points__are_not_made") {
  TwoWalls far(10.5, -2);
  far.wall(0.5, 8.5);
  CHECK(far.claims().size() == 1);
  TwoWalls few(0.8, -5.2);
  few.point(1, 1), few.point(1, 2);
  CHECK(few.claims().empty());
}

TEST_CASE("wall_claims__with_two_threads__gives_the_same_bits") {
  TwoWalls walls(0.8, -5.2, 0.01);
  walls.wall(0.5, 8.5);
  const std::vector<FacadeClaim> one = walls.claims(1), two = walls.claims(2);
  REQUIRE(one.size() == two.size());
  for (size_t i = 0; i < one.size(); ++i) CHECK(one[i].worth == two[i].worth);
}

TEST_CASE("is_facade_exchange_wanted__of_sure_facades__is_not") {
  JointSettings settings;
  settings.sigma_facade_m = 2;
  CHECK(is_facade_exchange_wanted(settings));
  settings.sigma_facade_m = 0.01;
  CHECK(!is_facade_exchange_wanted(settings));
}

}  // namespace jalon::wall_claims_test
