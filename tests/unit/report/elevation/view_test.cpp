// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Views of facades turned to every azimuth: rigid, upright, from the front, and of the faces asked for.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "base/random.h"
#include "report/elevation/view.h"
#include "unit/compare/refusal.h"
#include "unit/modelling/walls.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

Segmentation with_stations(bool has_pose) {
  Segmentation out = walls::segmentation_of({});
  Cloud cloud = *out.cloud;
  cloud.stations.emplace_back();
  cloud.stations[0].has_pose = has_pose;
  out.cloud = std::make_shared<const Cloud>(cloud);
  return out;
}

// The facade of named_facade, which faces -Y, turned anticlockwise about Z.
Model turned_facade(double angle, const named_facade::Setting& setting = {}) {
  Model m = named_facade::make(setting);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const Vec3& p) {
    return Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  };
  for (Vec3& p : m.vertices) p = turned(p);
  for (Face& face : m.faces) face.plane.normal = turned(face.plane.normal);
  return m;
}

ElevationView view_of(const Segmentation& segmentation, const Model& m, int64_t facade) {
  return elevation_view(segmentation, m, facade);
}

}  // namespace

TEST_CASE("view__of_a_facade_looks_at_its_front_squarely_from_every_azimuth") {
  const Segmentation segmentation = with_stations(true);
  for (int degrees = 0; degrees < 360; degrees += 15) {
    CAPTURE(degrees);
    const double angle = degrees * std::numbers::pi / 180;
    named_facade::Setting setting;
    setting.columns = setting.rows = 2;
    const Model m = turned_facade(angle, setting);
    const ElevationView view = view_of(segmentation, m, 1);
    // Facing -Y it is looked at to the north; each turn to the left turns the eye with it.
    CHECK(std::fabs(std::remainder(view.azimuth_rad() + angle, 2 * std::numbers::pi)) < 1e-9);
    // The far right foot of the wall lies 6 m to the right of the near one, neither nearer nor higher.
    const Vec3 left = view({0, 0, 0}),
               right = view({6 * std::cos(angle), 6 * std::sin(angle), 2.5});
    CHECK(right.x - left.x == doctest::Approx(6));
    CHECK(right.y - left.y == doctest::Approx(0));
    CHECK(right.z == 2.5);
    CHECK(left.z == 0);
    CHECK(view.T_view_world.determinant() == doctest::Approx(1));
    CHECK(view.name == "facade 1");
  }
}

TEST_CASE("view__keeps_world_heights_whatever_the_frame_adds") {
  ElevationView view;
  view.T_view_world.m = {0, 1, 0, -5, -1, 0, 0, 7, 0, 0, 1, -137};
  RandomStream random(1, 0);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p{random.normal(), random.normal(), 137 + random.normal()},
        q{random.normal(), random.normal(), 137 + random.normal()};
    CHECK(view(p).z == doctest::Approx(p.z));
    CHECK(norm(view(p) - view(q)) == doctest::Approx(norm(p - q)));
  }
  // It looks along its y axis: towards -X, west.
  CHECK(view.azimuth_rad() == doctest::Approx(-std::numbers::pi / 2));
  CHECK(ElevationView{}.azimuth_rad() == 0);
}

TEST_CASE("view__takes_the_side_of_the_walls_normals_and_for_the_whole_that_of_the_frame") {
  Segmentation segmentation = with_stations(false);
  Model m = turned_facade(0);
  CHECK(view_of(segmentation, m, 1).azimuth_rad() == doctest::Approx(0));
  // Whatever lies behind the wall, the segmentation has told the side: nobody mirrors its answer.
  for (Face& face : m.faces) face.plane.normal = -face.plane.normal;
  CHECK(std::fabs(view_of(segmentation, m, 1).azimuth_rad()) == doctest::Approx(std::numbers::pi));
  CHECK(view_of(segmentation, m, 0).azimuth_rad() == doctest::Approx(0));
  segmentation.T_facade_world.m = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
  CHECK(std::fabs(view_of(segmentation, m, 0).azimuth_rad()) == doctest::Approx(std::numbers::pi));
}

TEST_CASE("view__shows_one_facade_and_what_belongs_to_none") {
  Model m = turned_facade(0);
  m.parts.push_back(named_facade::part("", part_class::kFacade, kNoParent));
  const auto second = static_cast<uint32_t>(m.parts.size() - 1);
  m.parts.push_back(named_facade::part("wall 2", part_class::kWall, second));
  named_facade::add(m, second + 1, {{1, 0, 0}, 15},
                    {{{15, 0, 0}, {15, 8, 0}, {15, 8, 9}, {15, 0, 9}}}, {}, 72, 90);
  const Segmentation segmentation = with_stations(true);
  CHECK(facade_parts(m) == std::vector<uint32_t>{0, second});
  const ElevationView whole = view_of(segmentation, m, 0), first = view_of(segmentation, m, 1),
                      other = view_of(segmentation, m, 2);
  CHECK(whole.name.empty());
  CHECK(other.name == "part " + std::to_string(second));  // it has no name
  CHECK(other.azimuth_rad() == doctest::Approx(-std::numbers::pi / 2));
  for (size_t f = 0; f < m.faces.size(); ++f) {
    const bool is_ground = m.faces[f].part == 3, is_second = f + 1 == m.faces.size();
    CHECK(whole.shows(f));
    CHECK(first.shows(f) == (is_ground || !is_second));
    CHECK(other.shows(f) == (is_ground || is_second));
  }
  for (const int64_t facade : {int64_t{3}, int64_t{-1}, INT64_MAX}) {
    CAPTURE(facade);
    const auto view = [&] { view_of(segmentation, m, facade); };
    const std::string text = "facade " + std::to_string(facade) + " of a model that has 2";
    CHECK(test::refuses(view, Status::kInvalidArgument, text));
  }
}
