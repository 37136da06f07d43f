// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Doors and windows of two real facades: each labelled one against the openings and faces of the model.
#include <doctest/doctest.h>

#include <cstdlib>
#include <sstream>

#include "labelled_street.h"
#include "modelling/facade/facade.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"
#include "wall_figures.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kLeastArea_m2 = 0.5, kLeastIou = 0.6, kRow_m = 0.002;
constexpr size_t kObjects = 17, kWanted = 14;

/// All that may stand for an opening: holes and faces that look as the wall does.
std::vector<Drawn> candidates(const Model& model, const WallAxes& axes) {
  constexpr double kParallel = 0.94;  // cosine of 20 degrees: leaves stand ajar
  std::vector<Drawn> out;
  for (const Face& face : model.faces) {
    if (std::fabs(dot(face.plane.normal, axes.n)) < kParallel) continue;
    for (uint64_t k = 0; k < face.ring_count; ++k) {
      const Ring& ring = model.rings[face.first_ring + k];
      out.push_back(drawn(model, ring, dot(face.plane.normal, axes.n) > 0, axes));
      const uint32_t part = k > 0 && ring.part != kNoPart ? ring.part : face.part;
      out.back().part_class = (k > 0 ? "hole of " : "face of ") + model.parts[part].name + " (" +
                              model.parts[part].part_class + ")";
    }
  }
  return out;
}

struct Count {
  size_t objects = 0, found = 0;
};

Count count_found(const std::string& file) {
  const LabelledStreet street(file);
  if (street.cloud == nullptr) {
    if (std::getenv("CI") != nullptr) FAIL("the real scans are not on this machine");
    MESSAGE("skipped: the real scans are not on this machine");
    return {kObjects, kWanted};
  }
  Task task;
  const Segmentation planes = segment_ransac(street.cloud, RansacSettings{}, task);
  const Model model = model_facade(planes, FacadeSettings{}, task);
  const WallAxes axes(planes.segments[0].fit.plane, planes.segments[0].fit.centroid);
  const std::vector<Drawn> found = candidates(model, axes);
  Count out;
  std::ostringstream table;
  table.precision(2);
  table << std::fixed;
  for (const Drawn& opening : street.openings(axes, kLeastArea_m2)) {
    double best = 0;
    std::string what = "nothing";
    for (const Drawn& candidate : found) {
      if (!extent_of(candidate.region).meets(extent_of(opening.region))) continue;
      const double iou = areas(candidate.region, opening.region, kRow_m).iou();
      if (iou > best)
        best = iou, what = candidate.part_class + " " + text_of_extent(candidate.region);
    }
    ++out.objects;
    out.found += best >= kLeastIou;
    table << "\n  " << (best >= kLeastIou ? "      " : "MISSED") << " " << opening.part_class
          << ", " << text_of_extent(opening.region) << ": IoU " << best << " by " << what;
  }
  MESSAGE("FIGURE " << file << ": " << out.found << " of " << out.objects << " doors and windows"
                    << table.str());
  return out;
}

}  // namespace

TEST_CASE("street__labelled_doors_and_windows_have_an_opening_or_a_face") {
  const Count one = count_found("street_1.txt"), three = count_found("street_3.txt");
  MESSAGE("FIGURE street_1 and street_3: " << one.found + three.found << " of "
                                           << one.objects + three.objects << " with an IoU of "
                                           << kLeastIou);
  CHECK(one.objects + three.objects == kObjects);
  CHECK(one.found + three.found >= kWanted);
}
