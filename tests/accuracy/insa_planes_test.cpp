// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The facade of INSA Strasbourg (Boulaassal 2010, 5.5.3.2) as a scene, 200 000 points from
// four tripods with the noise of a Trimble GX.
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>

#include "chain.h"
#include "scan/truth.h"
#include "segment/evaluation/evaluation.h"
#include "segment/labels/from_labels.h"

namespace jalon::insa_planes_test {

using namespace jalon::test;

namespace {

constexpr double kTruthMinArea_m2 = 0.05;
constexpr double kStep_rad = 0.0022;  // some 230 000 points, thinned to the recipe's
constexpr uint64_t kPoints = 200'000;
constexpr double kMisfit_m = 0.004;  // recipe: 3-5 mm between stations
constexpr double kLarge_m2 = 20;
constexpr double kLargeAngle_deg = 0.05, kLargeShift_m = 0.002;
constexpr double kOwnPointsFactor = 1.2;
constexpr double kChiSquare99 = 11.345;               // 3 degrees of freedom
constexpr double kLeastInside = 0.97;                 // over 20 seeds
constexpr double kLeastInsideOfFew = 0.947;           // three standard errors less, for one seed
constexpr double kLeastTdr = 0.97, kLeastTda = 0.94;  // of the thesis: over paired planes alone
// Unmatched planes as 0: what the segmenter reaches today (0.912 and 0.961 of seeds 1 and 2), less 0.01.
constexpr double kLeastDetection = 0.90, kLeastAccuracy = 0.95;

bool full() { return std::getenv("JALON_FULL") != nullptr; }

struct Insa {
  Model scene;
  Truth truth;
  std::vector<ScanStation> stations;

  Insa() {
    Task task;
    scene = build_scene({.name = SceneName::kInsaSurveyed}, task);
    truth = find_truth(scene, kTruthMinArea_m2, task);
    for (const double x : {5.0, 25.0, 45.0, 63.0}) {
      ScanStation station;
      station.pose.m[3] = x, station.pose.m[7] = -30, station.pose.m[11] = 1.7;
      stations.push_back(station);
    }
  }

  CloudPtr scan(uint64_t seed, double misfit_m) const {
    Task task;
    const StaticSettings scanner{.horizontal_step_rad = kStep_rad,
                                 .vertical_step_rad = kStep_rad,
                                 .instrument = StaticSettings::Instrument::kGx,
                                 .misfit_shift_m = misfit_m,
                                 .max_points = kPoints,
                                 .seed = seed};
    return std::make_shared<const Cloud>(scan_static(scene, stations, scanner, task));
  }
};

// Panes are 0.30 m apart at a point spacing of 0.10 m: pixels of 1.5 spacings tell them apart, and no gap is bridged.
Segmentation segment(const CloudPtr& cloud) {
  Task task;
  RansacSettings settings;
  settings.surface.gap_m = settings.surface.merge_gap_m = 0;
  settings.surface.pixel_m = 0.15;
  return segment_ransac(cloud, settings, task);
}

// The true plane that most points of each segment belong to; 0 = none.
std::vector<uint32_t> true_planes_of(const Segmentation& s) {
  const auto labels = s.labels->values<uint32_t>();
  const auto ids = s.cloud->fields.require("segment").values<uint32_t>();
  std::vector<std::map<uint32_t, uint64_t>> counts(s.segments.size());
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0) ++counts[labels[i] - 1][ids[i]];
  std::vector<uint32_t> out;
  for (const auto& count : counts) {
    const auto most = [](const auto& a, const auto& b) { return a.second < b.second; };
    out.push_back(std::max_element(count.begin(), count.end(), most)->first);
  }
  return out;
}

// Squared distance of the true plane in the covariance of slopes and height.
double chi_square(const PlaneFit& fit, const Plane& truth) {
  const double sign = dot(truth.normal, fit.plane.normal) < 0 ? -1 : 1;
  const Vec3 turn = fit.plane.normal - sign * truth.normal;
  const Vec3 y{-dot(turn, fit.axis_u), -dot(turn, fit.axis_v),
               -sign * truth.distance(fit.centroid)};
  const Symmetric3& c = fit.local_covariance;
  const Vec3 rows[3] = {{c[0], c[1], c[2]}, {c[1], c[3], c[4]}, {c[2], c[4], c[5]}};
  const double determinant = dot(rows[0], cross(rows[1], rows[2]));
  const Vec3 x{dot(y, cross(rows[1], rows[2])), dot(y, cross(rows[2], rows[0])),
               dot(y, cross(rows[0], rows[1]))};
  return dot(x, y) / determinant;
}

// Angle between a true plane and the least-squares plane of exactly its points: what their noise alone does.
double own_points_angle_deg(const Cloud& cloud, uint32_t id, const Plane& truth) {
  const auto ids = cloud.fields.require("segment").values<uint32_t>();
  std::vector<Vec3> own;
  for (size_t i = 0; i < ids.size(); ++i)
    if (ids[i] == id) own.push_back(cloud.point(i));
  PlaneFit fit;
  REQUIRE(fit_plane(own, fit));
  return angle_degrees(fit.plane.normal, truth.normal);
}

}  // namespace

