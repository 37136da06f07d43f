// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Both epochs from three stations, of which the finest scan has ten times as many points a solid angle as the coarsest,
// by another tripod each time: no shadow and no coarse corner is a change, whether the stations are known or found, and
// what came and went is found. Seeds 1 to 12 were developed on.
#include <doctest/doctest.h>

#include <cmath>

#include "change_scenes.h"
#include "diagnosed.h"
#include "recipe.h"
#include "seed_range.h"

namespace jalon::uneven_stations_test {

using namespace jalon::test;

namespace {

constexpr double kFinest_rad = 0.007;
constexpr double kOfDensities = 10;
// Asked of unchanged scenes and of classes; where the stations are known, no shadow at all is a change.
constexpr double kCleanRuns = 0.95, kFoundRight = 0.9;
constexpr uint32_t kGone = 50, kCome = 51;

struct TwoScenes {
  TriangleScene before, after;
};

// Boxes about an open middle, a wall behind; in the middle one box went and another came.
TwoScenes court(uint64_t seed, bool is_changed) {
  TwoScenes out;
  RandomStream random(seed, 41);
  const auto between = [&](double low, double high) {
    return low + (high - low) * random.uniform();
  };
  for (TriangleScene* s : {&out.before, &out.after}) {
    s->ground(8);
    s->quad({-8, 8, 0}, {8, 8, 0}, {8, 8, 3.5}, {-8, 8, 3.5}, 2);
  }
  for (uint32_t k = 0; k < 5; ++k) {
    const double a = 2 * std::numbers::pi * (k + between(-0.3, 0.3)) / 5, r = between(3, 4.5);
    const double turned_deg = between(0, 90);
    Vec3 size;
    for (int c = 0; c < 3; ++c) size[c] = between(0.5, 1.3);
    for (TriangleScene* s : {&out.before, &out.after})
      s->box(size, placed(r * std::cos(a), r * std::sin(a), turned_deg), 3 + k);
  }
  const double gone_deg = between(0, 90), come_deg = between(0, 90);
  const Vec3 gone{between(0.6, 1), between(0.5, 0.8), between(0.5, 0.9)},
      come{between(0.6, 1), between(0.3, 0.5), between(0.9, 1.3)};
  if (!is_changed) return out;
  out.before.box(gone, placed(-1.1, 0, gone_deg), kGone);
  out.after.box(come, placed(1.2, 0.3, come_deg), kCome);
  return out;
}

// The tripods one behind the other in the cloud, as a file holds them.
CloudPtr scanned_unevenly(const TriangleScene& scene, double first_deg, size_t finest,
                          uint64_t seed) {
  Task task;
  const auto stations = stations_around(3, 7, 1.8, first_deg);
  CloudPtr all;
  for (size_t k = 0; k < stations.size(); ++k) {
    // Steps 1, 1.8 and 3.2 times the finest.
    const double coarser = std::pow(kOfDensities, static_cast<double>((k + finest) % 3) / 4);
    const CloudPtr one =
        scanned(scene, {stations[k]}, 3 * seed + k, {kFinest_rad * coarser, 0.003});
    all = all == nullptr ? one : std::make_shared<const Cloud>(append(*all, *one, task));
  }
  return all;
}

struct UnevenEpochs {
  CloudPtr before, after;
};

UnevenEpochs epochs_of(uint64_t seed, bool is_changed) {
  const TwoScenes scenes = court(seed, is_changed);
  return {scanned_unevenly(scenes.before, 15, seed % 3, 2 * seed),
          scanned_unevenly(scenes.after, 70, (seed + 1) % 3, 2 * seed + 1)};
}

CloudPtr without_stations(const CloudPtr& cloud) {
  auto out = std::make_shared<Cloud>(*cloud);
  out->stations.clear();
  return out;
}

Diagnosis changes_between(const CloudPtr& before, const CloudPtr& after) {
  return diagnosed(before, after, DistanceSettings::VisibleFrom::kFound);
}

// Most of a change's changed points are the thing's.
bool is_of(const Cloud& cloud, const std::vector<uint32_t>& points, uint32_t object) {
  const auto faces = cloud.fields.require("face").values<uint32_t>();
  const auto n =
      std::count_if(points.begin(), points.end(), [&](uint32_t i) { return faces[i] == object; });
  return 2 * static_cast<size_t>(n) > points.size();
}

struct UnevenTally {
  size_t right = 0, others = 0;
};

UnevenTally tally_of(const UnevenEpochs& scans) {
  const Diagnosis found = changes_between(scans.before, scans.after);
  UnevenTally out;
  for (const Change& change : found.changes) {
    const bool came = change.change_class == ChangeClass::kAppearance &&
                      is_of(*scans.after, change.object.after, kCome);
    const bool went = change.change_class == ChangeClass::kDisappearance &&
                      is_of(*scans.before, change.object.before, kGone);
    ++(came || went ? out.right : out.others);
  }
  return out;
}

SeedRange uneven_seeds() {
  return seeds_asked_for("JALON_CHANGE_SEEDS").value_or(SeedRange{901, is_full() ? 920u : 901u});
}

}  // namespace

TEST_CASE("uneven_stations__no_shadow_is_a_change_where_densities_differ_tenfold") {
  const SeedRange seeds = uneven_seeds();
  size_t runs = 0, quiet = 0, quiet_found = 0;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed, ++runs) {
    const UnevenEpochs scans = epochs_of(seed, false);
    quiet += changes_between(scans.before, scans.after).changes.empty() ? 1 : 0;
    const Diagnosis found =
        changes_between(without_stations(scans.before), without_stations(scans.after));
    quiet_found += found.changes.empty() ? 1 : 0;
  }
  MESSAGE("FIGURE three stations, densities 1 : 10, unchanged: no change in "
          << quiet << " of " << runs << " pairs, in " << quiet_found
          << " where the stations had to be found");
  CHECK(quiet == runs);
  CHECK(static_cast<double>(quiet_found) >= kCleanRuns * static_cast<double>(runs));
}

TEST_CASE("uneven_stations__what_came_and_went_is_found_and_nothing_else") {
  const SeedRange seeds = uneven_seeds();
  size_t runs = 0;
  UnevenTally all;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed, ++runs) {
    const UnevenTally one = tally_of(epochs_of(seed, true));
    all.right += one.right, all.others += one.others;
  }
  MESSAGE("FIGURE three stations, densities 1 : 10, one box gone and one come: "
          << all.right << " of " << 2 * runs << " found with their class, " << all.others
          << " other statements");
  CHECK(static_cast<double>(all.right) >= kFoundRight * 2 * static_cast<double>(runs));
  CHECK(all.others == 0);
}

}  // namespace jalon::uneven_stations_test
