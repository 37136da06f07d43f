// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The 2D vector model of each plane.
#include <doctest/doctest.h>

#include <set>

#include "base/error.h"
#include "geometry/polygon2.h"
#include "modelling/plane/ring_tools.h"
#include "unit/modelling/sampled_wall.h"

using namespace walls;

namespace {

constexpr Rectangle kVectoriseWindow{1, 0.8, 2, 1.8};

std::vector<Vec3> wall(double y) {
  SampledWall out;
  out.spacing = 0.05;
  out.solid = [](double u, double v) {
    return u > 0 && v > 0 && u < 3 && v < 2.5 && !kVectoriseWindow.contains(u, v);
  };
  std::vector<Vec3> points = out.points();
  for (Vec3& p : points) p.y += y;
  return points;
}

std::vector<VectorPlane> planes_of(const Segmentation& segmentation, const char* json,
                                   unsigned threads) {
  ParamSet params("modeller outlines", outlines_rows());
  params.from_json(json);
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return vectorise(segmentation, settings_from<VectoriseSetting>(params), task);
}

}  // namespace

TEST_CASE("vectorise__one_plane_a_segment_and_no_faces_where_there_is_none") {
  Segmentation segmentation = segmentation_of({wall(0), {{0, 0, 9}, {1, 0, 9}}, wall(5), wall(20)});
  segmentation.segments[3].type = PrimitiveType::kSphere;
  segmentation.segments[1].fit.plane.offset = kNaN;
  const auto planes = planes_of(segmentation, "{}", 1);
  REQUIRE(planes.size() == 4);
  CHECK(planes[1].faces.empty());
  CHECK(planes[3].faces.empty());
  for (const size_t s : {size_t{0}, size_t{2}}) {
    CHECK(planes[s].label == s + 1);
    REQUIRE(planes[s].faces.size() == 1);
    const VectorFace& face = planes[s].faces[0];
    REQUIRE(face.openings.size() == 1);
    CHECK(is_sound(face, 0.001));
    CHECK(area(face) == doctest::Approx(3 * 2.5 - 1).epsilon(0.02).scale(0));
    CHECK(signed_area(face.openings[0]) == doctest::Approx(-1).epsilon(0.05));
    const Vec3 corner = planes[s].frame.lift(face.outline.corners[0]);
    CHECK(std::fabs(segmentation.segments[s].fit.plane.distance(corner)) < 1e-9);
  }
  CHECK(planes_of(segmentation_of({}), "{}", 1).empty());
}

TEST_CASE("vectorise__gives_the_same_bits_for_any_number_of_threads") {
  const Segmentation segmentation = segmentation_of({wall(0), wall(0.4)});
  const auto one = planes_of(segmentation, "{}", 1), many = planes_of(segmentation, "{}", 5);
  for (size_t s = 0; s < one.size(); ++s) {
    REQUIRE(one[s].faces.size() == many[s].faces.size());
    CHECK(one[s].spacing_m == many[s].spacing_m);
    for (size_t f = 0; f < one[s].faces.size(); ++f) {
      CHECK(one[s].faces[f].outline.corners == many[s].faces[f].outline.corners);
      REQUIRE(one[s].faces[f].openings.size() == many[s].faces[f].openings.size());
      for (size_t k = 0; k < one[s].faces[f].openings.size(); ++k)
        CHECK(one[s].faces[f].openings[k].corners == many[s].faces[f].openings[k].corners);
    }
  }
}

TEST_CASE("vectorise__not_straightened_the_corners_are_points_of_the_cloud") {
  const Segmentation segmentation = segmentation_of({wall(0)});
  const auto planes = planes_of(segmentation, "{\"straighten\":false}", 1);
  REQUIRE(planes[0].faces.size() == 1);
  std::set<std::pair<double, double>> places;
  for (size_t i = 0; i < segmentation.cloud->size(); ++i) {
    const Vec2 p = planes[0].frame.project(segmentation.cloud->point(i));
    places.insert({p.u, p.v});
  }
  const auto& ring = planes[0].faces[0].outline;
  CHECK(ring.corners.size() > 100);
  for (const Vec2& p : ring.corners) CHECK(places.count({p.u, p.v}) == 1);
}

TEST_CASE("vectorise__a_label_without_a_segment_is_an_error") {
  Segmentation segmentation = segmentation_of({wall(0), wall(5)});
  segmentation.segments.pop_back();
  CHECK_THROWS_AS(planes_of(segmentation, "{}", 1), Error);
}
