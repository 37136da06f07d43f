// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Does the covariance of ICP tell the truth? Each scene is sampled anew, twice, again and again.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "base/distributions.h"
#include "base/parallel.h"
#include "geometry/rigid_motion.h"
#include "registration/icp/icp.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;

namespace {

struct Tally {
  size_t covered = 0, named = 0, converged = 0;
  double squares = 0, ranks = 0;  ///< of the errors over their standard deviations
};

// Is the true pose in the 95 % ellipsoid of the directions that are observable?
void judge(const Registration& r, const Transform& truth, const scenes::Scene& scene,
           Tally& tally) {
  const Transform error = r.pose * inverse(truth);
  const Vec3 turn = rotation_vector(error), shift = error.point(r.centre) - r.centre;
  const double off[6] = {turn.x, turn.y, turn.z, shift.x, shift.y, shift.z};
  double squares = 0, rank = 0;
  for (size_t k = 0; k < 6; ++k) {
    if (r.directions.require("observable").number(k) == 0) continue;
    double along = 0;
    for (uint32_t i = 0; i < 6; ++i)
      along += r.directions.require("direction").number(k, i) * off[i] *
               (i < 3 ? r.extent_m * r.extent_m : 1);
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

Tally& operator+=(Tally& a, const Tally& b) {
  a.covered += b.covered, a.named += b.named, a.converged += b.converged;
  a.squares += b.squares, a.ranks += b.ranks;
  return a;
}

// One run, on one thread: a Task of its own.
Tally registered(const scenes::Scene& scene, size_t run) {
  Task::Hooks hooks;
  hooks.threads = 1;
  Task task(hooks);
  RandomStream random(99, run);
  const auto draw = [&] {
    const double x = random.normal(), y = random.normal();
    return Vec3{x, y, random.normal()};
  };
  const Vec3 turn = draw() * 0.003, shift = draw() * 0.02;
  const Transform truth = motion_about({5, 5, 1}, turn, shift);
  const auto reference = std::make_shared<const Cloud>(scenes::sampled(scene, 2 * run + 1));
  const auto moving =
      std::make_shared<const Cloud>(scenes::sampled(scene, 2 * run + 2, inverse(truth)));
  Tally tally;
  judge(register_icp(reference, moving, {}, IcpSettings{}, task), truth, scene, tally);
  return tally;
}

Tally registered_often(const scenes::Scene& scene, size_t runs) {
  Task task;
  return parallel_reduce(task, runs, 1, Tally{},
                         [&](size_t begin, size_t) { return registered(scene, begin); });
}

double share_of(const scenes::Scene& scene, const char* what, const Tally& tally, size_t runs) {
  const double n = static_cast<double>(runs), cover = static_cast<double>(tally.covered) / n;
  MESSAGE("FIGURE icp honesty, " << std::string(what) + scene.name << ": " << 100 * cover
                                 << " % of " << runs << " covered, mean square "
                                 << tally.squares / tally.ranks << ", directions named in "
                                 << 100 * static_cast<double>(tally.named) / n << " %");
  return cover;
}

}  // namespace

TEST_CASE("icp__ellipsoids_cover_the_truth_as_often_as_they_say") {
  const bool full = std::getenv("JALON_FULL") != nullptr,
             small = std::getenv("JALON_SANITIZED") != nullptr;
  const size_t runs = full ? 1000 : small ? 5 : 30;
  // 93 to 97 % of a thousand; of fewer 95 % less three standard deviations of the binomial.
  const double n = static_cast<double>(runs), chance = 3 * std::sqrt(0.95 * 0.05 / n);
  const double low = full ? 0.93 : 0.95 - chance, high = full ? 0.97 : 1;
  for (const scenes::Scene& scene : scenes::all_scenes()) {
    const Tally tally = registered_often(scene, runs);
    const double cover = share_of(scene, "", tally, runs);
    CHECK(cover >= low);
    CHECK(cover <= high);
    CHECK(tally.named == runs);
    CHECK(tally.converged >= runs * 99 / 100);
  }
}

// Scenes that nothing was tuned on: what noise hides stays open, and what is said of the rest holds.
TEST_CASE("icp__names_what_noise_hides") {
  const bool full = std::getenv("JALON_FULL") != nullptr,
             small = std::getenv("JALON_SANITIZED") != nullptr;
  const size_t runs = full ? 200 : small ? 2 : 20;
  scenes::Scene plane = scenes::one_plane(), reveal = scenes::corridor();
  plane.noise_m = 0.01;
  reveal.patches.push_back(
      {{9, 0, 0}, {0, 0.05, 0}, {0, 0, 2.6}});  // of a door, 5 cm deep: some ten points
  reveal.patches.push_back({{10, 0, 0}, {0, 0.05, 0}, {0, 0, 2.1}});
  const double n = static_cast<double>(runs), chance = 3 * std::sqrt(0.95 * 0.05 / n);
  for (const scenes::Scene& scene : {plane, reveal}) {
    const Tally tally = registered_often(scene, runs);
    CHECK(share_of(scene, "noise 10 mm or a reveal, ", tally, runs) >= 0.95 - chance);
    CHECK(tally.named == runs);
  }
}
