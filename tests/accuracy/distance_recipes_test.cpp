// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Distances between clouds at the sizes of Girardeau-Montaut 2006: tables 2.2 and 2.3, table 8 of annex E, the cooling
// tower of 5.3.2; and the exact search against brute force.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>

#include "base/random.h"
#include "compare/distance/distance.h"
#include "compare/preview/preview.h"
#include "recipe.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CloudPtr cloud_of(const std::vector<double>& xyz) {
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  return std::make_shared<const Cloud>(make_cloud(std::move(buffer)));
}

// Rolling ground of 60 m x 40 m as a scanner at its edge samples it, a heap on it on some days; 6 mm noise.
CloudPtr earthworks(size_t points, uint64_t day, bool with_heap) {
  RandomStream random(day, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < points; ++i) {
    const double range = 3 * std::pow(20.0, random.uniform()),
                 turn = std::numbers::pi * random.uniform();
    const double x = range * std::cos(turn), y = range * std::sin(turn);
    const double apart2 = (x - 8) * (x - 8) + (y - 12) * (y - 12);
    const double heap = with_heap ? std::max(0.0, 1 - apart2 / 2.25) : 0;
    const double z = 0.5 * std::sin(0.3 * x) * std::cos(0.2 * y) + heap;
    for (const double c : {x, y, z}) xyz.push_back(c + 0.006 * random.normal());
  }
  return cloud_of(xyz);
}

// Processor seconds on one thread of the best of three runs, on clouds without an index.
template <class Run>
double seconds_of(const CloudPtr& reference, const CloudPtr& compared, Run run) {
  double best = 1e9;
  for (int turn = 0; turn < 3; ++turn) {
    Cloud a = *reference, b = *compared;
    a.index = std::make_shared<IndexSlot>();
    b.index = std::make_shared<IndexSlot>();
    const auto fresh_a = std::make_shared<const Cloud>(std::move(a));
    const auto fresh_b = std::make_shared<const Cloud>(std::move(b));
    Task::Hooks hooks;
    hooks.threads = 1;
    Task task(hooks);
    const std::clock_t start = std::clock();
    run(fresh_a, fresh_b, task);
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

struct Row {
  size_t reference, compared;
  double printed_s;
};

// Sum over the rows; both indexes included, which the printed times are without.
double total_seconds(std::span<const Row> rows, const char* table,
                     const DistanceSettings& settings) {
  double sum = 0, printed = 0;
  for (const Row& row : rows) {
    const auto reference = earthworks(row.reference, 1, false),
               compared = earthworks(row.compared, 2, true);
    const double s =
        seconds_of(reference, compared, [&](const CloudPtr& a, const CloudPtr& b, Task& task) {
          compare_distance(a, b, settings, task);
        });
    MESSAGE("FIGURE " << std::string(table) << ": " << row.reference << " / " << row.compared
                      << " points " << s << " s, printed " << row.printed_s << " s, "
                      << row.printed_s / s << " x faster");
    sum += s;
    printed += row.printed_s;
  }
  MESSAGE("FIGURE " << std::string(table) << " in all: " << printed / sum
                    << " x faster than printed, one thread, indexes included");
  return sum;
}

// A strip of the shell (of a cooling tower; Girardeau-Montaut 2006, 5.3.2): 260 points a square
// metre, at a normal offset that varies along it.
std::vector<double> tower(size_t points, uint64_t seed, double noise_m, double offset_m) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  const auto radius = [](double z) { return 35 * std::sqrt(1 + (z - 135) * (z - 135) / 8100); };
  const double height = 20;
  const double sector = static_cast<double>(points) / 260 / height / radius(60);
  for (size_t i = 0; i < points; ++i) {
    const double z = 50 + height * random.uniform(), theta = sector * random.uniform();
    const double r = radius(z), slope = 35 * 35 * (z - 135) / 8100 / r;  // dr / dz
    const double out =
        noise_m * random.normal() + offset_m * std::numbers::sqrt2 * std::sin(0.9 * z);
    const double across = out / std::sqrt(1 + slope * slope);
    xyz.insert(xyz.end(), {(r + across) * std::cos(theta), (r + across) * std::sin(theta),
                           z - across * slope});
  }
  return xyz;
}

}  // namespace

TEST_CASE("T4_T5__distances_between_clouds_at_least_30_times_faster_than_printed") {
  if (std::getenv("JALON_SANITIZED") != nullptr) return;
  const Row plain[] = {{177171, 171380, 1.83},
                       {220931, 171380, 5.58},
                       {764665, 177171, 4.32},
                       {220931, 177171, 5.14},
                       {177171, 764665, 16.91}};
  CHECK(total_seconds(plain, "T4", {}) < (1.83 + 5.58 + 4.32 + 5.14 + 16.91) / 30);
  // Row 1 of T5 contradicts T4.
  const Row modelled[] = {{609804, 837125, 29.47}, {146352, 292389, 10.46}};
  const DistanceSettings delaunay{.local_model = LocalModelKind::kDelaunay};
  CHECK(total_seconds(modelled, "T5 Delaunay", delaunay) < (29.47 + 10.46) / 30);
}

