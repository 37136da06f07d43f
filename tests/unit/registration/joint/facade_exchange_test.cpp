// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/facade_exchange.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace jalon::facade_exchange_test {

namespace {

double place_of(const FacadeExchange& found, uint32_t facade) {
  for (const FacadeExchange::Move& move : found.moves)
    if (move.facade == facade) return move.offset_m;
  return -99;
}

}  // namespace

TEST_CASE("exchange_facades__with_a_rival_that_explains_a_wall_better__makes_room_for_it") {
  const std::vector<FacadeClaim> claims{{1, 1, 3.6, true, 20}, {0, 1, -0.8, false, 70}};
  const FacadeExchange found = exchange_facades(claims, 2);
  CHECK(found.moves.size() == 2);
  CHECK(place_of(found, 0) == -0.8);
  CHECK(place_of(found, 1) == 0);
  CHECK(found.doubtful.empty());
}

TEST_CASE("exchange_facades__without_a_clear_margin__doubts_both_and_moves_none") {
  for (const double worth : {68.5, 71.5}) {
    const std::vector<FacadeClaim> claims{{1, 1, 3.6, true, 70}, {0, 1, -0.8, false, worth}};
    const FacadeExchange found = exchange_facades(claims, 2);
    CHECK(found.moves.empty());
    CHECK(found.doubtful == std::vector<uint32_t>{0, 1});
  }
  const FacadeExchange clear =
      exchange_facades(std::vector<FacadeClaim>{{1, 1, 0.1, true, 70}, {0, 1, 5, false, 60}}, 2);
  CHECK(clear.moves.empty());
  CHECK(clear.doubtful.empty());
}

TEST_CASE("exchange_facades__with_a_rival_farther_off_than_the_sigmas_allow__doubts_both") {
  const std::vector<FacadeClaim> claims{{1, 1, 1.5, true, 50}, {0, 1, -7.6, false, 62, false}};
  const FacadeExchange found = exchange_facades(claims, 2);
  CHECK(found.moves.empty());
  CHECK(found.doubtful == std::vector<uint32_t>{0, 1});
}

TEST_CASE("exchange_facades__with_one_that_its_wall_speaks_against__doubts_it_and_moves_nobody") {
  // 1 has come to stand before 0, on the wall of both.
  const std::vector<FacadeClaim> claims{{0, 0, -0.5, true, 89},
                                        {1, 0, 3.6, true, 90},
                                        {1, 1, 3.6, true, -29},
                                        {0, 1, -0.5, true, -6}};
  const FacadeExchange found = exchange_facades(claims, 2);
  CHECK(found.moves.empty());
  CHECK(found.doubtful == std::vector<uint32_t>{0, 1});
}

TEST_CASE("exchange_facades__that_each_stand_on_the_next_ones_wall__all_move_on") {
  // 2 is on the wall of 1 and 1 on that of 0, which is on none.
  const std::vector<FacadeClaim> claims{
      {1, 1, 4, true, 40}, {0, 1, 0.2, false, 50}, {2, 2, 4, true, 40}, {1, 2, 0.1, false, 50}};
  const FacadeExchange found = exchange_facades(claims, 3);
  CHECK(place_of(found, 0) == 0.2);
  CHECK(place_of(found, 1) == 0.1);
  CHECK(place_of(found, 2) == 0);
}

TEST_CASE("exchange_facades__with_two_on_one_wall__gives_it_to_the_one_that_explains_all_of_it") {
  // Either may have the other's points; swapping halves is no answer.
  const std::vector<FacadeClaim> claims{
      {0, 0, 0.3, true, 60}, {1, 0, 5, true, 92}, {1, 1, 5, true, 30}, {0, 1, 0.3, true, 98}};
  const FacadeExchange found = exchange_facades(claims, 2);
  CHECK(place_of(found, 0) == 0.3);
  CHECK(place_of(found, 1) == 0);
}

}  // namespace jalon::facade_exchange_test
