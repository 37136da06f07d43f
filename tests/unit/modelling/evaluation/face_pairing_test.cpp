// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Pairs of faces against all ways to pair them, with the areas of rectangles.
#include "modelling/evaluation/face_pairing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.h"

using namespace jalon;

namespace {

/// A level rectangle.
struct Plot {
  double x0, y0, x1, y1, z = 0;
  double area() const { return (x1 - x0) * (y1 - y0); }
  double shared(const Plot& b) const {
    return std::max(0.0, std::min(x1, b.x1) - std::max(x0, b.x0)) *
           std::max(0.0, std::min(y1, b.y1) - std::max(y0, b.y0));
  }
};

const FaceChoice kPlotChoice = [] {
  FaceChoice out;
  out.angle_rad = 0.05;
  out.distance_m = 0.1;
  return out;
}();

std::vector<ComparedFace> faces_on(const std::vector<Plot>& plots, double min_area_m2 = 0) {
  Model model;
  for (const Plot& p : plots)
    model.add_face({},
                   {{{p.x0, p.y0, p.z}, {p.x1, p.y0, p.z}, {p.x1, p.y1, p.z}, {p.x0, p.y1, p.z}}});
  FaceChoice choice = kPlotChoice;
  choice.min_area_m2 = min_area_m2;
  Task task;
  return compared_faces(model, {}, choice, task);
}

std::vector<FacePair> paired(const std::vector<Plot>& automatic, const std::vector<Plot>& reference,
                             double min_iou, const Vec3& shift = {}) {
  Task task;
  return pair_faces(faces_on(automatic), faces_on(reference), shift, kPlotChoice, min_iou, task);
}

/// Corners on whole millimetres, which the polygons' grid holds.
std::vector<Plot> random_plots(size_t n, uint64_t stream) {
  RandomStream random(111, stream);
  const auto length = [&](double low, double high) {
    return std::round(1000 * (low + (high - low) * random.uniform())) / 1000;
  };
  std::vector<Plot> out;
  for (size_t i = 0; i < n; ++i) {
    const double x = length(0, 3), y = length(0, 3);
    out.push_back({x, y, x + length(0.5, 3), y + length(0.5, 3)});
  }
  return out;
}

/// Largest sum of shared areas of all ways to pair, of pairs that reach the ratio.
double best_sum(const std::vector<Plot>& a, const std::vector<Plot>& r, double min_iou) {
  std::vector<size_t> order(a.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  double best = 0;
  do {
    double sum = 0;
    for (size_t i = 0; i < r.size(); ++i) {
      const double shared = a[order[i]].shared(r[i]);
      if (shared >= min_iou * (a[order[i]].area() + r[i].area() - shared)) sum += shared;
    }
    best = std::max(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

}  // namespace

TEST_CASE("face_pairing__shares_as_much_area_as_the_best_of_all_ways_to_pair") {
  for (uint64_t k = 0; k < 25; ++k)
    for (const double min_iou : {0.0, 0.25}) {
      const auto a = random_plots(5, 2 * k), r = random_plots(5, 2 * k + 1);
      const auto pairs = paired(a, r, min_iou);
      double sum = 0;
      std::set<uint32_t> used;
      for (size_t i = 0; i < pairs.size(); ++i) {
        const Plot &pa = a[pairs[i].automatic], &pr = r[pairs[i].reference];
        REQUIRE(used.insert(pairs[i].automatic).second);
        REQUIRE((i == 0 || pairs[i].reference > pairs[i - 1].reference));
        CHECK(std::fabs(pairs[i].areas.automatic_m2 - pa.area()) < 1e-9);
        CHECK(std::fabs(pairs[i].areas.reference_m2 - pr.area()) < 1e-9);
        REQUIRE(std::fabs(pairs[i].areas.intersection_m2 - pa.shared(pr)) < 1e-9);
        sum += pairs[i].areas.intersection_m2;
      }
      REQUIRE(std::fabs(sum - best_sum(a, r, min_iou)) < 1e-9);
    }
}

TEST_CASE("face_pairing__takes_no_faces_of_other_planes_too_little_shared_or_left_out") {
  const std::vector<Plot> one{{0, 0, 2, 1}};
  CHECK(paired(one, {{0, 0, 2, 1, 0.09}}, 0.1).size() == 1);
  CHECK(paired(one, {{0, 0, 2, 1, 0.09}}, 0.1)[0].distance_m == doctest::Approx(-0.09));
  CHECK(paired(one, {{0, 0, 2, 1, 0.11}}, 0.1).empty());
  CHECK(paired(one, {{2, 0, 4, 1}}, 0).empty());  // they only touch
  // 1 m2 of 3 m2.
  CHECK(paired(one, {{1, 0, 3, 1}}, 0.33).size() == 1);
  CHECK(paired(one, {{1, 0, 3, 1}}, 0.34).empty());
  Task task;
  const auto small = faces_on(one, 2.5), all = faces_on(one);
  CHECK(pair_faces(small, all, {}, kPlotChoice, 0.1, task).empty());
  CHECK(pair_faces(all, small, {}, kPlotChoice, 0.1, task).empty());
  CHECK(pair_faces({}, all, {}, kPlotChoice, 0.1, task).empty());
}

TEST_CASE("face_pairing__moves_the_automatic_faces_first") {
  const std::vector<Plot> a{{0, 0, 2, 1}, {10, 0, 12, 1, 5}},
      r{{5, 3, 7, 4, 5.25}, {-5, 3, -3, 4, 0.25}};
  CHECK(paired(a, r, 0.1).empty());
  const auto moved = paired(a, r, 0.99, {-5, 3, 0.25});
  REQUIRE(moved.size() == 2);
  CHECK(moved[0].automatic == 1);
  CHECK(moved[1].automatic == 0);
  for (const FacePair& pair : moved) {
    CHECK(pair.areas.intersection_m2 == doctest::Approx(2).epsilon(1e-9));
    CHECK(std::fabs(pair.distance_m) < 1e-12);
    CHECK(pair.angle_rad < 1e-12);
  }
}