TEST_CASE("T9__previews_and_nearest_points_at_least_30_times_faster_than_printed") {
  if (std::getenv("JALON_SANITIZED") != nullptr) return;
  struct Set {
    size_t reference, compared;
    double octrees, mean, angle, recursive, nearest;
    int level;
  } const sets[] = {{170000, 765000, 1.25, 2.21, 0.11, 0.47, 7.07, 5},
                    {850000, 612000, 1.76, 14.97, 0.19, 1.33, 21.38, 6}};
  double sum = 0, printed = 0;
  for (const Set& set : sets) {
    const auto reference = earthworks(set.reference, 1, false),
               compared = earthworks(set.compared, 2, true);
    using Measure = PreviewSettings::Measure;
    const auto preview = [&](const PreviewSettings& settings) {
      return seconds_of(reference, compared, [&](const CloudPtr& a, const CloudPtr& b, Task& task) {
        compare_preview(a, b, settings, task);
      });
    };
    const double octrees =
        seconds_of(reference, compared, [&](const CloudPtr& a, const CloudPtr& b, Task& task) {
          a->octree(task);
          b->octree(task);
        });
    const double mean = preview({Measure::kMean, set.level}),
                 angle = preview({Measure::kPlaneAngle, set.level}),
                 recursive = preview({Measure::kPlaneAngle, set.level, 10});
    const double nearest =
        seconds_of(reference, compared, [&](const CloudPtr& a, const CloudPtr& b, Task& task) {
          compare_distance(a, b, {}, task);
        });
    MESSAGE("FIGURE T9 " << set.reference << " / " << set.compared << ", s (printed): octrees "
                         << octrees << " (" << set.octrees << "), beyond them mean "
                         << mean - octrees << " (" << set.mean << "), angle of planes "
                         << angle - octrees << " (" << set.angle << "), recursive "
                         << recursive - octrees << " (" << set.recursive << "), nearest "
                         << nearest - octrees << " (" << set.nearest << ")");
    sum += octrees + mean + angle + recursive + nearest -
           4 * octrees;  // each preview and search built both again
    printed += set.octrees + set.mean + set.angle + set.recursive + set.nearest;
  }
  MESSAGE("FIGURE T9 in all: " << printed / sum << " x faster than printed, one thread");
  CHECK(sum < printed / 30);
}

// Octree spec 9 (7): noise of 1 and 2.5 cm and offsets of 1.41 cm make a normal difference of 3.04 cm.
TEST_CASE("tower__plain_distances_are_biased_by_sampling_and_local_models_are_not") {
  const size_t points = is_full() ? 2000000 : 150000;
  const auto reference = cloud_of(tower(points, 1, 0.01, 0)),
             compared = cloud_of(tower(points, 2, 0.025, 0.0141));
  Task task;
  const auto shares = [&](const char* name, LocalModelKind model) {
    const Comparison made = compare_distance(reference, compared, {.local_model = model}, task);
    double below5 = 0, below10 = 0;
    for (const double d : made.points.require("distance").values<double>()) {
      below5 += d < 0.05;
      below10 += d < 0.10;
    }
    const double mean = made.summary.require("mean").number(0);
    const auto n = static_cast<double>(points);
    MESSAGE("FIGURE tower, local model " << std::string(name) << ": mean " << 100 * mean << " cm, "
                                         << 100 * below5 / n << " % below 5 cm, "
                                         << 100 * below10 / n << " % below 10 cm");
    return std::array{mean, below5 / n, below10 / n};
  };
  const auto plain = shares("none", LocalModelKind::kNone);
  CHECK((plain[0] > 0.03 && plain[0] < 0.045));
  for (const auto& [name, model] : {std::pair{"plane", LocalModelKind::kPlane},
                                    {"delaunay", LocalModelKind::kDelaunay},
                                    {"quadric", LocalModelKind::kQuadric}}) {
    const auto modelled = shares(name, model);
    CHECK(modelled[0] < plain[0] - 0.01);
    CHECK(modelled[1] > 0.88);
    CHECK(modelled[2] >= 0.999);
  }
}

TEST_CASE("nearest_points__equal_brute_force_to_1e9_on_uneven_clouds") {
  const size_t points = is_full() ? 60000 : 6000;
  const auto reference = earthworks(points, 5, false), compared = earthworks(points, 6, true);
  Task task;
  const Comparison made = compare_distance(reference, compared, {}, task);
  const auto distance = made.points.require("distance").values<double>();
  double worst = 0;
  for (size_t i = 0; i < points; ++i) {
    const Vec3 p = compared->point(i);
    double least = 1e300;
    for (size_t j = 0; j < points; ++j)
      least = std::min(least, squared_norm(reference->point(j) - p));
    worst = std::max(worst, std::fabs(distance[i] / std::sqrt(least) - 1));
  }
  MESSAGE("FIGURE nearest points of " << points << ": within " << worst << " of brute force");
  CHECK(worst < 1e-9);
}
