// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_confidence.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("confidence_by_points__grows_with_the_changed_points_alone") {
  std::vector<Vec3> points;
  for (int k = 0; k < 1000; ++k) points.push_back({0.01 * k, 0, 0});
  const Comparison made = told(points, std::vector<double>(1000, 0.1));
  Epoch before{&made, {}, {}}, after{&made, {}, {}};
  before.regions.labels.assign(1000, 0);
  after.regions.labels.assign(1000, 1);
  after.regions.labels[0] = 0;
  const auto of = [&](size_t n) {
    Change change;
    for (size_t k = 0; k < n; ++k) change.object.after.push_back(static_cast<uint32_t>(k));
    change.object.before = change.object.after;  // unchanged there
    return confidence_by_points(change, before, after);
  };
  CHECK(of(0) == 0);
  CHECK(of(1) == 0);
  CHECK(of(65) == doctest::Approx(0.5));
  CHECK(of(400) > 0.85);
  CHECK(of(1000) < 1);
}
