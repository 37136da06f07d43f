// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "compare/landslide/cell_table.h"
#include "compare/landslide/landslide.h"
#include "compare/landslide/zone_measures.h"
#include "landslide_scene.h"
#include "seed_range.h"

// Girardeau-Montaut 2006, 5.4: the boundary of a slide, what went and what came, and what was not scanned. Constants
// were set on seeds 1 to 30: bowls, slumps, flows and lobes; blocks that sank and wedges, from seed 31 on, are reported
// only.

namespace jalon::landslide_test {

using namespace jalon::test;

namespace {

/// How the result fits the truth.
struct SlideScore {
  double iou = 0;         ///< of the cells that moved, either way, where both epochs have measured
  double false_area = 0;  ///< share of the ground at rest that is in a zone
  double wrong_side = 0;  ///< share of the zones' cells that moved the other way
  double depletion_z = 0, accumulation_z = 0;          ///< errors over their sigma
  double depletion_error = 0, accumulation_error = 0;  ///< of the true volume
  double depletion_m3 = 0, accumulation_m3 = 0;
  double unseen = 0, found_unseen = 0;  ///< shares of the area, mean of both epochs
  double unseen_found = 0;  ///< share of the cells that were not seen that are not measured
  double hidden_found = 0;  ///< and of those that are said to be hidden
  double hidden_right =
      0;  ///< share of the cells said to be hidden that were not seen, by half at least
};

/// What truly happened in a cell: means over a grid of its places.
struct TrueCell {
  double moved_m = 0, seen_before = 0, seen_after = 0;
};

class SlideTruth {
 public:
  explicit SlideTruth(const SlideScene& scene) : scene_(scene) {
    Task task;
    for (const bool after : {false, true}) {
      const Model model = scene.model(after);
      trees_[after ? 1 : 0] = TriangleTree::build(model.vertices, model.triangles, task);
      for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i)
          heights_[after ? 1 : 0].push_back(
              scene.ground_m(i * SlideScene::kMesh_m, j * SlideScene::kMesh_m, after));
    }
  }
  /// back: from where the comparison was made to where the scene is.
  TrueCell of(const Vec3& middle, const CellTable& cells, const Transform& back) const {
    TrueCell out;
    const auto for_each_place = [&](int across, auto&& f) {
      for (int i = 0; i < across * across; ++i) {
        const double along = ((i % across + 0.5) / across - 0.5) * cells.cell_m,
                     aside = ((i / across + 0.5) / across - 0.5) * cells.cell_m;
        const Vec3 p = back.point(middle + cells.u * along + cells.v * aside);
        f(p.x, p.y, 1.0 / (across * across));
      }
    };
    constexpr int kAcross = 8, kLooks = 3;
    for_each_place(kAcross, [&](double x, double y, double share) {
      out.moved_m += share * (surface_m(x, y, true) - surface_m(x, y, false));
    });
    for_each_place(kLooks, [&](double x, double y, double share) {
      out.seen_before += share * is_seen(x, y, false);
      out.seen_after += share * is_seen(x, y, true);
    });
    return out;
  }