TEST_CASE("chain_insa__planes_lie_within_their_covariance_and_large_ones_within_2_mm") {
  const Insa insa;
  const uint64_t seeds = full() ? 20 : 1;
  size_t cases = 0, inside = 0, large = 0, scraps = 0;
  double worst_deg = 0, worst_m = 0;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    const CloudPtr cloud = insa.scan(seed, 0);
    const Segmentation s = segment(cloud);
    const std::vector<uint32_t> ids = true_planes_of(s);
    std::map<uint32_t, size_t>
        segments_of;  // segments come largest first: the first of a plane is its largest part
    for (size_t row = 0; row < ids.size(); ++row) {
      if (ids[row] == kNoSegment) continue;
      const TruePlane& truth = insa.truth.planes[ids[row] - 1];
      const PlaneFit& fit = s.segments[row].fit;
      ++cases;
      inside += chi_square(fit, truth.plane) <= kChiSquare99;
      if (truth.area_m2 < kLarge_m2) continue;
      if (++segments_of[ids[row]] > 1) {
        ++scraps;
        continue;
      }
      CAPTURE(ids[row]);
      CAPTURE(truth.area_m2);
      const double angle = angle_degrees(fit.plane.normal, truth.plane.normal);
      const double shift = std::abs(truth.plane.distance(fit.centroid));
      // The cornice is 68 x 0.5 m: across it, least squares through exactly its own points is off by 0.035 degrees (one
      // standard error).
      CHECK(angle <=
            std::max(kLargeAngle_deg,
                     kOwnPointsFactor * own_points_angle_deg(*cloud, ids[row], truth.plane)));
      CHECK(shift <= kLargeShift_m);
      worst_deg = std::max(worst_deg, angle);
      worst_m = std::max(worst_m, shift);
      ++large;
    }
  }
  const double share = static_cast<double>(inside) / static_cast<double>(cases);
  CHECK(share >= (full() ? kLeastInside : kLeastInsideOfFew));
  CHECK(large == 4 * seeds);
  MESSAGE("FIGURE insa, " << seeds << " seeds: " << inside << " of " << cases << " planes ("
                          << share << ") within their 99 % covariance; " << large
                          << " of 20 m2 or more (" << scraps << " scraps), worst " << worst_deg
                          << " deg, " << 1000 * worst_m << " mm");
}

TEST_CASE(
    "chain_insa__with_misfit_between_stations_detection_and_accuracy_are_those_of_the_thesis") {
  const Insa insa;
  const uint64_t seeds = full() ? 20 : 1;
  double tdr = 0, tda = 0, detection = 0, accuracy = 0;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    Task task;
    const CloudPtr cloud = insa.scan(seed, kMisfit_m);
    const Segmentation automatic = segment(cloud);
    const Segmentation reference =
        segmentation_from_labels(cloud, "segment", LabelSettings{}, task);
    const EvaluationSettings settings{.min_points = 50};  // the segmenter's own
    const EvaluationTotals totals =
        evaluate_segmentation(automatic, reference, settings, task).totals;
    const auto share = 1 / static_cast<double>(seeds);
    tdr += share * totals.mean_tdr;
    tda += share * totals.mean_tda;
    detection += share * totals.detection;
    accuracy += share * totals.accuracy;
    CHECK(totals.pairs >= 400);  // of some 480 true planes with 50 points
    MESSAGE("FIGURE insa with misfit, seed "
            << seed << ": " << totals.pairs << " pairs, mean TDR " << totals.mean_tdr
            << ", mean TDA " << totals.mean_tda
            << "; with unmatched planes as 0: " << totals.detection << " of "
            << totals.pairs + totals.unmatched_reference << " true planes, " << totals.accuracy
            << " of " << totals.pairs + totals.unmatched_automatic << " found");
  }
  MESSAGE("FIGURE insa with misfit, " << seeds << " seeds: mean TDR " << tdr << ", mean TDA " << tda
                                      << "; with unmatched planes as 0: " << detection << ", "
                                      << accuracy);
  CHECK(tdr >= kLeastTdr);
  CHECK(tda >= kLeastTda);
  CHECK(detection >= kLeastDetection);
  CHECK(accuracy >= kLeastAccuracy);
}

}  // namespace jalon::insa_planes_test
