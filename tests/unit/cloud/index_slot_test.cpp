// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

std::vector<double> coordinates(size_t n) {
  std::vector<double> xyz;
  for (const Vec3& p : random_points(n, 8, 6)) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  return xyz;
}

TEST_CASE("index_slot__builds_once_on_the_smallest_cube_around_the_points") {
  const auto xyz = coordinates(2000);
  IndexSlot slot;
  Task task;
  const auto tree = slot.get(xyz, task);
  CHECK(slot.get(xyz, task) == tree);
  Box3 box;
  for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
  CHECK(tree->cube() == enclosing_cube(box));
  CHECK(tree->size() == 2000);
}

TEST_CASE("index_slot__keeps_the_tree_on_a_cube_asked_for_until_another_is") {
  const auto xyz = coordinates(500);
  IndexSlot slot;
  Task task;
  const Cube wide{{-16, -16, -16}, 64}, wider{{-64, -64, -64}, 128};
  const auto first = slot.get_on(xyz, wide, task);
  CHECK(first->cube() == wide);
  CHECK(slot.get(xyz, task) == first);
  CHECK(slot.get_on(xyz, wide, task) == first);
  const auto second = slot.get_on(xyz, wider, task);
  CHECK(second->cube() == wider);
  CHECK(slot.get(xyz, task) == second);
}

TEST_CASE("index_slot__drops_its_tree_which_who_holds_it_keeps") {
  const auto xyz = coordinates(500);
  IndexSlot slot;
  Task task;
  const auto first = slot.get(xyz, task);
  std::weak_ptr<const Octree> second;
  slot.drop();
  CHECK(first->size() == 500);
  second = slot.get(xyz, task);
  CHECK(second.lock() != first);
  slot.drop();
  CHECK(second.expired());
}

TEST_CASE("index_slot__a_build_that_failed_leaves_no_tree_and_the_next_one_succeeds") {
  const auto xyz = coordinates(5000);
  IndexSlot slot;
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task cancelled(hooks), task;
  CHECK(status_of([&] { slot.get(xyz, cancelled); }) == Status::kCancelled);
  const auto tree = slot.get(xyz, task);
  REQUIRE(tree);
  CHECK(tree->size() == 5000);
  CHECK(slot.get(xyz, cancelled) == tree);  // nothing to build, nothing to cancel
}

TEST_CASE("index_slot__of_no_points_is_an_empty_tree") {
  IndexSlot slot;
  Task task;
  const auto tree = slot.get({}, task);
  CHECK(tree->size() == 0);
  CHECK(slot.get({}, task) == tree);
}

}  // namespace
}  // namespace jalon
