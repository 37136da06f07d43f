// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>

#include "../bench/street_points.h"
#include "chain.h"

namespace jalon::street_planes_test {

using namespace jalon::test;

namespace {

constexpr size_t kPoints = 1'000'000;
constexpr size_t kTruePlanes =
    28;  // the street's with at least kLeastPoints: ground, walls, glass, boxes
constexpr uint64_t kLeastPoints = 200;
constexpr double kLeastCoverage = 0.95;
constexpr double kBuildingAngle_deg = 0.005, kBuildingShift_m = 0.0002;
constexpr double kBoxAngle_deg = 0.05, kBoxShift_m = 0.001;
constexpr uint64_t kLargePoints = 1000;
constexpr double kSlanted_deg = 0.05;  // of large segments; false planes of other programs: 0.6-1.7
constexpr double kLeastPurity =
    0.75;  // share of a segment on one true plane or planes in line with it
constexpr double kOwnPointsFactor = 1.2;
constexpr double kMergeGap_m =
    3;  // one plane of glass a facade: its windows stand up to 1.9 m apart

enum class Kind { kBuilding, kBox, kReveal };

struct TruePlane {
  Vec3 normal;
  Vec3 centroid;
  uint64_t points = 0;
  Kind kind = Kind::kBuilding;  ///< ground, walls, glass
  Moments moments;              ///< of its own points, with their noise
  double own_points_deg = 0;    ///< error of the least-squares plane through them
};

bool coplanar(const TruePlane& a, const TruePlane& b) {
  return angle_degrees(a.normal, b.normal) < 0.001 &&
         std::abs(dot(a.normal, a.centroid - b.centroid)) < 0.0001;
}

Kind kind_of(const bench::Surface& surface) {
  constexpr double kDeepestReveal_m = 0.25, kLongestBox_m = 4.4, kHighestBox_m = 1.6;
  const auto [narrow, wide] = std::minmax(surface.length_u, surface.length_v);
  if (narrow <= kDeepestReveal_m) return Kind::kReveal;
  const bool in_the_street = std::abs(surface.origin.y) < 6;
  return in_the_street && wide <= kLongestBox_m && surface.origin.z <= kHighestBox_m
             ? Kind::kBox
             : Kind::kBuilding;
}

struct Street {
  CloudPtr cloud;
  std::vector<uint32_t> planes;  ///< of each point, 0 = curved or outlier
  std::map<uint32_t, TruePlane> truth;

