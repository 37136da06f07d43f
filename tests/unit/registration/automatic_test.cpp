// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/automatic.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "registration/coarse/coarse.h"
#include "registration/icp/icp.h"
#include "unit/registration/coarse_scenes.h"
#include "unit/registration/real_scans.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

TEST_CASE("automatic__lays_real_scans_onto_each_other_from_any_start") {
  const RealScans scans;
  if (!scans.exist()) return;
  const Cloud source = scans.source();
  const auto target = std::make_shared<const Cloud>(scans.target());
  const Transform truth = scans.pose();
  const AutomaticSettings as_published{{}, RealScans::as_published()};
  const uint64_t draws = std::getenv("JALON_FULL") ? 20 : 1;
  for (const bool any_axis : {false, true}) {
    double most_m = 0, most_deg = 0;
    for (uint64_t draw = 0; draw < draws; ++draw) {
      const Transform start = random_start(draw, any_axis);
      Task task;
      const auto moving = std::make_shared<const Cloud>(transformed(source, start, task));
      const Registration r = register_automatic(target, moving, {}, as_published, task);
      const Transform off = r.pose * start * inverse(truth);
      CHECK(r.converged);
      const double off_m = norm(off.point(r.centre) - r.centre),
                   off_deg = norm(rotation_vector(off)) / kDegree;
      most_m = std::max(most_m, off_m), most_deg = std::max(most_deg, off_deg);
    }
    const std::string about = any_axis ? "any axis" : "the vertical";
    MESSAGE("FIGURE coarse, then ICP on real scans, " << draws << " starts turned about " << about
                                                      << ": within " << 1000 * most_m << " mm, "
                                                      << most_deg << " deg");
    CHECK(most_m < 0.01);
    CHECK(most_deg < 0.05);
  }
}
