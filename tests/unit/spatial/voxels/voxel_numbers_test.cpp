// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/voxel_numbers.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/random.h"

using namespace jalon;

namespace {

using Cell = std::array<double, 3>;  // z, y, x: as they count

std::vector<Cell> voxel_numbers_cells_of(const std::vector<double>& xyz, const Vec3& origin,
                                         double cell_m) {
  std::vector<Cell> cells;
  for (size_t i = 0; i < xyz.size(); i += 3)
    cells.push_back({std::floor((xyz[i + 2] - origin.z) / cell_m),
                     std::floor((xyz[i + 1] - origin.y) / cell_m),
                     std::floor((xyz[i] - origin.x) / cell_m)});
  return cells;
}

Box3 voxel_numbers_box_of(const std::vector<double>& xyz) {
  Box3 box;
  for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
  return box;
}

// Two points in one cell half of the time, so that equal keys are met too.
std::vector<double> in_pairs(size_t n, double size, double near, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i)
    for (size_t axis = 0; axis < 3; ++axis) {
      const double before = i % 2 == 1 ? xyz[3 * (i - 1) + axis] : 0;
      xyz.push_back(i % 2 == 1 ? before + near * (random.uniform() - 0.5)
                               : size * (random.uniform() - 0.5));
    }
  return xyz;
}

template <class F>
Status status_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

void check_order(const std::vector<double>& xyz, const VoxelNumbers& numbers,
                 const std::vector<Cell>& cells) {
  size_t equal = 0, wrong = 0;
  for (size_t i = 0; i < cells.size(); ++i)
    for (size_t j = 0; j < cells.size(); ++j) {
      const uint64_t a = numbers.key(i), b = numbers.key(j);
      wrong += (a < b) != (cells[i] < cells[j]) || (a == b) != (cells[i] == cells[j]);
      equal += i != j && a == b;
    }
  CHECK(wrong == 0);
  CHECK(equal > 0);
  if (numbers.key_bits() < 64)
    for (size_t i = 0; i < xyz.size() / 3; ++i)
      REQUIRE((numbers.key(i) >> numbers.key_bits()) == 0);
}

}  // namespace

TEST_CASE("voxel_numbers__keys_are_ordered_as_cells_by_z_then_y_then_x") {
  const auto xyz = in_pairs(300, 20, 0.5, 1);
  const Vec3 origin{-3, 2, 5};  // cells on both sides of it
  Task task;
  const VoxelNumbers numbers(xyz, voxel_numbers_box_of(xyz), origin, 0.7, task);
  CHECK(numbers.key_bits() <= 15);
  check_order(xyz, numbers, voxel_numbers_cells_of(xyz, origin, 0.7));
}

TEST_CASE("voxel_numbers__too_large_for_64_bits_become_ranks_with_the_same_order") {
  const auto xyz = in_pairs(300, 1e5, 1e-8, 2);
  const double cell_m = 1e-7;  // 40 bits an axis
  Task task;
  const VoxelNumbers numbers(xyz, voxel_numbers_box_of(xyz), {0, 0, 0}, cell_m, task);
  CHECK(numbers.key_bits() <= 27);  // at most 300 ranks an axis
  check_order(xyz, numbers, voxel_numbers_cells_of(xyz, {0, 0, 0}, cell_m));
}

TEST_CASE("voxel_numbers__refuse_more_than_2_to_the_41_cells_either_side_of_the_origin") {
  Task task;
  const std::vector<double> xyz = {0, 0, 0, 0, 0x1p41, 0};
  CHECK(status_of([&] {
          VoxelNumbers(xyz, voxel_numbers_box_of(xyz), {0, 0, 0}, 1, task);
        }) == Status::kLimit);
  CHECK(status_of([&] {
          VoxelNumbers(xyz, voxel_numbers_box_of(xyz), {0, 1, 0}, 1, task);
        }) == Status::kOk);
}

TEST_CASE("voxel_numbers__a_cell_needs_a_size_and_points_a_32_bit_number") {
  for (const double cell_m : {0.0, -0.1, std::nan(""), HUGE_VAL})
    CHECK(status_of([&] { require_voxels(10, cell_m); }) == Status::kInvalidArgument);
  CHECK(status_of([] { require_voxels(0xffffffffu, 1); }) == Status::kLimit);
  CHECK(status_of([] { require_voxels(0xfffffffeu, 1); }) == Status::kOk);
}