  explicit Street(uint64_t seed) {
    const bench::Street street;
    const auto samples = bench::scan_street(street, kPoints, seed);
    Buffer<double> xyz(3 * samples.size());
    const std::vector<double> coordinates = bench::coordinates(samples);
    std::copy(coordinates.begin(), coordinates.end(), xyz.begin());
    for (size_t i = 0; i < samples.size(); ++i) {
      const bench::Sample& sample = samples[i];
      planes.push_back(sample.surface == bench::kOutlier ? 0
                                                         : street.surfaces[sample.surface].plane);
      if (planes.back() == 0) continue;
      const bench::Surface& surface = street.surfaces[sample.surface];
      const bench::Vec n = bench::turned(bench::cross(surface.u, surface.v));
      TruePlane& plane = truth[planes.back()];
      plane.normal = {n.x, n.y, n.z};
      // The point without its noise across the plane is not kept: any point of the surface gives the offset.
      const bench::Vec corner = bench::turned(surface.origin);
      const Vec3 p{coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
      const double off = dot(p - Vec3{corner.x, corner.y, corner.z}, plane.normal);
      plane.centroid += p - off * plane.normal;
      if (plane.points++ == 0) plane.moments.reference = p;
      plane.moments.add(p);
      if (plane.points == 1 || plane.kind == Kind::kReveal) plane.kind = kind_of(surface);
    }
    for (auto& [id, plane] : truth) {
      plane.centroid = plane.centroid / static_cast<double>(plane.points);
      PlaneFit fit;
      if (fit_plane(plane.moments, fit))
        plane.own_points_deg = angle_degrees(fit.plane.normal, plane.normal);
    }
    cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  }
};

/// A segment's relation to the truth.
struct Match {
  uint32_t plane = 0;  ///< of most of its points
  uint64_t points = 0, own = 0;
  uint64_t in_line = 0;  ///< on that plane or on others coplanar with it
};

std::vector<Match> matches(const Street& street, const Segmentation& s) {
  std::vector<std::map<uint32_t, uint64_t>> counts(s.segments.size());
  const auto labels = s.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0) ++counts[labels[i] - 1][street.planes[i]];
  std::vector<Match> out;
  for (const auto& count : counts) {
    Match match;
    for (const auto& [plane, points] : count) {
      match.points += points;
      if (points > match.own) match = {plane, match.points, points, 0};
    }
    for (const auto& [plane, points] : count)
      if (match.plane != 0 && plane != 0 &&
          coplanar(street.truth.at(plane), street.truth.at(match.plane)))
        match.in_line += points;
    out.push_back(match);
  }
  return out;
}

struct Worst {
  double building_deg = 0, building_m = 0, box_deg = 0, box_m = 0, coverage = 1, slant_deg = 0,
         purity = 1;
  size_t once = 0, planes = 0, on_no_plane = 0;
};

void check_plane(const TruePlane& truth, const Segmentation& s, size_t row, uint64_t own,
                 Worst& worst) {
  const PlaneFit& fit = s.segments[row].fit;
  const bool box = truth.kind == Kind::kBox;
  const double angle = angle_degrees(fit.plane.normal, truth.normal);
  const double shift = std::abs(dot(truth.centroid - fit.centroid, fit.plane.normal));
  const double coverage = static_cast<double>(own) / static_cast<double>(truth.points);
  double& worst_angle = box ? worst.box_deg : worst.building_deg;
  double& worst_shift = box ? worst.box_m : worst.building_m;
  worst_angle = std::max(worst_angle, angle);
  worst_shift = std::max(worst_shift, shift);
  worst.coverage = std::min(worst.coverage, coverage);
  // The farthest face of a box has some 430 points: least squares through exactly those is 0.06 degrees off in one draw
  // of ten. Nothing better can be asked of a plane found among others.
  CHECK(angle <= std::max(box ? kBoxAngle_deg : kBuildingAngle_deg,
                          box ? kOwnPointsFactor * truth.own_points_deg : 0));
  CHECK(shift <= (box ? kBoxShift_m : kBuildingShift_m));
  CHECK(coverage >= kLeastCoverage);
}

void check_true_planes(const Street& street, const Segmentation& s,
                       const std::vector<Match>& segments, Worst& worst) {
  worst.planes = worst.once = 0;
  for (const auto& named : street.truth) {
    const auto id = named.first;
    const auto& truth = named.second;
    // In some draws one or two of the 288 reveals have 200 points as well: they are not of the 28.
    if (truth.points < kLeastPoints || truth.kind == Kind::kReveal) continue;
    ++worst.planes;
    CAPTURE(id);
    CAPTURE(truth.points);
    size_t found = 0;
    for (size_t row = 0; row < segments.size(); ++row) {
      if (segments[row].plane != id) continue;
      if (++found == 1) check_plane(truth, s, row, segments[row].own, worst);
    }
    CHECK(found == 1);
    worst.once += found == 1;
  }
}

// No large segment is slanted, and none runs through surfaces that are not in one plane. Columns and the ball have
// faces of no plane: how many segments they leave is told.
void check_segments(const Street& street, const Segmentation& s, const std::vector<Match>& segments,
                    Worst& worst) {
  for (size_t row = 0; row < segments.size(); ++row) {
    const Match& match = segments[row];
    if (match.points < kLeastPoints) continue;
    if (match.plane == 0) {
      ++worst.on_no_plane;
      continue;
    }
    CAPTURE(row);
    CAPTURE(match.points);
    const double purity = static_cast<double>(match.in_line) / static_cast<double>(match.points);
    worst.purity = std::min(worst.purity, purity);
    CHECK(purity >= kLeastPurity);
    if (match.points < kLargePoints) continue;
    const double slant =
        angle_degrees(s.segments[row].fit.plane.normal, street.truth.at(match.plane).normal);
    worst.slant_deg = std::max(worst.slant_deg, slant);
    CHECK(slant <= kSlanted_deg);
  }
}

}  // namespace

TEST_CASE("chain_street__finds_the_28_true_planes_of_the_measured_street_once_and_unslanted") {
  Task task;
  const uint64_t seeds = std::getenv("JALON_FULL") != nullptr ? 20 : 2;
  Worst worst;
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    const Street street(seed);
    RansacSettings settings;
    settings.surface.merge_gap_m = kMergeGap_m;
    settings.draw.seed = seed;
    const Segmentation s = segment_ransac(street.cloud, settings, task);
    const std::vector<Match> segments = matches(street, s);
    check_true_planes(street, s, segments, worst);
    check_segments(street, s, segments, worst);
    CHECK(worst.planes == kTruePlanes);
    MESSAGE("FIGURE street, seed "
            << seed << ": " << worst.once << " of " << worst.planes << " once, "
            << s.segments.size() << " segments; worst so far: buildings " << worst.building_deg
            << " deg, " << 1000 * worst.building_m << " mm, boxes " << worst.box_deg << " deg, "
            << 1000 * worst.box_m << " mm, coverage " << worst.coverage << ", slant "
            << worst.slant_deg << " deg, purity " << worst.purity << "; " << worst.on_no_plane
            << " segments on curved things");
  }
}

}  // namespace jalon::street_planes_test
