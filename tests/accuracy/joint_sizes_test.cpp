// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <ctime>

#include "base/random.h"
#include "registration/solvers/joint_problem.h"
#include "registration/joint/ray_matching.h"

// How the cost of a joint adjustment grows. What it takes is printed (JALON_FULL: the size that is promised).

namespace jalon::joint_sizes_test {

namespace {

bool is_full() { return std::getenv("JALON_FULL") != nullptr; }
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double greatest_memory_gib() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / (1024 * 1024);
}

// A long drive: strips seen from four control times each; five strips a facade, eight facades a block;
// facades along the street and across it by turns.
JointProblem long_drive(size_t strips, size_t controls) {
  std::vector<double> times, sigmas(controls, 1.0), velocities(controls, 0.01);
  for (size_t c = 0; c < controls; ++c) times.push_back(static_cast<double>(c));
  JointProblem made;
  made.x = made.y = gauss_markov(times, sigmas, velocities);
  made.facades = static_cast<uint32_t>(strips / 5), made.blocks = made.facades / 8;
  RandomStream random(1, 0);
  for (uint32_t s = 0; s < strips; ++s) {
    StripCondition strip;
    strip.facade = s / 5, strip.block = std::min(strip.facade / 8, made.blocks - 1);
    const double turn = 0.1 * (random.uniform() - 0.5);
    strip.normal = strip.facade % 2 == 0 ? Vec2{std::sin(turn), std::cos(turn)}
                                         : Vec2{std::cos(turn), std::sin(turn)};
    const auto first = static_cast<uint32_t>(std::min<size_t>(s * controls / strips, controls - 4));
    strip.shares = {{first, 0.2}, {first + 1, 0.4}, {first + 2, 0.3}, {first + 3, 0.1}};
    strip.distance_m = random.normal();
    made.strips.push_back(strip);
  }
  return made;
}

// Walls of 1.5 x 10 m on both sides of parallel streets.
struct WallRows {
  StripScene scene;
  JointPoints points;
  JointPlaces still;

  WallRows(uint32_t strips, size_t rays) {
    const uint32_t a_row = 1000;
    scene.strips.resize(strips), scene.blocks = 1, scene.facades = 1;
    for (uint32_t s = 0; s < strips; ++s) {
      const double x = 1.5 * (s % a_row), y = 16.0 * (s / a_row);
      scene.strips[s] = {0, 0, {0, -1}, -y};
      scene.strip_of_face.push_back(s), scene.block_of_face.push_back(0);
      const Vec3 p{x, y, 0}, along{1.5, 0, 0}, up{0, 0, 10};
      for (const Vec3& c : {p, p + along, p + along + up, p, p + along + up, p + up})
        scene.corners.push_back(c);
      scene.face_of.insert(scene.face_of.end(), {s, s});
    }
    RandomStream random(2, 0);
    for (size_t i = 0; i < rays; ++i) {
      const auto s = static_cast<uint32_t>(i * strips / rays);  // as one drives by
      const Vec3 wall{1.5 * (s % a_row + random.uniform()), 16.0 * (s / a_row),
                      10 * random.uniform()},
          from = wall + Vec3{6 * random.uniform() - 3, -8, 2 - wall.z};
      points.index.push_back(static_cast<uint32_t>(i));
      points.at.push_back(wall), points.origin.push_back(from);
      points.direction.push_back(normalized(wall - from));
      points.times_s.push_back(0.5), points.places.push_back({0, 0.5});
      points.plan_covariance_m2.push_back({1e-4, 0, 1e-4});
      points.normal.push_back({0, 1});
      points.id.push_back(s);
    }
    still.trajectory = {{0, 0}, {0, 0}};
    still.model = {{{0, 0}}, {0}, std::vector<double>(strips, 0)};
  }
};

}  // namespace

// Both grow, then strips alone and control times alone.
TEST_CASE("joint_sizes__of_a_drive_four_times_as_long__have_the_same_sigmas") {
  const size_t most = is_full() ? 100000 : 4000, times = most / 10;
  struct Size {
    size_t strips, controls;
  };
  double last = 0;
  for (const Size& size : {Size{most / 4, times / 4}, Size{most / 2, times / 2}, Size{most, times},
                           Size{most / 2, times}, Size{most, times / 2}}) {
    const JointProblem problem = long_drive(size.strips, size.controls);
    const double start = processor_s();
    const JointSolution solution = solve_reduced(problem, JointWanted::kSigmas);
    const double used = processor_s() - start;
    MESSAGE("FIGURE joint sizes: ", size.strips, " strips, ", problem.controls(),
            " control times, ", problem.blocks, " blocks, with all sigmas: ", used,
            " s of one processor, ", last > 0 ? used / last : 1,
            " times that of the line before; greatest memory ", greatest_memory_gib(), " GiB");
    last = used;
    // The middle of a long drive does not know where it ends: as sure as that of the longest.
    const Vec2 middle = solution.trajectory_sigmas[problem.controls() / 2];
    CHECK(middle.u < 1);
    CHECK(middle.u > 0.01);
    CHECK(solution.chi_square > 0);
  }
}

TEST_CASE("joint_sizes__of_many_strips__rays_find_theirs") {
  const uint32_t strips = is_full() ? 100000 : 4000;
  const size_t rays = is_full() ? 2000000 : 20000;
  const WallRows rows(strips, rays);
  for (const uint32_t threads : {1u, 2u}) {
    Task task(Task::Hooks{.threads = threads});
    timespec from{}, to{};
    const double start = processor_s();
    clock_gettime(CLOCK_MONOTONIC, &from);
    const std::vector<PointMatch> matches =
        match_points(rows.points, rows.scene, rows.still, {}, task);
    clock_gettime(CLOCK_MONOTONIC, &to);
    const double used = processor_s() - start;
    size_t right = 0;
    for (size_t i = 0; i < rays; ++i) right += matches[i].strip == rows.points.id[i] ? 1 : 0;
    CHECK(static_cast<double>(right) > 0.9999 * static_cast<double>(rays));
    const double taken = static_cast<double>(to.tv_sec - from.tv_sec) +
                         1e-9 * static_cast<double>(to.tv_nsec - from.tv_nsec);
    MESSAGE("FIGURE joint sizes: ", rays, " rays on ", strips, " strips, the tree made as well, ",
            threads, " threads: ", 1e-6 * static_cast<double>(rays) / taken, " M rays a second, ",
            1e-6 * static_cast<double>(rays) / used, " M a processor second");
  }
}

}  // namespace jalon::joint_sizes_test
