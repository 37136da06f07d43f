// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/false_discovery.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

TEST_CASE("discovery_limit__is_that_of_the_step_up_procedure_by_hand") {
  // 0.05 k / 8: 0.00625, 0.0125, 0.01875 ...: the second is the last below its bound.
  CHECK(discovery_limit({0.205, 0.001, 0.039, 0.008, 0.041, 0.06, 0.042, 0.074}, 0.05) == 0.008);
  // Step up: the fourth is within its bound, though the third is not within its own.
  CHECK(discovery_limit({0.01, 0.02, 0.04, 0.045}, 0.05) == 0.045);
  CHECK(discovery_limit({0.9, 0.5}, 0.05) < 0);
  CHECK(discovery_limit({}, 0.05) < 0);
}

TEST_CASE("discovery_limit__keeps_the_share_of_false_ones_below_the_rate") {
  double shares = 0;
  constexpr int kRuns = 50;
  for (uint64_t seed = 1; seed <= kRuns; ++seed) {
    RandomStream random(seed, 0);
    std::vector<double> p;
    for (int k = 0; k < 2000; ++k) p.push_back(normal_p_value(random.normal() + (k < 100 ? 5 : 0)));
    const double limit = discovery_limit(p, 0.1);
    double all = 0, wrong = 0;
    for (size_t k = 0; k < p.size(); ++k) {
      all += p[k] <= limit ? 1 : 0;
      wrong += p[k] <= limit && k >= 100 ? 1 : 0;
    }
    shares += all > 0 ? wrong / all : 0;
  }
  CHECK(shares / kRuns < 0.12);
  CHECK(shares / kRuns > 0.05);
}

TEST_CASE("deviate_of__undoes_the_p_value") {
  for (const double z : {0.1, 1.96, 4.0, 12.0})
    CHECK(deviate_of(normal_p_value(z)) == doctest::Approx(z));
  CHECK(std::isinf(deviate_of(0)));
  CHECK(std::isinf(deviate_of(-1)));
}
