// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The same facade when its points are jittered, rounded, reversed, turned, halved, moved to a national grid, written to
// a file and read again, or have outliers among them: walls of at least 5 % of the facade and openings. Facades of the
// grammar and real ones, stations taken off. What holds today is asserted, the rest printed as FIGUREs. Long form:
// JALON_FULL=1.
#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "cloud/select.h"
#include "facade_axes.h"
#include "facade_truth.h"
#include "formats/formats.h"
#include "labelled_street.h"
#include "modelling/facade/facade.h"
#include "recipe.h"

namespace jalon::facade_stability_test {

using namespace jalon::test;

namespace {

constexpr double kSpacing_m = 0.04;       // of the grammar's facades
constexpr double kLeastWallShare = 0.05;  // of the facade
constexpr double kSameWallIou = 0.9;      // of what is drawn of a wall's plane
constexpr double kSameOpeningIou = 0.7;   // as of a match with the truth
constexpr double kSamePlane_m = 0.05;     // faces of one wall
constexpr double kRow_m = 0.01, kWallRow_m = 0.02;
constexpr size_t kOtherOpenings = 1;  // "all openings within one"
// Runs with the same walls and all openings within one, each. Reached: all of eight in the short form, 156 and 155 of
// 162 in the long one; of the three with outliers three and one.
constexpr double kRealSame = 0.7, kRealSameInFull = 0.9;
constexpr double kJitter_m = 0.0002;
constexpr uint64_t kJitterStream = 21, kOutlierStream = 22;
constexpr uint64_t kPointsAnOutlier = 100;  // 1 % more

Cloud with_points(const Cloud& cloud, const std::function<Vec3(const Vec3&)>& change) {
  Buffer<double> xyz(3 * cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = change(cloud.point(i));
    for (int axis = 0; axis < 3; ++axis) xyz[3 * i + static_cast<size_t>(axis)] = p[axis];
  }
  return make_cloud(std::move(xyz));
}

Cloud every(const Cloud& cloud, bool is_reversed, size_t step) {
  std::vector<uint64_t> indices;
  for (uint64_t i = 0; i < cloud.size(); i += step)
    indices.push_back(is_reversed ? cloud.size() - 1 - i : i);
  Task task;
  return with_points(select(cloud, indices, task), [](const Vec3& p) { return p; });
}

Cloud jittered(const Cloud& cloud, uint64_t seed) {
  RandomStream random(seed, kJitterStream);
  return with_points(cloud, [&](const Vec3& p) {
    const Vec3 by{random.normal(), random.normal(), random.normal()};
    return p + by * kJitter_m;
  });
}

/// Points anywhere in the cloud's box besides.
Cloud with_outliers(const Cloud& cloud) {
  Vec3 low = cloud.point(0), high = low;
  for (size_t i = 0; i < cloud.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], cloud.point(i)[axis]);
      high[axis] = std::max(high[axis], cloud.point(i)[axis]);
    }
  RandomStream random(1, kOutlierStream);
  const size_t all = cloud.size() + cloud.size() / kPointsAnOutlier;
  Buffer<double> xyz(3 * all);
  for (size_t i = 0; i < all; ++i)
    for (int axis = 0; axis < 3; ++axis)
      xyz[3 * i + static_cast<size_t>(axis)] =
          i < cloud.size() ? cloud.point(i)[axis]
                           : low[axis] + (high[axis] - low[axis]) * random.uniform();
  return make_cloud(std::move(xyz));
}

Cloud rounded(const Cloud& cloud, double step_m) {
  const auto to_step = [&](double v) { return std::round(v / step_m) * step_m; };
  return with_points(cloud, [&](const Vec3& p) {
    return Vec3{to_step(p.x), to_step(p.y), to_step(p.z)};
  });
}

Cloud read_again(const Cloud& cloud, const std::string& extension) {
  Task task;
  const auto path = std::filesystem::temp_directory_path() /
                    ("jalon_stability_" + std::to_string(cloud.size()) + extension);
  write_cloud(cloud, path.string(), {}, task);
  Cloud out = with_points(read_cloud(path.string(), {}, task), [](const Vec3& p) { return p; });
  std::filesystem::remove(path);
  return out;
}

