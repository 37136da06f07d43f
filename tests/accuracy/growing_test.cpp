// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "region_growing" on a street scanned from two tripods, against the true planes of the model.
#include <doctest/doctest.h>

#include <cstdlib>
#include <map>

#include "chain.h"
#include "segment/growing_settings.h"

namespace jalon::growing_test {

using namespace jalon::test;

namespace {

// 1.3 million points; under the sanitizers 330 000.
constexpr double kStep_rad = 0.004, kSanitizedStep_rad = 0.008;
constexpr double kMergeGap_m =
    3;  // one plane of glass a facade: its windows stand up to 2.6 m apart
constexpr uint64_t kLeastPoints = 500;
constexpr double kLeastArea_m2 = 2;  // ground, walls, glass and boxes; no reveals
constexpr double kLargestAngle_deg = 0.05, kLargestShift_m = 0.001, kSlanted_deg = 0.1;
// The worst are the roofs of boxes, seen at a grazing angle in lines that lie farther apart than the points of one.
constexpr double kLeastCoverage = 0.85, kLeastPurity = 0.9;

bool coplanar(const Plane& a, const Plane& b) {
  const double cosine = dot(a.normal, b.normal);
  return std::abs(cosine) > 1 - 1e-12 &&
         std::abs(a.offset - (cosine > 0 ? b.offset : -b.offset)) < 1e-6;
}

/// The planes of the model: faces in one plane together, as the merge gap lets the segments be (sills of one row).
struct StreetTruth {
  std::vector<Plane> planes;
  std::map<uint32_t, size_t> plane_of;  ///< face id -> plane
  std::vector<double> areas_m2;         ///< largest of the ids in the plane

  explicit StreetTruth(const Model& model) {
    std::map<uint32_t, double> areas;
    for (const Face& face : model.faces) {
      areas[face.id] += face.area_m2;
      if (plane_of.count(face.id) != 0) continue;
      const auto same = std::find_if(planes.begin(), planes.end(),
                                     [&](const Plane& p) { return coplanar(p, face.plane); });
      plane_of[face.id] = static_cast<size_t>(same - planes.begin());
      if (same == planes.end()) planes.push_back(face.plane);
    }
    areas_m2.assign(planes.size(), 0);
    for (const auto& [id, area] : areas)
      areas_m2[plane_of[id]] = std::max(areas_m2[plane_of[id]], area);
  }
};

struct Counts {
  std::vector<uint64_t> of_plane;
  std::vector<std::map<size_t, uint64_t>>
      of_segment;  ///< points of each plane; the last index: of no plane
};

Counts count(const StreetTruth& truth, const Segmentation& s) {
  Counts counts{std::vector<uint64_t>(truth.planes.size() + 1, 0), {}};
  counts.of_segment.resize(s.segments.size());
  const auto faces = s.cloud->fields.require("face").values<uint32_t>();
  const auto labels = s.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i) {
    const auto found = truth.plane_of.find(faces[i]);
    const size_t plane = found == truth.plane_of.end() ? truth.planes.size() : found->second;
    ++counts.of_plane[plane];
    if (labels[i] != 0) ++counts.of_segment[labels[i] - 1][plane];
  }
  return counts;
}

struct Figures {
  size_t planes = 0, once = 0, on_curved = 0;
  double angle_deg = 0, shift_m = 0, coverage = 1, purity = 1, slant_deg = 0;
};

// Which plane most points of each segment are from.
std::vector<size_t> majorities(const Counts& counts) {
  std::vector<size_t> out;
  for (const auto& segment : counts.of_segment) {
    const auto most =
        std::max_element(segment.begin(), segment.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    out.push_back(most->first);
  }
  return out;
}

Figures judge(const StreetTruth& truth, const Segmentation& s) {
  const Counts counts = count(truth, s);
  const std::vector<size_t> majority = majorities(counts);
  Figures f;
  for (size_t row = 0; row < majority.size(); ++row) {
    if (majority[row] == truth.planes.size()) {
      ++f.on_curved;
      continue;
    }
    if (s.segments[row].fit.n < kLeastPoints)
      continue;  // reveals a hand wide: their own noise turns them
    f.slant_deg = std::max(f.slant_deg, angle_degrees(s.segments[row].fit.plane.normal,
                                                      truth.planes[majority[row]].normal));
  }
  for (size_t plane = 0; plane < truth.planes.size(); ++plane) {
    if (truth.areas_m2[plane] < kLeastArea_m2 || counts.of_plane[plane] < kLeastPoints) continue;
    ++f.planes;
    f.once += std::count(majority.begin(), majority.end(), plane) == 1;
    const auto row =
        static_cast<size_t>(std::find(majority.begin(), majority.end(), plane) - majority.begin());
    if (row == majority.size()) continue;
    const PlaneFit& fit = s.segments[row].fit;
    const auto own = static_cast<double>(counts.of_segment[row].at(plane));
    f.angle_deg =
        std::max(f.angle_deg, angle_degrees(fit.plane.normal, truth.planes[plane].normal));
    f.shift_m = std::max(f.shift_m, std::abs(truth.planes[plane].distance(fit.centroid)));
    f.coverage = std::min(f.coverage, own / static_cast<double>(counts.of_plane[plane]));
    f.purity = std::min(f.purity, own / static_cast<double>(fit.n));
  }
  return f;
}

}  // namespace

TEST_CASE("chain_growing__finds_every_plane_of_the_scanned_street_once_and_unslanted") {
  const int64_t seeds = std::getenv("JALON_FULL") != nullptr ? 20 : 2;
  const double step_rad =
      std::getenv("JALON_SANITIZED") != nullptr ? kSanitizedStep_rad : kStep_rad;
  Task task;
  const Model model = build_scene({.name = SceneName::kStreet}, task);
  const StreetTruth truth(model);
  for (int64_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    const StaticSettings scanner{.horizontal_step_rad = step_rad,
                                 .vertical_step_rad = step_rad,
                                 .outliers = 0.05,
                                 .seed = static_cast<uint64_t>(seed)};
    const auto cloud = std::make_shared<const Cloud>(scan_static(model, {}, scanner, task));
    GrowingSettings settings;
    settings.surface.merge_gap_m = kMergeGap_m;
    const Segmentation s = segment_region_growing(cloud, settings, task);
    const Figures f = judge(truth, s);
    MESSAGE("FIGURE street by region_growing, seed "
            << seed << ", " << cloud->size() << " points: " << f.once << " of " << f.planes
            << " once, worst angle " << f.angle_deg << " deg, shift " << 1000 * f.shift_m
            << " mm, coverage " << f.coverage << ", purity " << f.purity << "; "
            << s.segments.size() << " segments, worst slant " << f.slant_deg << " deg, "
            << f.on_curved << " on curved things");
    CHECK(f.planes >= 17);  // 20 at the full density
    CHECK(f.once == f.planes);
    CHECK(f.angle_deg <= kLargestAngle_deg);
    CHECK(f.shift_m <= kLargestShift_m);
    CHECK(f.coverage >= kLeastCoverage);
    CHECK(f.purity >= kLeastPurity);
    CHECK(f.slant_deg <= kSlanted_deg);
  }
}

}  // namespace jalon::growing_test
