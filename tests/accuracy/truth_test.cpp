// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <sstream>

#include "chain.h"

namespace jalon::truth_test {

using namespace jalon::test;

namespace {

constexpr double kFacadeStep_rad = 0.0016;  // the default: more than 500 000 points
constexpr double kLeastArea_m2 = 2;
constexpr double kLargestAngle_deg = 0.05, kLargestShift_m = 0.002, kLargestEdge_m = 0.03;
// A perpendicular plane of depth D may take the strip of its neighbour within the tolerance: 25 mm / 0.15 m for the
// shallowest reveal (scene robbery).
constexpr double kLeastPurity = 1 - 0.025 / 0.15;
constexpr uint64_t kSeenPoints =
    500;  // faces turned away from all stations (the top of the cornice) have none

/// One chain for all cases: they look at it from several sides.
const SceneChain& facade() {
  static const SceneChain chain(SceneName::kFacade, kFacadeStep_rad, 1);
  return chain;
}

std::string name_of(const Model& scene, const Face& face) {
  const Part& part = scene.parts[face.part];
  return part.parent == kNoParent ? part.name : scene.parts[part.parent].name + " / " + part.name;
}

}  // namespace

TEST_CASE("chain_facade__finds_every_true_plane_of_2_m2_once_and_in_its_place") {
  const SceneChain& chain = facade();
  const auto truths = truth_of_segments(chain);
  const auto seen = points_of_faces(*chain.cloud);
  MESSAGE(chain.cloud->size() << " points, " << chain.segmentation.segments.size() << " segments");
  CHECK(chain.cloud->size() >= 500000);
  size_t planes = 0;
  std::ostringstream table;
  for (const Face& face : chain.scene.faces) {
    const auto points = seen.find(face.id);
    if (face.area_m2 < kLeastArea_m2 || points == seen.end() || points->second < kSeenPoints)
      continue;
    ++planes;
    CAPTURE(name_of(chain.scene, face));
    size_t found = 0;
    for (size_t s = 0; s < truths.size(); ++s) {
      if (truths[s].face != face.id) continue;
      ++found;
      const PlaneFit& fit = chain.segmentation.segments[s].fit;
      const double angle = angle_degrees(fit.plane.normal, face.plane.normal);
      const double shift = std::abs(face.plane.distance(fit.centroid));
      const double coverage =
          static_cast<double>(truths[s].own) / static_cast<double>(points->second);
      table << "\n  " << name_of(chain.scene, face) << ": " << truths[s].points << " points, angle "
            << angle << " deg, shift " << 1000 * shift << " mm, sigma " << 1000 * fit.sigma
            << " mm, purity " << truths[s].purity() << ", coverage " << coverage;
      CHECK(angle <= kLargestAngle_deg);
      CHECK(shift <= kLargestShift_m);
      CHECK(coverage >= 0.95);
      CHECK(truths[s].purity() >= 0.99);
    }
    CHECK(found == 1);
  }
  MESSAGE(planes << " true planes of 2 m2 and more" << table.str());
  CHECK(planes >= 8);
}

TEST_CASE("chain_facade__has_no_slanted_or_mixed_segment") {
  const SceneChain& chain = facade();
  const auto truths = truth_of_segments(chain);
  std::map<uint32_t, const Face*> faces;
  for (const Face& face : chain.scene.faces) faces[face.id] = &face;
  // The end of the plinth at a door lies in the plane of the door's reveal: together they are one surface.
  std::vector<uint64_t> coplanar(truths.size(), 0);
  const auto labels = chain.segmentation.labels->values<uint32_t>();
  const auto ids = chain.cloud->fields.require("face").values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;
    const Plane &a = faces.at(ids[i])->plane, &b = faces.at(truths[labels[i] - 1].face)->plane;
    if (dot(a.normal, b.normal) > 1 - 1e-12 && std::abs(a.offset - b.offset) < 1e-9)
      ++coplanar[labels[i] - 1];
  }
  double worst_angle = 0, worst_purity = 1;
  for (size_t s = 0; s < truths.size(); ++s) {
    CAPTURE(s);
    REQUIRE(faces.count(truths[s].face) == 1);
    const double angle = angle_degrees(chain.segmentation.segments[s].fit.plane.normal,
                                       faces[truths[s].face]->plane.normal);
    worst_angle = std::max(worst_angle, angle);
    const double purity = static_cast<double>(coplanar[s]) / static_cast<double>(truths[s].points);
    worst_purity = std::min(worst_purity, purity);
    CAPTURE(name_of(chain.scene, *faces[truths[s].face]));
    CAPTURE(truths[s].points);
    CHECK(
        angle <
        1);  // small reveals are noisier than walls; a plane through two surfaces is off by degrees
    CHECK(purity > kLeastPurity);
  }
  MESSAGE("worst angle of a segment " << worst_angle << " deg, worst purity " << worst_purity);
}

TEST_CASE("chain_facade__outlines_have_all_openings_in_their_places") {
  const SceneChain& chain = facade();
  const auto truths = truth_of_segments(chain);
  const Face* true_wall = nullptr;
  for (const Face& face : chain.scene.faces)
    if (chain.scene.parts[face.part].part_class == "wall") true_wall = &face;
  REQUIRE(true_wall != nullptr);
  const Face* wall = nullptr;
  for (const Face& face : chain.outlines.faces)
    if (face.id >= 1 && truths[face.id - 1].face == true_wall->id &&
        (wall == nullptr || face.area_m2 > wall->area_m2))
      wall = &face;
  REQUIRE(wall != nullptr);

  const auto& scene = chain.scene;
  std::vector<Frontal> modelled;
  for (uint64_t r = 1; r < wall->ring_count; ++r)
    modelled.push_back(frontal(chain.outlines, chain.outlines.rings[wall->first_ring + r]));
  CHECK(wall->ring_count == true_wall->ring_count);
  double worst = 0, sum = 0;
  for (uint64_t r = 1; r < true_wall->ring_count; ++r) {
    const Frontal truth = frontal(scene, scene.rings[true_wall->first_ring + r]);
    double best = 1e9;
    for (const Frontal& m : modelled)
      best = std::min(best,
                      std::max({std::abs(m.left - truth.left), std::abs(m.right - truth.right),
                                std::abs(m.bottom - truth.bottom), std::abs(m.top - truth.top)}));
    CHECK(best <= kLargestEdge_m);
    worst = std::max(worst, best);
    sum += best;
  }
  MESSAGE(modelled.size() << " openings of " << true_wall->ring_count - 1
                          << "; largest edge error: mean "
                          << 1000 * sum / static_cast<double>(true_wall->ring_count - 1)
                          << " mm, worst " << 1000 * worst << " mm");
  const Frontal outline = frontal(chain.outlines, chain.outlines.rings[wall->first_ring]);
  const Frontal true_outline = frontal(scene, scene.rings[true_wall->first_ring]);
  MESSAGE("outline " << outline.left << " ... " << outline.right << " x " << outline.bottom
                     << " ... " << outline.top);
  CHECK(std::abs(outline.left - true_outline.left) <= kLargestEdge_m);
  CHECK(std::abs(outline.right - true_outline.right) <= kLargestEdge_m);
  CHECK(std::abs(outline.bottom - true_outline.bottom) <= kLargestEdge_m);
  CHECK(std::abs(outline.top - true_outline.top) <= kLargestEdge_m);
  MESSAGE("area " << wall->area_m2 << " m2, true " << true_wall->area_m2 << " m2");
  CHECK(std::abs(wall->area_m2 - true_wall->area_m2) <= 0.01 * true_wall->area_m2);
}

}  // namespace jalon::truth_test