/// A turn about Z and a shift: p -> turned p + shift.
struct Motion {
  double yaw_deg = 0;
  Vec3 shift;

  Vec3 turned(const Vec3& p, double sign) const {
    const double c = std::cos(yaw_deg * std::numbers::pi / 180),
                 s = sign * std::sin(yaw_deg * std::numbers::pi / 180);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  }
  Vec3 forth(const Vec3& p) const { return turned(p, 1) + shift; }
  Vec3 back(const Vec3& p) const { return turned(p - shift, -1); }
};

struct Variant {
  std::string name;
  Cloud cloud;
  Motion motion;      ///< it was moved by
  uint64_t seed = 0;  ///< of RANSAC; 0: the default
};

Variant moved(const std::string& name, const Cloud& cloud, const Motion& motion) {
  return {name, with_points(cloud, [&](const Vec3& p) { return motion.forth(p); }), motion};
}

std::vector<Variant> variants_of(const Cloud& cloud) {
  std::vector<Variant> out;
  for (uint64_t k = 1; k <= (is_full() ? 20 : 1); ++k)
    out.push_back({"jitter of 0.2 mm", jittered(cloud, k), {}});
  out.push_back({"rounded to 1 um", rounded(cloud, 1e-6), {}});
  out.push_back({"reversed", every(cloud, true, 1), {}});
  out.push_back({"half of the points", every(cloud, false, 2), {}});
  out.push_back({"1 % outliers more", with_outliers(cloud), {}});
  for (const double yaw_deg : is_full() ? std::vector<double>{30, 77, 90, 135, 180, 211, 270, 333}
                                        : std::vector<double>{77})
    out.push_back(moved("turned", cloud, {yaw_deg, {}}));
  out.push_back(moved("national grid", cloud, {0, {652000, 6862000, 120}}));
  out.push_back({"LAS", read_again(cloud, ".las"), {}});
  if (!is_full()) return out;
  out.push_back({"PLY", read_again(cloud, ".ply"), {}});
  for (uint64_t seed = 2; seed <= 20; ++seed)
    out.push_back(
        {"seed of RANSAC", with_points(cloud, [](const Vec3& p) { return p; }), {}, seed});
  return out;
}

Model modelled(const CloudPtr& cloud, uint64_t seed) {
  Task task;
  RansacSettings settings;
  if (seed != 0) settings.draw.seed = seed;
  return model_facade(segment_ransac(cloud, settings, task), FacadeSettings{}, task);
}

Model moved_back(Model model, const Motion& by) {
  for (Vec3& p : model.vertices) p = by.back(p);
  for (Face& face : model.faces) face.plane.normal = by.turned(face.plane.normal, -1);
  return model;
}

Region near_plane(const FoundFacade& facade, double out_m) {
  Region out;
  for (const FoundFacade::Face& face : facade.walls)
    if (std::fabs(face.out_m - out_m) <= kSamePlane_m) out.push_back(face.shape);
  return out;
}

/// Planes of `a` with at least the share of its walls that `b` draws otherwise.
size_t other_walls(const FoundFacade& a, const FoundFacade& b) {
  std::vector<double> area;
  double all = 0;
  for (const FoundFacade::Face& face : a.walls) {
    area.push_back(areas({face.shape}, {face.shape}, kWallRow_m).a_m2);
    all += area.back();
  }
  size_t out = 0;
  for (size_t k = 0; k < a.walls.size(); ++k) {
    if (area[k] < kLeastWallShare * all) continue;
    const double out_m = a.walls[k].out_m;
    out += areas(near_plane(a, out_m), near_plane(b, out_m), kWallRow_m).iou() < kSameWallIou;
  }
  return out;
}

/// Openings of `a` that `b` has no like of.
size_t other_openings(const FoundFacade& a, const FoundFacade& b) {
  std::vector<bool> taken(b.openings.size(), false);
  size_t out = 0;
  for (const FoundOpening& mine : a.openings) {
    bool is_there = false;
    for (size_t k = 0; k < b.openings.size() && !is_there; ++k) {
      const FoundOpening& other = b.openings[k];
      if (taken[k] || std::fabs(mine.out_m - other.out_m) > kSamePlane_m ||
          !extent_of(mine.drawn.region).meets(extent_of(other.drawn.region)))
        continue;
      is_there = areas(mine.drawn.region, other.drawn.region, kRow_m).iou() >= kSameOpeningIou;
      taken[k] = is_there;
    }
    out += !is_there;
  }
  return out;
}

