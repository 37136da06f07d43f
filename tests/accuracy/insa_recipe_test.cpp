// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The whole chain on the scanned facade, from the cleaning to the evaluation.
#include <doctest/doctest.h>

#include <map>
#include <numbers>

#include "chain.h"
#include "cloud/operations.h"
#include "recipe.h"

namespace jalon::insa_recipe_test {

using namespace jalon::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180, kTurn_rad = 37 * kDegree;
constexpr uint64_t kLeastPoints = 50;
constexpr double kLarge_m2 = 4;
// The parameters of the thesis (Boulaassal 2010, 3.4): pixels of twice the spacing, small planes first. The parts of
// the facade stand 0.15-0.4 m apart, so nothing bridges gaps.
constexpr const char* kThesis =
    R"({"distance_tolerance_m": 0.025, "orientation_order": "vertical horizontal parallel", "min_area_m2": 0.05,)"
    R"("gap_m": 0, "merge_gap_m": 0, "pixel_m": )";

/// The recipe's 200 000 points; or another number, scanned with the square root of that finer steps.
std::string scanner(int points) {
  const double step = 0.0025 * std::sqrt(200000.0 / points);
  return R"({"instrument": "gx", "glass_return_min": 0.05, "glass_return_max": 0.3, "outliers": 0.02, "stations": 4,)"
         R"("horizontal_step_rad": )" +
         std::to_string(step) + R"(, "vertical_step_rad": )" + std::to_string(step) +
         R"(, "max_points": )" + std::to_string(points) + "}";
}

/// The scan, cleaned, and its planes with their truth.
struct Insa {
  Recipe recipe;
  Truth truth;
  CloudPtr cleaned;
  double obstacles_left = 0, facade_kept = 0;
  Segmentation found, reference;
  Evaluation evaluation;

  Insa(int points, const std::string& parameters, uint64_t seed)
      : recipe(R"({"name": "insa"})", "static", scanner(points).c_str(), seed) {
    Task task;
    truth = find_truth(recipe.scene, 0.05, task);
    cleaned = clean(task);
    found = ransac(cleaned, parameters, seed);
    reference = true_segmentation(cleaned);
    evaluation = evaluated(found, reference, kLeastPoints);
  }

  const std::string& part_class(const Segment& segment) const {
    return recipe.scene.parts[truth.planes[static_cast<size_t>(segment.source_label) - 1].part]
        .part_class;
  }
  /// The class of a true plane's orientation in the recipe's own axes.
  Orientation true_orientation(const Segment& segment) const {
    const FacadeAxes axes = FacadeAxes::of({std::sin(kTurn_rad), -std::cos(kTurn_rad), 0});
    return axes.classify(truth.planes[static_cast<size_t>(segment.source_label) - 1].plane.normal,
                         kDegree);
  }

