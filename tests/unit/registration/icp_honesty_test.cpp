// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Does the covariance of ICP tell the truth? Each scene is sampled anew, twice, again and again.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "base/distributions.h"
#include "geometry/rigid_motion.h"
#include "registration/icp.h"
#include "registration_scenes.h"

using namespace jalon;

namespace {

struct Tally {
  size_t covered = 0, named = 0, converged = 0;
  double squares = 0, ranks = 0;  ///< of the errors over their standard deviations
};

// Is the true pose in the 95 % ellipsoid of the directions that are observable?
void judge(const Registration& r, const Transform& truth, const scenes::Scene& scene, Tally& tally) {
  const Transform error = r.pose * inverse(truth);
  const Vec3 turn = rotation_vector(error), shift = error.point(r.centre) - r.centre;
  const double off[6] = {turn.x, turn.y, turn.z, shift.x, shift.y, shift.z};
  double squares = 0, rank = 0;
  for (size_t k = 0; k < 6; ++k) {
    if (r.directions.require("observable").number(k) == 0) continue;
    double along = 0;
    for (uint32_t i = 0; i < 6; ++i)
      along += r.directions.require("direction").number(k, i) * off[i] * (i < 3 ? r.extent_m * r.extent_m : 1);
    const double z = along / r.directions.require("sigma").number(k);
    squares += z * z;
    ++rank;
  }
  tally.squares += squares;
  tally.ranks += rank;
  tally.covered += rank > 0 && squares <= chi_square_quantile(rank, 0.95);
  tally.named += r.unobservable == scene.open_directions;
  tally.converged += r.converged;
}

Tally registered(const scenes::Scene& scene, size_t runs) {
  Tally tally;
  Task::Hooks hooks;
  hooks.threads = 1;
  Task task(hooks);
  for (size_t i = 0; i < runs; ++i) {
    RandomStream random(99, i);
    const auto draw = [&] {
      const double x = random.normal(), y = random.normal();
      return Vec3{x, y, random.normal()};
    };
    const Vec3 turn = draw() * 0.003, shift = draw() * 0.02;
    const Transform truth = motion_about({5, 5, 1}, turn, shift);
    const auto reference = std::make_shared<const Cloud>(scenes::sampled(scene, 2 * i + 1));
    const auto moving = std::make_shared<const Cloud>(scenes::sampled(scene, 2 * i + 2, inverse(truth)));
    judge(register_icp(reference, moving, {}, {"registrar icp", icp_rows()}, task), truth, scene, tally);
  }
  return tally;
}

}  // namespace

TEST_CASE("icp__ellipsoids_cover_the_truth_as_often_as_they_say") {
  const bool full = std::getenv("JALON_FULL") != nullptr, small = std::getenv("JALON_SANITIZED") != nullptr;
  const size_t runs = full ? 1000 : small ? 5 : 60;
  // 93 to 97 % of a thousand; of fewer what chance leaves three times out of a thousand.
  const double n = static_cast<double>(runs), chance = 3 * std::sqrt(0.95 * 0.05 / n);
  const double low = full ? 0.93 : 0.94 - chance, high = full ? 0.97 : 1;
  for (const scenes::Scene& scene : scenes::all_scenes()) {
    const Tally tally = registered(scene, runs);
    const double cover = static_cast<double>(tally.covered) / n;
    MESSAGE("FIGURE icp honesty, " << std::string(scene.name) << ": " << 100 * cover << " % of " << runs
                                   << " covered, mean square " << tally.squares / tally.ranks << ", directions "
                                   << "named in "
                                   << 100 * static_cast<double>(tally.named) / n << " %");
    CHECK(cover >= low);
    CHECK(cover <= high);
    CHECK(tally.named == runs);
    CHECK(tally.converged >= runs * 99 / 100);
  }
}
