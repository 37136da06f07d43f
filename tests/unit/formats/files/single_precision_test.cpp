// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Coordinates kept in 32 bits, against the steps of that precision at their size.
#include "formats/files/single_precision.h"

#include <doctest/doctest.h>

#include <functional>

#include "base/random.h"
#include "unit/formats/kept_log.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Points of a box of 20 m at the origin told, each coordinate as `kept` gives it.
Cloud box_at(const Vec3& origin, size_t n, const std::function<double(double)>& kept) {
  RandomStream random(3, 1);
  Buffer<double> xyz(3 * n);
  for (size_t i = 0; i < 3 * n; ++i) {
    const double at = i % 3 == 0 ? origin.x : i % 3 == 1 ? origin.y : origin.z;
    xyz[i] = kept(at + 20 * random.uniform());
  }
  return make_cloud(std::move(xyz));
}
double single(double value) { return static_cast<double>(static_cast<float>(value)); }
constexpr Vec3 kNational{651000, 6861000, 100};

std::vector<std::string> warnings_of(const Cloud& cloud) {
  KeptLog log;
  warn_of_single_precision(cloud, "scan.ply", log.task());
  return log.warnings();
}

}  // namespace

TEST_CASE("single_precision__national_coordinates_in_32_bits_are_told_with_their_steps") {
  const Cloud cloud = box_at(kNational, 5000, single);
  const std::array<double, 3> steps = single_precision_steps(cloud);
  CHECK(steps[0] == 0.0625);
  CHECK(steps[1] == 0.5);
  CHECK(steps[2] < 1e-5);
  const std::vector<std::string> warnings = warnings_of(cloud);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].starts_with("scan.ply: "));
  CHECK(warnings[0].find("x to steps of 0.0625, y to steps of 0.5;") != std::string::npos);
}

TEST_CASE("single_precision__doubles_whole_metres_and_places_near_the_origin_are_no_matter") {
  CHECK(warnings_of(box_at(kNational, 5000, [](double v) { return v; })).empty());
  CHECK(warnings_of(box_at(kNational, 5000, [](double v) { return std::round(v); })).empty());
  CHECK(warnings_of(box_at(kNational, 5000, [](double v) {
          return std::round(v * 1000) * 0.001;  // of a LAS file
        })).empty());
  CHECK(warnings_of(box_at({-30, 900, 5}, 5000, single)).empty());
  CHECK(warnings_of(box_at(kNational, 10, single)).empty());  // too few to tell
  CHECK(warnings_of(Cloud{}).empty());
  CHECK(single_precision_steps(box_at({0, 0, 0}, 500, [](double) { return 0.0; }))[1] == 0);
}

TEST_CASE("single_precision__a_scan_in_millimetres_near_its_origin_is_no_matter") {
  const Cloud cloud =
      box_at({20, 20, 20}, 5000, [](double v) { return single(1000 * v); });  // steps of 0.002 mm
  CHECK(single_precision_steps(cloud)[0] > 0.001);
  CHECK(warnings_of(cloud).empty());
}
