// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/kept_cores.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud sheet(uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  for (int k = 0; k < 500; ++k)
    points.push_back({random.uniform(), random.uniform(), 0.003 * random.normal()});
  return cloud_of(points);
}

CorePair cores_of(const Cloud& a, const Cloud& b, Task& task) {
  return {std::make_shared<const SurfaceCores>(a, Vec3{}, task),
          std::make_shared<const SurfaceCores>(b, Vec3{}, task)};
}

}  // namespace

TEST_CASE("kept_cores__go_to_one_comparison_the_other_way_round_and_then_nowhere") {
  Task task;
  const Cloud a = sheet(1), b = sheet(2);
  const CorePair made = cores_of(a, b, task);
  const auto kept = keep_cores(a, made);
  CHECK(take_kept_cores(a, b, {}, task).reference == nullptr);         // the same way round
  CHECK(take_kept_cores(b, a, {1, 0, 0}, task).reference == nullptr);  // about another origin
  CHECK(take_kept_cores(sheet(3), a, {}, task).reference == nullptr);  // with another cloud
  const CorePair taken = take_kept_cores(b, a, {}, task);
  CHECK(taken.reference == made.compared);
  CHECK(taken.compared == made.reference);
  CHECK(take_kept_cores(b, a, {}, task).reference == nullptr);
}

TEST_CASE("kept_cores__end_with_what_keeps_them") {
  Task task;
  const Cloud a = sheet(1), b = sheet(2);
  std::weak_ptr<const SurfaceCores> watched;
  {
    CorePair made = cores_of(a, b, task);
    watched = made.reference;
    const auto kept = keep_cores(a, std::move(made));
    CHECK_FALSE(watched.expired());
  }
  CHECK(watched.expired());
  CHECK(take_kept_cores(b, a, {}, task).reference == nullptr);
}
