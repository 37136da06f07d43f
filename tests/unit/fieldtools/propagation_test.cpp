// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/propagation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "fieldtools/gradient.h"
#include "fieldtools/smoothing.h"
#include "unit/compare/pebble.h"

namespace jalon {
namespace {

using namespace test;

std::vector<double> values(const Cloud& cloud, const char* name) {
  Task task;
  return scalar_values(cloud, name, task);
}

/// Gradient and its Gaussian mean, as the source chains them.
Cloud with_smooth_gradient(const Cloud& cloud, const char* method, double radius_m, double sigma_m,
                           Task& task) {
  auto gradient = settings_by<GradientSettings>(gradient_rows(), {{"method", method}});
  gradient.radius_m = radius_m;
  FieldFilterSettings blur;
  blur.name = "smooth";
  blur.sigma_m = sigma_m;
  return with_filtered_field(with_gradient(cloud, "distance", gradient, task), "gradient", blur,
                             task);
}

PropagationResult segment(const Cloud& cloud, const PropagationSettings& set, Task& task) {
  return segment_by_propagation(cloud, values(cloud, "distance"), values(cloud, "smooth"), set,
                                task);
}

TEST_CASE("propagation__pebble__the_front_jumps_at_the_rim") {
  // Figures 3.20 and 3.21: with alpha = 50 the arrival time leaps near node 600; at constant speed it rises steadily.
  constexpr double kCell = 0.0045;
  const Pebble p = pebble(0, 1);
  Task task;
  const Cloud cloud = with_smooth_gradient(p.cloud, "thesis", 0.003, 0.0015, task);
  const auto deviations = values(cloud, "distance"), smooth = values(cloud, "smooth");
  const Buffer<double> xyz = relative_coordinates(cloud, task);
  const SurfaceCells cells = surface_cells({xyz.data(), xyz.size()}, kCell, task);
  std::vector<double> gradient(cells.size());
  size_t pebble_cells = 0;
  uint32_t top = 0;
  for (uint32_t c = 0; c < cells.size(); ++c) {
    bool on = false;
    for (const uint32_t i : cells.points(c)) {
      gradient[c] += smooth[i] / static_cast<double>(cells.points(c).size());
      on = on || p.on_pebble[i];
      if (deviations[i] == *std::max_element(deviations.begin(), deviations.end())) top = c;
    }
    pebble_cells += on;
  }
  for (const double alpha : {50.0, 0.0}) {
    Propagation propagation(cells, gradient, {.alpha = alpha, .jump = 1e300});
    const FrontRegion all = propagation.spread(top, task);
    REQUIRE(all.arrivals.size() == cells.size());
    // The first step that takes longer than 100 cells, and the largest before it.
    size_t jump = 0;
    double largest_before = 0, leap = 0;
    for (size_t n = 1; n < all.arrivals.size() && jump == 0; ++n) {
      const double step = (all.arrivals[n].time_m - all.arrivals[n - 1].time_m) / kCell;
      if (step > 100) {
        jump = n;
        leap = step;
      } else {
        largest_before = std::max(largest_before, step);
      }
    }
    MESSAGE("FIGURE S5, alpha ", alpha, ": jump of ", leap, " cells at node ", jump, " of ",
            cells.size(), " (about 600; cells with pebble points: ", pebble_cells,
            "); largest step before: ", largest_before);
    if (alpha > 0) {
      CHECK(jump > 540);
      CHECK(jump < 660);
      CHECK(leap > 5 * largest_before);
    } else {
      CHECK(jump == 0);
      CHECK(largest_before <= 1);
    }
  }
}

TEST_CASE("propagation__pebble__one_region_that_is_the_pebble") {
  for (const double noise_m : {0.0, 0.0002}) {
    for (const char* scope : {"front", "step"}) {
      const Pebble p = pebble(noise_m, 2);
      Task task;
      const Cloud cloud = with_smooth_gradient(p.cloud, "corrected", 0.003, 0.002, task);
      auto set = settings_by<PropagationSettings>(propagation_rows(), {{"scope", scope}});
      set.cell_m = 0.0045;
      const PropagationResult found = segment(cloud, set, task);
      uint64_t both = 0, region = 0, truth = 0;
      for (size_t i = 0; i < p.on_pebble.size(); ++i) {
        region += found.labels[i] == 1;
        truth += p.on_pebble[i];
        both += found.labels[i] == 1 && p.on_pebble[i];
      }
      MESSAGE("FIGURE S5, noise ", 1000 * noise_m, " mm, scope ", std::string(scope), ": ",
              found.regions.at(0)->count(), " regions; the largest has ", region,
              " points, the pebble ", truth, ", both ", both);
      // Gradients are means over balls: a region ends about one radius inside the rim.
      CHECK(static_cast<double>(both) > 0.85 * static_cast<double>(truth));
      CHECK(static_cast<double>(both) > 0.99 * static_cast<double>(region));
    }
  }
}

TEST_CASE("propagation__numbers_by_size_threads_and_shift__the_same_bits") {
  const Pebble p = pebble(0.0003, 3);
  std::vector<Vec3> far;
  for (size_t i = 0; i < p.cloud.size(); ++i) far.push_back(p.cloud.point(i) + kFar);
  const Cloud moved =
      with_field<double>(cloud_of(far), "distance", "m", "", values(p.cloud, "distance"));
  Task one(threads(1)), seven(threads(7));
  const PropagationSettings set{};
  const PropagationResult a =
      segment(with_smooth_gradient(p.cloud, "corrected", 0, 0, one), set, one);
  const PropagationResult b =
      segment(with_smooth_gradient(p.cloud, "corrected", 0, 0, seven), set, seven);
  const PropagationResult c =
      segment(with_smooth_gradient(moved, "corrected", 0, 0, one), set, one);
  CHECK(a.labels == b.labels);
  CHECK(a.labels == c.labels);
  const auto points = a.regions.require("points").values<uint64_t>();
  CHECK(std::is_sorted(points.begin(), points.end(), std::greater<>()));
  CHECK(a.labels[a.regions.require("seed").values<uint64_t>()[0]] == 1);
}

TEST_CASE("propagation__nothing_to_work_on__a_status") {
  Task task;
  const PropagationSettings set{};
  const Cloud cloud = cloud_of(random_points(100, 1, 5));
  const std::vector<double> nan(100, std::nan("")), flat(100, 1.0), none(100, 0.0);
  CHECK(status_of([&] { segment_by_propagation(cloud, nan, flat, set, task); }) ==
        Status::kInsufficientData);
  CHECK(status_of([&] { segment_by_propagation(cloud, flat, nan, set, task); }) ==
        Status::kInsufficientData);
  CHECK(status_of([&] { segment_by_propagation(cloud, flat, none, set, task); }) ==
        Status::kDegenerate);
  PropagationSettings high = set;
  high.minimum_seed = 5;
  CHECK(segment_by_propagation(cloud, flat, none, high, task).regions.at(0)->count() == 0);
}

}  // namespace
}  // namespace jalon
