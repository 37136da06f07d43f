// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/coherence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

/// Planes about every so many points of a square of 4 m, each tested against itself: nothing moved.
struct TestedFloor {
  Cloud cloud;
  Task task;
  SurfaceCores cores;
  CoreTests tests;

  TestedFloor() : cloud(points()), cores(cloud, {}, task) {
    tests.cores.resize(cores.size());
    for (size_t k = 0; k < cores.size(); ++k) {
      tests.cores[k].has_surface = true;
      tests.cores[k].surface = static_cast<uint32_t>(k);
      tests.cores[k].sigma_m = 0.001;
    }
  }
  static Cloud points() {
    RandomStream random(6, 1);
    Buffer<double> xyz(3 * 4000);
    for (size_t i = 0; i < 4000; ++i) {
      xyz[3 * i] = 4 * random.uniform();
      xyz[3 * i + 1] = 4 * random.uniform();
      xyz[3 * i + 2] = 0.001 * random.normal();
    }
    return make_cloud(std::move(xyz));
  }
  /// The cores about the middle, nearest first. Their normals may point up or down: distances follow them.
  std::vector<size_t> about_middle(uint32_t n) const {
    std::vector<Neighbour> found(n);
    found.resize(cores.nearest({2, 2, 0}, n, found));
    std::vector<size_t> out;
    for (const Neighbour& one : found) out.push_back(one.index);
    return out;
  }
  void rise(size_t core, double by_m, CoreState state) {
    tests.cores[core].distance_m = cores[core].normal.z > 0 ? by_m : -by_m;
    tests.cores[core].state = state;
  }
  void settle() { settle_together(cores, cores, tests, task); }
};

}  // namespace

TEST_CASE("coherence__takes_back_what_moved_or_came_alone") {
  TestedFloor moved;
  const size_t core = moved.about_middle(1)[0];
  moved.rise(core, 0.01, CoreState::kMoved);
  moved.settle();
  CHECK(moved.tests.cores[core].state == CoreState::kUnchanged);
  TestedFloor came;
  came.tests.cores[core].state = CoreState::kNew;
  came.settle();
  CHECK(came.tests.cores[core].state == CoreState::kUntold);
}

TEST_CASE("coherence__grows_beside_what_moved_to_the_same_side_alone") {
  TestedFloor floor;
  const std::vector<size_t> middle = floor.about_middle(12);
  REQUIRE(middle.size() == 12);
  for (const size_t core : middle) floor.rise(core, 0.01, CoreState::kMoved);
  floor.rise(middle[0], 0.0025, CoreState::kUnchanged);   // beyond its own level
  floor.rise(middle[1], -0.0025, CoreState::kUnchanged);  // to the other side
  floor.rise(middle[2], 0.0015, CoreState::kUnchanged);   // within its level
  floor.settle();
  CHECK(floor.tests.cores[middle[0]].state == CoreState::kMoved);
  CHECK(floor.tests.cores[middle[1]].state == CoreState::kUnchanged);
  CHECK(floor.tests.cores[middle[2]].state == CoreState::kUnchanged);
  CHECK(floor.tests.cores[middle[3]].state == CoreState::kMoved);
}

TEST_CASE("coherence__cores_on_two_surfaces_of_the_reference_have_not_moved") {
  for (const size_t surfaces : {1, 2, 3}) {
    TestedFloor floor;
    const std::vector<size_t> middle = floor.about_middle(30);
    for (size_t i = 0; i < middle.size(); ++i) {
      const size_t surface = middle[i % surfaces];
      CoreTest& test = floor.tests.cores[middle[i]];
      test.surface = static_cast<uint32_t>(surface);
      test.distance_m = floor.cores[surface].normal.z > 0 ? 0.01 : -0.01;
      test.state = CoreState::kMoved;
    }
    floor.settle();
    constexpr size_t kInner = 8;  // the outer ones may be lonely
    for (size_t i = 0; i < kInner; ++i)
      CHECK(floor.tests.cores[middle[i]].state ==
            (surfaces < 3 ? CoreState::kUnchanged : CoreState::kMoved));
  }
}
