// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What happened to a box on a floor, against what was done to it.
#include "compare/changes/diagnosis.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/epochs.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr Vec3 kBlock{0.8, 0.55, 0.4};

// 3.6 x 3.6 m of floor, by a height above it; another sampling for each stream.
std::vector<Vec3> ground(uint64_t stream, double (*height)(double, double) = nullptr) {
  RandomStream random(5, stream);
  std::vector<Vec3> points;
  add_surface(points, 3.6, 3.6, random, [&](double s, double t) {
    const double x = 3.6 * s - 1.8, y = 3.6 * t - 1.8;
    return Vec3{x, y, height == nullptr ? 0 : height(x, y)};
  });
  return points;
}

std::vector<Vec3> with_block(const Vec3& foot_corner, uint64_t stream) {
  RandomStream random(6, stream);
  std::vector<Vec3> points = ground(stream);
  add_box(points, foot_corner, kBlock, random);
  return points;
}

Diagnosis diagnosed(const TwoEpochs& epochs) {
  RegionSettings settings;
  settings.threshold_m = settings.cell_m = kApart_m;
  Task task;
  return diagnose(epochs.forward, epochs.reverse, settings, task);
}

void check_moved(const Vec3& by, ChangeClass expected) {
  const Vec3 from{-1.3, -0.95, 0};
  const TwoEpochs epochs(with_block(from, 3), with_block(from + by, 4));
  const Diagnosis found = diagnosed(epochs);
  REQUIRE(found.changes.size() == 1);
  const Change& change = found.changes[0];
  CHECK(change.change_class == expected);
  REQUIRE(change.match.found);
  CHECK(change.confidence == change.match.explained);
  // A thousand points on exact planes; only those within 40 mm of an edge find a neighbour round the corner.
  CHECK(norm(change.match.displacement - by) < 0.005);
  CHECK(norm(change.match.rotation) < 0.01);
}

}  // namespace

TEST_CASE("diagnosis__of_a_box_that_was_put_down_is_an_appearance_and_the_other_way_round") {
  const TwoEpochs put(ground(1), with_block({-0.5, -0.4, 0}, 2));
  const Diagnosis found = diagnosed(put);
  REQUIRE(found.changes.size() == 1);
  CHECK(found.changes[0].change_class == ChangeClass::kAppearance);
  const std::vector<uint32_t>& block = found.changes[0].object.after;
  CHECK(found.changes[0].object.before.empty());
  // All of the block but its foot, up to the 50 mm that the floor may be thick of its 400 mm.
  CHECK(block.front() >= ground(2).size());
  CHECK(block.size() > 0.8 * static_cast<double>(put.after.cloud().size() - ground(2).size()));
  CHECK(found.changes[0].confidence > 0.5);
  CHECK_FALSE(found.changes[0].match.found);
  const TwoEpochs taken(with_block({-0.5, -0.4, 0}, 2), ground(1));
  const Diagnosis reverse = diagnosed(taken);
  REQUIRE(reverse.changes.size() == 1);
  CHECK(reverse.changes[0].change_class == ChangeClass::kDisappearance);
  CHECK(reverse.changes[0].object.after.empty());
  CHECK(reverse.changes[0].object.before.front() >= ground(2).size());
}

TEST_CASE("diagnosis__of_a_box_set_aside_is_a_displacement_by_what_it_went") {
  check_moved({1.25, 0.95, 0}, ChangeClass::kDisplacement);
}

TEST_CASE("diagnosis__of_a_box_pushed_a_little_is_a_displacement_with_overlap") {
  check_moved({0.3, 0.2, 0}, ChangeClass::kDisplacementOverlap);
}

TEST_CASE("diagnosis__of_a_dent_that_grows_from_nothing_is_a_deformation") {
  const TwoEpochs epochs(ground(5), ground(6, [](double x, double y) {
                           return -0.4 * std::exp(-(x * x + y * y) / (2 * 0.4 * 0.4));
                         }));
  const Diagnosis found = diagnosed(epochs);
  REQUIRE_FALSE(found.changes.empty());
  for (const Change& change : found.changes)
    CHECK((change.change_class == ChangeClass::kDeformation ||
           change.change_class == ChangeClass::kDeformationOverlap));
  CHECK(diagnosed(TwoEpochs(ground(5), ground(6))).changes.empty());
}

TEST_CASE("diagnosis__refuses_other_methods_and_a_threshold_of_0") {
  const TwoEpochs epochs(ground(1), ground(2));
  Comparison other = epochs.forward;
  other.points.remove("nearest");
  Task task;
  const auto diagnose_with = [&](const Comparison& forward, const Comparison& reverse,
                                 double threshold_m) {
    RegionSettings settings;
    settings.threshold_m = threshold_m;
    return diagnose(forward, reverse, settings, task);
  };
  CHECK(refuses([&] { diagnose_with(other, epochs.reverse, 0.1); }, Status::kInvalidArgument,
                "two comparisons of method distance"));
  CHECK(refuses([&] { diagnose_with(epochs.forward, other, 0.1); }, Status::kInvalidArgument,
                "two comparisons of method distance"));
  CHECK(refuses([&] { diagnose_with(epochs.forward, epochs.reverse, 0); }, Status::kInvalidArgument,
                "threshold_m is 0"));
}
