// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/side.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

FrontEvidence street() {
  FrontEvidence e;
  e.filling = {0.2, 12};
  e.hung = {3, 1};
  e.ground = {40, 0.5};
  e.reach = {300, 20};
  e.blocked = {0.1, 60};
  return e;
}

}  // namespace

TEST_CASE("front_cues__all_speak_for_the_street_and_change_sign_with_the_sides") {
  const FrontEvidence e = street();
  FrontEvidence turned;
  const auto swapped = [](const BothSides& s) { return BothSides{s.behind, s.before}; };
  turned.filling = swapped(e.filling);
  turned.hung = swapped(e.hung);
  turned.ground = swapped(e.ground);
  turned.reach = swapped(e.reach);
  turned.blocked = swapped(e.blocked);
  for (size_t i = 0; i < kFrontCues; ++i) {
    CHECK(front_cues(e)[i] > 0);
    CHECK(front_cues(turned)[i] == doctest::Approx(-front_cues(e)[i]));
  }
  CHECK(front_log_odds(turned) == doctest::Approx(-front_log_odds(e)));
  CHECK(probability_of(front_log_odds(e)) > 0.99);
}

TEST_CASE("front_log_odds__nothing_known_favours_no_side") {
  CHECK(front_log_odds({}) == 0);
  CHECK(probability_of(0) == 0.5);
  CHECK(probability_of(std::log(19.0)) == doctest::Approx(0.95));
}