 private:
  static constexpr int kColumns = static_cast<int>(SlideScene::kWidth_m / SlideScene::kMesh_m) + 1,
                       kRows = static_cast<int>(SlideScene::kDepth_m / SlideScene::kMesh_m) + 1;
  // Of the mesh that was scanned, not of the formula: walls lean between its corners.
  double surface_m(double x, double y, bool after) const {
    const double u = std::clamp(x / SlideScene::kMesh_m, 0.0, kColumns - 1.001),
                 v = std::clamp(y / SlideScene::kMesh_m, 0.0, kRows - 1.001);
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const double a = u - i, b = v - j;
    const auto at = [&](int column, int row) {
      return heights_[after ? 1 : 0][static_cast<size_t>(row * kColumns + column)];
    };
    const double ground = (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) +
                          b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
    return ground + scene_.boulder_over_m(x, y, ground, after);
  }
  double is_seen(double x, double y, bool after) const {
    const Vec3 p{x, y, surface_m(x, y, after)};
    for (const Vec3& eye : scene_.eyes) {
      RayHit hit;
      if (!trees_[after ? 1 : 0]->nearest({eye, p - eye}, hit)) continue;
      if ((1 - hit.t) * norm(p - eye) < 0.25) return 1;  // the mesh is that of the ground to 2 cm
    }
    return 0;
  }
  const SlideScene& scene_;
  std::shared_ptr<const TriangleTree> trees_[2];
  std::vector<double> heights_[2];  ///< of the mesh's corners
};

Comparison slide_compared(const SlideScene& scene, const Cloud& before, const Cloud& after,
                          LandslideSettings settings = {}) {
  Task task;
  if (settings.outline.empty()) settings.outline = scene.outline();
  return compare_landslide(std::make_shared<const Cloud>(before),
                           std::make_shared<const Cloud>(after), settings, task);
}

double of(const Comparison& comparison, const char* name) {
  return comparison.summary.require(name).number(0);
}

SlideScore score_of(const SlideScene& scene, const Comparison& comparison,
                    const Transform& back = {}) {
  constexpr double kMoved_m = 0.03;  // the rim: less is neither moved nor at rest
  const SlideTruth truth(scene);
  const CellTable cells(comparison);
  SlideScore out;
  double at_rest = 0, both = 0, either = 0, gone = 0, came = 0, wrong = 0, zone_cells = 0;
  double unseen_before = 0, unseen_after = 0;
  size_t unseen = 0, unseen_found = 0, hidden = 0, hidden_found = 0, hidden_right = 0;
  size_t found_before = 0, found_after = 0;
  for (size_t i = 0; i < cells.size(); ++i) {
    const TrueCell cell = truth.of(comparison.cloud->point(i), cells, back);
    unseen_before += 1 - cell.seen_before;
    unseen_after += 1 - cell.seen_after;
    found_before += cells.reference_status[i] != 0;
    found_after += cells.compared_status[i] != 0;
    for (const bool is_after : {false, true}) {
      const double seen = is_after ? cell.seen_after : cell.seen_before;
      const uint8_t status = (is_after ? cells.compared_status : cells.reference_status)[i];
      const bool is_unseen = seen < 0.12;  // none of nine looks
      unseen += is_unseen;
      unseen_found += is_unseen && status != 0;
      hidden += status == 1;
      hidden_found += is_unseen && status == 1;
      hidden_right += status == 1 && seen <= 0.5;
    }
    if (!cells.is_measured(i)) continue;
    (cell.moved_m < 0 ? gone : came) += std::abs(cell.moved_m) * cells.cell_area_m2();
    if (cell.moved_m != 0 && std::abs(cell.moved_m) < kMoved_m) continue;
    const bool moved = cell.moved_m != 0, found = cells.zone[i] != 0;
    at_rest += !moved;
    out.false_area += !moved && found;
    both += moved && found;
    either += moved || found;
    zone_cells += found;
    wrong += found && moved && (cells.distance[i] < 0) != (cell.moved_m < 0);
  }
  const auto n = static_cast<double>(cells.size());
  out.iou = both / either;
  out.false_area /= at_rest;
  out.wrong_side = wrong / std::max(1.0, zone_cells);
  out.depletion_m3 = gone;
  out.accumulation_m3 = came;
  out.depletion_error = of(comparison, "depletion") / gone - 1;
  out.accumulation_error = of(comparison, "accumulation") / came - 1;
  out.depletion_z = (of(comparison, "depletion") - gone) / of(comparison, "depletion_sigma");
  out.accumulation_z =
      (of(comparison, "accumulation") - came) / of(comparison, "accumulation_sigma");
  out.unseen = (unseen_before + unseen_after) / (2 * n);
  out.found_unseen = static_cast<double>(found_before + found_after) / (2 * n);
  const auto share = [](size_t part, size_t of_all) {
    return of_all > 0 ? static_cast<double>(part) / static_cast<double>(of_all) : 1.0;
  };
  out.unseen_found = share(unseen_found, unseen);
  out.hidden_found = share(hidden_found, unseen);
  out.hidden_right = share(hidden_right, hidden);
  return out;
}

SlideScore scored(SlideKind kind, uint64_t seed) {
  const SlideScene scene(kind, seed);
  const Comparison comparison = slide_compared(scene, scene.scan(false), scene.scan(true));
  const SlideScore s = score_of(scene, comparison);
  MESSAGE("FIGURE landslide kind ", static_cast<int>(kind), " seed ", seed, ": cells of ",
          of(comparison, "cell"), " m, IoU ", s.iou, ", false ", 100 * s.false_area,
          " %, depletion ", s.depletion_m3, " m3 error ", 100 * s.depletion_error,
          " % = ", s.depletion_z, " sigma, accumulation ", s.accumulation_m3, " m3 error ",
          100 * s.accumulation_error, " % = ", s.accumulation_z, " sigma, unseen ", 100 * s.unseen,
          " %, found ", 100 * s.found_unseen, " %, of unseen cells found ", s.unseen_found,
          " hidden ", s.hidden_found, ", hidden rightly ", s.hidden_right, ", scale ",
          of(comparison, "sigma_scale"), ", systematic ", 1000 * of(comparison, "systematic"),
          " mm");
  return s;
}

SeedRange seeds_of(SeedRange cheap, SeedRange whole) {
  const bool is_long = std::getenv("JALON_FULL") != nullptr;
  return seeds_asked_for("JALON_SLIDE_SEEDS").value_or(is_long ? whole : cheap);
}

/// Volumes of several slides.
struct Coverage {
  size_t volumes = 0, inside = 0;  ///< of their 95 % interval
  double squares = 0;
  void add(const SlideScore& s) {
    for (const double z : {s.depletion_z, s.accumulation_z}) {
      ++volumes;
      inside += std::abs(z) <= 1.96;
      squares += z * z;
    }
  }
  /// The chance of so few or fewer inside, if 95 % of all intervals hold the truth.
  double chance() const {
    double sum = 0, term = std::pow(0.05, static_cast<double>(volumes));
    for (size_t k = 0; k <= inside; ++k) {
      sum += term;
      term *= 0.95 / 0.05 * static_cast<double>(volumes - k) / static_cast<double>(k + 1);
    }
    return sum;
  }
};

void check_seeds(SeedRange seeds, SlideKind (*kind_of)(uint64_t seed)) {
  Coverage coverage;
  double iou = 0, unseen_found = 0, hidden_right = 0, n = 0;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const SlideScore s = scored(kind_of(seed), seed);
    CHECK(s.iou > 0.6);
    CHECK(s.false_area < 0.01);
    CHECK(s.unseen_found > 0.85);
    coverage.add(s);
    iou += s.iou;
    unseen_found += s.unseen_found;
    hidden_right += s.hidden_right;
    n += 1;
  }
  MESSAGE("FIGURE landslide seeds ", seeds.first, " to ", seeds.last, ": mean IoU ", iou / n,
          ", volumes within their 95 % interval ", coverage.inside, " of ", coverage.volumes,
          ", mean square of error over sigma ",
          coverage.squares / static_cast<double>(coverage.volumes),
          ", of cells unseen not measured ", unseen_found / n, ", said to be hidden and unseen ",
          hidden_right / n);
  CHECK(iou / n > 0.85);
  CHECK(unseen_found / n > 0.9);
  CHECK(hidden_right / n > 0.8);
  CHECK(coverage.chance() > 0.001);
}

