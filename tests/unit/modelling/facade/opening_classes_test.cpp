// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Classes of openings drawn by hand: what is told of them, and what their class becomes.
#include "modelling/facade/opening_classes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

#include "model/part_classes.h"
#include "unit/modelling/street_house.h"

using namespace planned;

TEST_CASE("opening_classes__have_a_word_each_and_probabilities_that_sum_to_one") {
  std::set<std::string> words;
  for (size_t k = 0; k < kOpeningKinds; ++k) words.insert(class_of(static_cast<OpeningKind>(k)));
  CHECK(words ==
        std::set<std::string>(std::begin(part_class::kOpenings), std::end(part_class::kOpenings)));
  OpeningFeatures wild{};
  for (const double value : {0.0, 1.0, -1e6, 1e6}) {
    wild.fill(value);
    const auto p = class_probabilities(wild);
    CHECK(std::fabs(std::accumulate(p.begin(), p.end(), 0.0) - 1) < 1e-12);
    for (const double one : p) CHECK(one >= 0);
  }
}

TEST_CASE("opening_classes__tell_windows_a_door_and_a_shop_front") {
  PlannedScene scene = street_house();
  classify_openings({}, scene.plan);
  const auto& openings = scene.plan.facades[0].walls[0].wall.openings;
  for (size_t k = 0; k < 6; ++k) {
    CAPTURE(k);
    CHECK(openings[k].kind == OpeningKind::kWindow);
    CHECK(openings[k].kind_confidence > 0.95);
  }
  CHECK(openings[6].kind == OpeningKind::kDoor);
  const auto p = class_probabilities(opening_features(scene.plan, scene.plan.facades[0])[0][7]);
  CHECK(std::max_element(p.begin(), p.end()) - p.begin() ==
        static_cast<ptrdiff_t>(OpeningKind::kShopFront));
  for (const FacadeOpening& o : openings) CHECK(o.kind_confidence <= 1);
}

TEST_CASE("opening_classes__below_the_limit_are_openings_and_copies_follow_what_they_repeat") {
  PlannedScene scene = street_house();
  auto& openings = scene.plan.facades[0].walls[0].wall.openings;
  openings[6].copied_from = 0;
  classify_openings({}, scene.plan);
  CHECK(openings[6].kind == OpeningKind::kWindow);
  CHECK(openings[6].kind_confidence == openings[0].kind_confidence);
  const double confidence = openings[7].kind_confidence;
  classify_openings({1}, scene.plan);
  for (const FacadeOpening& o : openings) CHECK(o.kind == OpeningKind::kOpening);
  CHECK(openings[7].kind_confidence == confidence);  // of the likeliest still
}