struct Stability {
  size_t runs = 0, same_walls = 0, same_openings = 0;
};

void compare_variants(const std::string& name, const Cloud& cloud,
                      std::map<std::string, Stability>& by_change) {
  const auto plain =
      std::make_shared<const Cloud>(with_points(cloud, [](const Vec3& p) { return p; }));
  const Model base = modelled(plain, 0);
  const FacadeTruth axes = axes_of_largest(base);
  REQUIRE(!axes.walls.empty());
  const FoundFacade found = found_facade(base, axes);
  for (Variant& variant : variants_of(cloud)) {
    const Model model =
        modelled(std::make_shared<const Cloud>(std::move(variant.cloud)), variant.seed);
    const FoundFacade other = found_facade(moved_back(model, variant.motion), axes);
    const size_t walls = std::max(other_walls(found, other), other_walls(other, found)),
                 openings = std::max(other_openings(found, other), other_openings(other, found));
    Stability& s = by_change[variant.name];
    ++s.runs;
    s.same_walls += walls == 0;
    s.same_openings += openings <= kOtherOpenings;
    if (walls > 0 || openings > 0)
      MESSAGE("FIGURE stability, " << name << ", " << variant.name << ": " << walls << " walls and "
                                   << openings << " of " << found.openings.size()
                                   << " openings differ");
  }
}

Stability print_changes(const std::string& what,
                        const std::map<std::string, Stability>& by_change) {
  Stability all;
  for (const auto& [name, s] : by_change) {
    MESSAGE("FIGURE stability, " << what << ", " << name << ": of " << s.runs
                                 << " runs, the same walls in " << s.same_walls
                                 << ", all openings within one in " << s.same_openings);
    all.runs += s.runs, all.same_walls += s.same_walls, all.same_openings += s.same_openings;
  }
  return all;
}

Cloud grammar_cloud(uint64_t seed) {
  Task task;
  SceneSettings settings{.name = SceneName::kGrammar, .seed = seed};
  settings.grammar.spacing_m = kSpacing_m;
  const SceneSurvey survey = scene_survey(settings);
  return scan_static(build_scene(settings, task), survey.stations, survey.scanner, task);
}

}  // namespace

TEST_CASE("facade_stability__of_grammar_facades_under_changes_that_mean_nothing") {
  std::vector<uint64_t> seeds{14};
  for (uint64_t seed = 1; is_full() && seed <= 20; ++seed)
    if (seed != 14) seeds.push_back(seed);
  std::map<std::string, Stability> by_change;
  for (const uint64_t seed : seeds)
    compare_variants("grammar seed " + std::to_string(seed), grammar_cloud(seed), by_change);
  const Stability all = print_changes("grammar", by_change);
  CHECK(all.runs > 0);
  if (is_full()) return;  // printed: what holds there has not been measured
  CHECK(all.same_walls == all.runs);
  CHECK(all.same_openings == all.runs);
}

TEST_CASE("facade_stability__of_real_facades_under_changes_that_mean_nothing") {
  std::vector<const char*> files{"street_1.txt"};
  if (is_full()) files = {"street_1.txt", "street_3.txt", "building_2.txt"};
  std::map<std::string, Stability> by_change;
  for (const char* file : files) {
    const LabelledStreet street(file);
    if (street.cloud == nullptr) {
      if (std::getenv("CI") != nullptr) FAIL("JALON_SHARED_DATA holds no facades");
      MESSAGE("skipped: no " << file << " in " << JALON_SHARED_DATA << "/facades");
      return;
    }
    compare_variants(file, *street.cloud, by_change);
  }
  const Stability all = print_changes("real", by_change);
  CHECK(all.runs > 0);
  const double least = (is_full() ? kRealSameInFull : kRealSame) * static_cast<double>(all.runs);
  CHECK(static_cast<double>(all.same_walls) >= least);
  CHECK(static_cast<double>(all.same_openings) >= least);
}

}  // namespace jalon::facade_stability_test