/// As right as from the clouds as they were.
void check_same(const char* what, const SlideScore& plain, const SlideScore& other) {
  MESSAGE("FIGURE landslide ", std::string(what), ": IoU ", other.iou, " for ", plain.iou,
          ", errors of depletion and accumulation ", other.depletion_z, " and ",
          other.accumulation_z, " sigma for ", plain.depletion_z, " and ", plain.accumulation_z,
          ", not measured ", 100 * other.found_unseen, " % for ", 100 * plain.found_unseen, " %");
  CHECK(other.iou > plain.iou - 0.1);
  CHECK(std::abs(other.depletion_z) < 3);
  CHECK(std::abs(other.accumulation_z) < 3);
  CHECK(other.unseen_found > 0.9);
}

Cloud picked(const Cloud& cloud, size_t step, bool backward) {
  std::vector<size_t> rows;
  for (size_t i = 0; i < cloud.size(); i += step) rows.push_back(i);
  if (backward) std::reverse(rows.begin(), rows.end());
  Buffer<double> xyz(3 * rows.size());
  for (size_t k = 0; k < rows.size(); ++k) {
    const Vec3 p = cloud.point(rows[k]);
    for (int a = 0; a < 3; ++a) xyz[3 * k + static_cast<size_t>(a)] = p[a];
  }
  return make_cloud(std::move(xyz));
}

}  // namespace

