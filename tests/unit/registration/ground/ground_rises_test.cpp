// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/ground/ground_rises.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

using namespace jalon;

namespace {

constexpr double kSlope = 0.05, kAbove_m = 0.2;

void add_face(Model& model, const char* part_class, const std::vector<Vec3>& corners) {
  Face face;
  face.part = static_cast<uint32_t>(model.parts.size());
  model.parts.emplace_back();
  model.parts.back().part_class = part_class;
  face.plane.normal = normalized(newell_normal(corners));
  face.plane.offset = dot(face.plane.normal, corners[0]);
  model.add_face(face, {corners});
}

// A street that climbs eastward, and the model's ground that much above it; far in the national grid.
struct Climb {
  Vec3 at{652000, 6861000, 35};
  Model model;
  Trajectory drive;
  Cloud cloud;

  explicit Climb(double covered) {
    const auto place = [&](double x, double y, double above) {
      return at + Vec3{x, y, kSlope * x + above};
    };
    add_face(model, part_class::kGround,
             {place(-9, -9, kAbove_m), place(99, -9, kAbove_m), place(99, 9, kAbove_m),
              place(-9, 9, kAbove_m)});
    add_face(model, part_class::kRoof, {place(-9, -9, 5), place(99, -9, 5), place(99, 9, 5)});
    for (int t = 0; t <= 10; ++t) {
      drive.times_s.push_back(t);
      drive.positions.push_back(place(5 * t, 0, 1.2));
      drive.attitudes_rad.push_back({});
    }
    RandomStream random(8, 1);
    std::vector<double> xyz, times;
    for (int i = 0; i < 4000; ++i) {
      const double t = 10 * random.uniform(), y = 12 * random.uniform() - 6;
      // Vans stand in the way, and kerbs a hand higher from 3.6 m on.
      const double above = random.uniform() < covered ? 0.4 + random.uniform()
                           : std::fabs(y) > 3.6       ? 0.12
                                                      : 0.005 * random.normal();
      const Vec3 p = place(5 * t, y, above);
      xyz.insert(xyz.end(), {p.x, p.y, p.z});
      times.push_back(t);
    }
    Buffer<double> points(xyz.size());
    std::ranges::copy(xyz, points.data());
    cloud = make_cloud(std::move(points));
    cloud.fields.set(make_column<double>({"time", ElementType::kFloat64, 1, "s", ""}, times));
  }
  std::vector<GroundRise> rises(uint64_t least_points) const {
    const std::vector<double> controls{0, 2, 4, 6, 8, 10};
    Task task;
    return ground_rises(cloud, drive, controls, *ground_of(model, task),
                        {std::vector<double>(controls.size(), 1.0), 0.005, least_points}, task);
  }
};

}  // namespace

TEST_CASE("ground_rises__of_a_street_that_climbs__are_how_far_the_model_is_above_it") {
  const std::vector<GroundRise> made = Climb(0).rises(5);
  REQUIRE(made.size() == 5);
  for (uint32_t c = 0; c < 5; ++c) {
    CHECK(made[c].interval == c);
    CHECK(made[c].share == doctest::Approx(0.5).epsilon(0.1));
    CHECK(std::fabs(made[c].rise_m - kAbove_m) < 4 * std::sqrt(made[c].variance_m2));
    CHECK(made[c].variance_m2 < 1e-6);
    CHECK(made[c].points > 300);
  }
}

TEST_CASE("ground_rises__of_a_street_with_vans__stay_at_the_ground") {
  for (const GroundRise& r : Climb(0.2).rises(5)) CHECK(std::fabs(r.rise_m - kAbove_m) < 0.003);
}

TEST_CASE("ground_rises__with_too_few_points__are_none") { CHECK(Climb(0).rises(5000).empty()); }

TEST_CASE("ground_of__a_model_without_ground__is_none") {
  Model model;
  add_face(model, part_class::kRoof, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  Task task;
  CHECK(ground_of(model, task) == nullptr);
}
