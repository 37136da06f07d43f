// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// A row of Boulaassal 2010, table 3.2: points before and after, and the share removed.
struct Row {
  uint64_t count_in, count_out;
  double percent;
};
constexpr double kHalfDigit = 0.005 + 1e-9;  // the table prints two decimals

constexpr Row kTable[] = {{302069, 280044, 7.29},   {7306170, 6881147, 5.82},
                          {132477, 114827, 13.32},  {654519, 554864, 15.23},
                          {1664481, 677387, 59.30}, {938493, 392517, 58.18},
                          {706295, 587825, 16.77},  {8000000, 7845200, 1.94},
                          {530912, 445785, 16.03},  {1163729, 1007644, 13.41}};

/// Distinct points on the 0.1 mm grid, exact (or jittered) copies of some of them, shuffled;
/// "source" tells which are equal.
Cloud scene(const Row& row, bool jitter, const Vec3& offset) {
  std::vector<Vec3> points(row.count_in);
  std::vector<uint32_t> source(row.count_in);
  RandomStream random(row.count_in, 0);
  for (uint64_t i = 0; i < row.count_in; ++i) {
    const uint64_t s = i < row.count_out ? i : random.below(row.count_out);
    source[i] = static_cast<uint32_t>(s);
    // Node s of a lattice of 400 x 200 x ... nodes, 1.3 mm apart: distinct by construction.
    points[i] =
        Vec3{13e-4 * static_cast<double>(s % 400), 13e-4 * static_cast<double>(s / 400 % 200),
             13e-4 * static_cast<double>(s / 80000)};
    if (jitter && i >= row.count_out)
      for (int c = 0; c < 3; ++c) points[i][c] += 0.8e-4 * (random.uniform() - 0.5);
    points[i] += offset;
  }
  for (uint64_t i = row.count_in - 1; i > 0; --i) {
    const uint64_t j = random.below(i + 1);
    std::swap(points[i], points[j]);
    std::swap(source[i], source[j]);
  }
  Cloud cloud = cloud_of(points);
  cloud.fields.set(make_column<uint32_t>({"source", ElementType::kUint32, 1, "", ""}, source));
  return cloud;
}

TEST_CASE("duplicates__table_3_2__every_row_to_the_point") {
  const bool full = std::getenv("JALON_FULL") != nullptr;
  Task task;
  for (const Row& row : kTable) {
    if (!full && row.count_in > 1000000) continue;
    const Cloud cloud = scene(row, false, {});
    const auto start = std::chrono::steady_clock::now();
    const Cloud unique = without_duplicates(cloud, 1e-4, task);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Reduction r = reduction_of(cloud.size(), unique.size());
    MESSAGE(r.count_in, " -> ", r.count_out, ", ", r.removed, " removed (", r.removed_percent,
            " %) in ", seconds, " s");
    CHECK(r.count_out == row.count_out);
    CHECK(r.removed == row.count_in - row.count_out);
    CHECK(std::fabs(r.removed_percent - row.percent) <= kHalfDigit);
  }
}

TEST_CASE("duplicates__first_occurrence_stays_with_its_fields_in_order") {
  Task task;
  const Cloud cloud = scene(kTable[2], false, {});
  const auto source = cloud.fields.require("source").values<uint32_t>();
  const Cloud unique = without_duplicates(cloud, 1e-4, task);
  std::vector<uint8_t> seen(kTable[2].count_out, 0);
  size_t at = 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (seen[source[i]]++) continue;
    REQUIRE(at < unique.size());
    CHECK(unique.fields.require("source").values<uint32_t>()[at] == source[i]);
    CHECK(unique.point(at) == cloud.point(i));
    ++at;
  }
  CHECK(at == unique.size());
}

TEST_CASE("duplicates__copies_jittered_below_half_a_step__are_found_on_the_map_grid_too") {
  Task task;
  CHECK(without_duplicates(scene(kTable[2], true, {}), 1e-4, task).size() == kTable[2].count_out);
  CHECK(without_duplicates(scene(kTable[2], true, kFar), 1e-4, task).size() == kTable[2].count_out);
}

TEST_CASE("duplicates__one_shared_coordinate_is_no_duplicate") {
  Task task;
  // The printed formula would drop these.
  const Cloud cloud = cloud_of({{0, 0, 0}, {0, 1, 2}, {3, 1, 0}, {0, 0, 1}});
  CHECK(without_duplicates(cloud, 1e-4, task).size() == 4);
}

TEST_CASE("duplicates__threads_and_shift__the_same_choice") {
  const Cloud cloud = scene(kTable[2], true, {});
  Task one(threads(1)), seven(threads(7));
  CHECK(same_bits(without_duplicates(cloud, 1e-3, one), without_duplicates(cloud, 1e-3, seven)));
  const auto points = random_points(100000, 0.5, 8);
  const Cloud near = without_duplicates(cloud_of(points), 0.01, one);
  const Cloud far = without_duplicates(cloud_of(shifted(points, kFar)), 0.01, one);
  REQUIRE(near.size() == far.size());
  CHECK(near.size() < 100000);
  for (size_t i = 0; i < near.size(); ++i) CHECK(near.point(i) + kFar == far.point(i));
}

TEST_CASE("duplicates__bad_tolerance__is_refused") {
  Task task;
  const Cloud cloud = cloud_of({{0, 0, 0}, {1e6, 0, 0}});
  for (const double bad : {0.0, -1.0, double(NAN), double(INFINITY)})
    CHECK(status_of([&] { without_duplicates(cloud, bad, task); }) == Status::kInvalidArgument);
  CHECK(status_of([&] { without_duplicates(cloud, 1e-300, task); }) == Status::kLimit);
  CHECK(without_duplicates(cloud_of(std::vector<Vec3>(1000, Vec3{1, 2, 3})), 1e-4, task).size() ==
        1);
}

}  // namespace
}  // namespace jalon