TEST_CASE("landslide__boundary_volumes_and_what_was_not_seen_of_bowls") {
  check_seeds(seeds_of({1, 2}, {1, 10}), [](uint64_t) { return SlideKind::kBowl; });
}

TEST_CASE("landslide__the_same_of_slumps_flows_and_lobes") {
  check_seeds(seeds_of({11, 13}, {11, 30}), [](uint64_t seed) {
    return std::array{SlideKind::kSlump, SlideKind::kFlow, SlideKind::kLobes}[seed % 3];
  });
}

TEST_CASE("landslide__the_same_of_shapes_and_seeds_that_no_constant_was_set_on") {
  check_seeds(seeds_of({31, 32}, {31, 50}), [](uint64_t seed) {
    return std::array{SlideKind::kSteps, SlideKind::kWedge}[seed % 2];
  });
}

TEST_CASE("landslide__is_the_same_whatever_the_order_the_place_the_turn_and_half_of_the_points") {
  const SlideScene scene(SlideKind::kBowl, 1);
  const Cloud before = scene.scan(false), after = scene.scan(true);
  const Comparison made = slide_compared(scene, before, after);
  const SlideScore plain = score_of(scene, made);
  const auto check = [&](const char* what, const Cloud& first, const Cloud& second) {
    check_same(what, plain, score_of(scene, slide_compared(scene, first, second)));
  };
  check("backward", picked(before, 1, true), picked(after, 1, true));
  check("of half of the points", picked(before, 2, false), picked(after, 2, false));
  for (const double turn_rad : {0.0, 0.5}) {
    Transform by;
    by.m = {std::cos(turn_rad),
            -std::sin(turn_rad),
            0,
            652000,
            std::sin(turn_rad),
            std::cos(turn_rad),
            0,
            6861000,
            0,
            0,
            1,
            300};
    LandslideSettings settings;
    const std::vector<double> corners = scene.outline();
    for (size_t k = 0; k < corners.size(); k += 3) {
      const Vec3 p = by.point({corners[k], corners[k + 1], corners[k + 2]});
      for (int a = 0; a < 3; ++a) settings.outline.push_back(p[a]);
    }
    const Comparison moved = slide_compared(scene, SlideScene::transformed(before, by),
                                            SlideScene::transformed(after, by), settings);
    check_same(turn_rad == 0 ? "in a national grid" : "turned there", plain,
               score_of(scene, moved, inverse(by)));
  }
  // A tenth of a millimetre of jitter, as of a file's rounding.
  RandomStream random(3, 9);
  const auto jittered = [&](const Cloud& cloud) {
    Buffer<double> xyz(3 * cloud.size());
    for (size_t i = 0; i < 3 * cloud.size(); ++i)
      xyz[i] = cloud.point(i / 3)[static_cast<int>(i % 3)] + 1e-4 * random.normal();
    return make_cloud(std::move(xyz));
  };
  check("jittered", jittered(before), jittered(after));
}

}  // namespace jalon::landslide_test