 private:
  CloudPtr clean(Task& task) {
    const Cloud& cloud = *recipe.cloud;
    const auto mask = points_of_interest(cloud, InterestSettings{}, task);
    const auto planes = cloud.fields.require("segment").values<uint32_t>();
    double kept[2] = {0, 0}, all[2] = {0, 0};
    for (size_t i = 0; i < mask.size(); ++i) {
      if (planes[i] == kNoSegment) continue;
      const std::string& name = recipe.scene.parts[truth.planes[planes[i] - 1].part].part_class;
      const bool unwanted = name == "car" || name == "stair";
      all[unwanted] += 1;
      kept[unwanted] += mask[i];
    }
    facade_kept = kept[0] / all[0];
    obstacles_left = kept[1] / all[1];
    return std::make_shared<const Cloud>(
        without_duplicates(select_mask(cloud, mask, 1, task), 1e-4, task));
  }
};

struct Tally {
  double planes = 0, found = 0, tdr = 0, tda = 0, worst_tdr = 1, worst_tda = 1;
  double worst_deg = 0, worst_m = 0;  ///< of the large ones
  double share() const { return found / planes; }
};

/// By class of part and orientation: reference planes of enough points, and how those found were found.
std::map<std::pair<std::string, Orientation>, Tally> tallies(const Insa& insa) {
  std::map<std::pair<std::string, Orientation>, Tally> out;
  for (const Segment& segment : insa.reference.segments)
    if (insa.evaluation.reference[segment.label - 1].kept)
      out[{insa.part_class(segment), insa.true_orientation(segment)}].planes += 1;
  for (const SegmentPair& pair : insa.evaluation.pairs) {
    const Segment& segment = insa.reference.segments[pair.reference - 1];
    const Segment& mine = insa.found.segments[pair.automatic - 1];
    Tally& t = out[{insa.part_class(segment), insa.true_orientation(segment)}];
    t.found += 1;
    t.tdr += pair.tdr();
    t.tda += pair.tda();
    t.worst_tdr = std::min(t.worst_tdr, pair.tdr());
    t.worst_tda = std::min(t.worst_tda, pair.tda());
    const TruePlane& plane = insa.truth.planes[static_cast<size_t>(segment.source_label) - 1];
    if (plane.area_m2 < kLarge_m2) continue;
    t.worst_deg = std::max(t.worst_deg, angle_degrees(plane.plane.normal, mine.fit.plane.normal));
    t.worst_m = std::max(t.worst_m, std::fabs(plane.plane.distance(mine.fit.centroid)));
  }
  for (auto& [name, t] : out) {
    t.tdr /= std::max(1.0, t.found);
    t.tda /= std::max(1.0, t.found);
  }
  return out;
}

void print(const char* what, uint64_t seed, const Insa& insa,
           std::map<std::pair<std::string, Orientation>, Tally>& t) {
  constexpr const char* kNames[] = {"", "parallel", "vertical", "horizontal", "inclined"};
  for (const auto& [name, tally] : t)
    MESSAGE("FIGURE S1 " << std::string(what) << ", seed " << seed << ": " << name.first << " "
                         << std::string(kNames[static_cast<int>(name.second)]) << " " << tally.found
                         << " of " << tally.planes << ", TDR " << tally.tdr << " (worst "
                         << tally.worst_tdr << "), TDA " << tally.tda << " (worst "
                         << tally.worst_tda << "), large ones within " << tally.worst_deg
                         << " deg, " << 1000 * tally.worst_m << " mm");
  const EvaluationTotals& e = insa.evaluation.totals;
  MESSAGE("FIGURE S1 " << std::string(what) << ", seed " << seed << ": " << insa.cleaned->size()
                       << " points cleaned, " << insa.found.segments.size() << " segments, "
                       << e.pairs << " pairs, TDR " << e.global_tdr << ", TDA " << e.global_tda
                       << " of their points, means " << e.mean_tdr << " and " << e.mean_tda
                       << ", over-segmented " << e.over_segmented << ", under "
                       << e.under_segmented);
}

/// Whether nearly all of a kind are found, and found well.
void expect(const Tally& t, double share, double rate) {
  CHECK(t.share() >= share);
  CHECK(t.tdr >= rate);
  CHECK(t.tda >= rate);
}

void check_rotation(const Insa& insa) {
  const Transform& T = insa.found.T_facade_world;
  const double turn_deg = std::atan2(T.m[1], T.m[0]) / kDegree;
  const auto depth = [&](const Vec3& p) {
    return T.m[4] * p.x + T.m[5] * p.y + T.m[6] * p.z + T.m[7];
  };
  // Depths in the facade's frame against those of the recipe: front 0.5 m before the wall, breast walls 0.1 behind it.
  const auto recipe_depth = [](const Vec3& p) {
    return -std::sin(kTurn_rad) * (p.x - 1000) + std::cos(kTurn_rad) * (p.y - 500);
  };
  double shift = NAN, worst_m = 0;
  for (const Segment& s : insa.found.segments) {
    if (s.orientation != Orientation::kParallel || s.area_m2 < kLarge_m2) continue;
    const double difference = depth(s.fit.centroid) - recipe_depth(s.fit.centroid);
    if (std::isnan(shift)) shift = difference;
    worst_m = std::max(worst_m, std::fabs(difference - shift));
  }
  MESSAGE("FIGURE S1 turned by " << turn_deg << " deg; depths in the facade's frame within "
                                 << 1000 * worst_m << " mm");
  CHECK(std::fabs(turn_deg - 37) < 0.005);
  CHECK(worst_m < 0.002);
}

void check_large_planes(const Insa& insa, std::map<std::pair<std::string, Orientation>, Tally>& t) {
  // "97 % of the reference points on 10 segments" (Boulaassal 2010, 5.5.3.2).
  constexpr double kRate = 0.97;
  uint64_t points = 0, common = 0;
  for (const SegmentPair& pair : insa.evaluation.pairs)
    if (pair.reference <= 10) points += pair.card_reference, common += pair.intersection;
  const double ten = static_cast<double>(common) / static_cast<double>(points);
  MESSAGE("FIGURE S1 ten largest planes: " << 100 * ten << " % of their points");
  CHECK(ten >= kRate);
  CHECK(insa.evaluation.totals.global_tdr >= kRate);
  for (const char* name : {"wall", "post", "breast_wall", "cornice"}) {
    CAPTURE(std::string(name));
    expect(t[{name, Orientation::kParallel}], 1, kRate);
  }
  expect(t[{"cornice", Orientation::kHorizontal}], 1, kRate);
}

void check_orientations(const Insa& insa) {
  for (const SegmentPair& pair : insa.evaluation.pairs)
    CHECK(insa.found.segments[pair.automatic - 1].orientation ==
          insa.true_orientation(insa.reference.segments[pair.reference - 1]));
}

}  // namespace

TEST_CASE("S1_insa__the_chain_finds_walls_posts_bands_and_breast_walls_by_their_classes") {
  for (uint64_t seed = 1; seed <= (is_full() ? 5 : 1); ++seed) {
    CAPTURE(seed);
    const Insa insa(200000, std::string(kThesis) + "0.2}", seed);
    auto t = tallies(insa);
    print("at 10 cm", seed, insa, t);
    CHECK(insa.facade_kept >= 0.99);
    CHECK(insa.obstacles_left <= 0.05);
    check_rotation(insa);
    check_large_planes(insa, t);
    check_orientations(insa);
    // Sides of posts, soffits and tops of bands: 0.35-0.75 m deep, 50-200 points each.
    expect(t[{"post", Orientation::kVertical}], 0.85, 0.9);
    expect(t[{"band", Orientation::kHorizontal}], 0.8, 0.9);
    expect(t[{"curtain", Orientation::kParallel}], 0.9, 0.97);
  }
}

// The mullions are 0.15 m wide: one or two points of the survey's spacing. Half of it shows them.
TEST_CASE("S1_insa__mullions_and_their_sides_are_found_at_5_cm") {
  if (!is_full()) return;
  const Insa insa(800000, std::string(kThesis) + "0.1}", 1);
  auto t = tallies(insa);
  print("at 5 cm", 1, insa, t);
  check_large_planes(insa, t);
  expect(t[{"mullion", Orientation::kParallel}], 0.65, 0.95);
  expect(t[{"mullion", Orientation::kVertical}], 0.5, 0.95);
}

}  // namespace jalon::insa_recipe_test
