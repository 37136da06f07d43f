// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"
#include "geometry/rigid_motion.h"

using namespace jalon;

TEST_CASE("targets__give_any_motion_back") {
  for (uint64_t draw = 0; draw < 50; ++draw) {
    RandomStream random(11, draw);
    const auto within = [&](double reach) {
      const double x = reach * (2 * random.uniform() - 1), y = reach * (2 * random.uniform() - 1);
      return Vec3{x, y, reach * (2 * random.uniform() - 1)};
    };
    const Vec3 centre = within(1), turn = within(1.7), shift = within(50);
    const Transform truth = motion_about(centre, turn, shift);
    std::vector<Target> moving, reference;
    for (uint64_t i = 0; i < 5; ++i) {
      const std::string name(1, static_cast<char>('a' + i));
      moving.push_back({name, within(20)});
      reference.insert(reference.begin(), {name, truth.point(moving.back().xyz)});
    }
    Task task;
    const Registration r = register_targets(reference, moving, {"registrar targets", targets_rows()}, task);
    for (size_t i = 0; i < 12; ++i) CHECK(std::abs(r.pose.m[i] - truth.m[i]) < 1e-12);
    CHECK(r.rms_m < 1e-12);
    CHECK(r.converged);
  }
}
