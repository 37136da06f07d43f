// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Doors and windows of three real facades: each labelled one against the openings and faces of the model. Labels tell
// how far the points of an opening reach, so extents are compared: the points of a window under a gable fill half.
#include <doctest/doctest.h>

#include <cstdlib>
#include <numeric>
#include <sstream>

#include "labelled_street.h"
#include "modelling/facade/facade.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"
#include "wall_figures.h"

namespace jalon::street_openings_test {

using namespace jalon::test;

namespace {

constexpr double kLeastArea_m2 = 0.5, kLeastIou = 0.6;
constexpr size_t kObjects = 26;
// What the chain reaches today with the worst of 20 seeds: street_1 7 of 8 (8 with 19 seeds), street_3 5 of 9 (7 or 8
// with 17), building_2 8 of 9 (9 with 9 seeds).
constexpr size_t kLeastOfOneSeed = 20;
constexpr uint64_t kShortRun[] = {1, 4, 7};

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

RingBox box_of(const Region& region) {
  const Extent2 extent = extent_of(region);
  return {extent.low, extent.high};
}

struct Count {
  size_t objects = 0, found = 0;
  Count& operator+=(const Count& o) {
    objects += o.objects, found += o.found;
    return *this;
  }
};

Count count_found(const std::string& file, const LabelledStreet& street, uint64_t seed) {
  Task task;
  RansacSettings settings;
  settings.draw.seed = seed;
  const Segmentation planes = segment_ransac(street.cloud, settings, task);
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
      const double iou = overlap(box_of(candidate.region), box_of(opening.region));
      if (iou > best)
        best = iou, what = candidate.part_class + " " + text_of_extent(candidate.region);
    }
    ++out.objects;
    out.found += best >= kLeastIou;
    table << "\n  " << (best >= kLeastIou ? "      " : "MISSED") << " " << opening.part_class
          << ", " << text_of_extent(opening.region) << ": IoU " << best << " by " << what;
  }
  MESSAGE("FIGURE " << file << ", seed " << seed << ": " << out.found << " of " << out.objects
                    << " doors and windows" << table.str());
  return out;
}

}  // namespace

TEST_CASE("street__labelled_doors_and_windows_have_an_opening_or_a_face") {
  const char* const files[] = {"street_1.txt", "street_3.txt", "building_2.txt"};
  std::vector<uint64_t> seeds(std::begin(kShortRun), std::end(kShortRun));
  if (std::getenv("JALON_FULL") != nullptr) {
    seeds.resize(20);
    std::iota(seeds.begin(), seeds.end(), 1);
  }
  std::vector<LabelledStreet> streets;
  for (const char* file : files) {
    streets.emplace_back(file);
    if (streets.back().cloud != nullptr) continue;
    if (std::getenv("CI") != nullptr) FAIL("JALON_SHARED_DATA holds no facades");
    MESSAGE("skipped: no " << file << " in " << JALON_SHARED_DATA << "/facades");
    return;
  }
  Count all;
  for (const uint64_t seed : seeds) {
    CAPTURE(seed);
    Count one;
    for (size_t i = 0; i < streets.size(); ++i) one += count_found(files[i], streets[i], seed);
    CHECK(one.objects == kObjects);
    CHECK(one.found >= kLeastOfOneSeed);
    all += one;
  }
  MESSAGE("FIGURE street_1, street_3 and building_2, "
          << seeds.size() << " seeds: " << all.found << " of " << all.objects << " with an IoU of "
          << kLeastIou);
}

}  // namespace jalon::street_openings_test
