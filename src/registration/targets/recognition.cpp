// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/recognition.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "base/table_columns.h"
#include "registration/targets/flat_target.h"
#include "registration/targets/pattern_extent.h"
#include "registration/targets/pattern_places.h"

namespace jalon {

namespace {

constexpr double kPlaceReach = 0.25;  // of a size: the centre is so near to where it was looked for
// Of a size, radius of what is measured: a checker's quadrants; a disc and enough of its ground.
constexpr double kWithinChecker = 0.5, kWithinDisc = 0.8;
constexpr double kAround = 0.75;   // of the largest size: radius of what the border is sought in
constexpr double kLargest = 1.5;   // of the catalogue's largest: beyond, a border is no target's
constexpr double kSmallest = 0.6;  // of the smallest
// Sigmas of the plane, and of the tolerance at least this share: what lies so far behind is not beside the sheet, and
// seen askew it seems to lie within it.
constexpr double kGroundSigmas = 3, kGroundTolerance = 0.5;
constexpr double kAskew =
    0.3;  // of the depth of what is around: so much a border may be off, seen askew
constexpr double kSameDirection = 0.95, kSameFacade_m = 0.3;  // cosine; depth of reveals
constexpr double kSamePlace = 0.6;  // of a size: nearer centres are readings of one pattern
// Of a size: what is smaller and farther from the centre is a part of the pattern, not another reading of it.
// A quadrant of a checker lies 0.35 from its centre, and the disc that it can be read as says nothing against the
// checker; this is half of it.
constexpr double kSameCentre = 0.18;
// Readings whose confidences differ by less than this factor stand for each other.
constexpr double kAlikeReadings = 0.5;

// Chance of a pattern by its misfit, a logistic curve: the misfits of targets and of other patterns of the scenes
// developed with (tests/accuracy/coded_targets_test.cpp).
struct MisfitChance {
  double even, scale;
};
constexpr MisfitChance kCheckerChance{0.11, 0.015}, kDiscChance{0.035, 0.005};
constexpr double kVagueSize = 0.1;     // of the size, its sigma: more is no border
constexpr double kLeastPattern = 0.5;  // less likely ones are no targets and not listed

// Of a target of another size than all entries: this share, spread over one power of e of sizes.
constexpr double kForeignShare = 0.05;
constexpr double kEntryFits = 4;    // sigmas: further from all of them a size is in no entry
constexpr double kAlsoFits = 0.02;  // chance from which a second entry is named

double chance_of_pattern(TargetKind kind, double misfit) {
  const auto [even, scale] = kind == TargetKind::kChecker ? kCheckerChance : kDiscChance;
  return 1 / (1 + std::exp((misfit - even) / scale));
}

std::optional<PatternExtent> extent_of(const Cloud& cloud, const Octree& tree,
                                       const Column& intensity, const RecognisedTarget& target,
                                       double inner_m, double tolerance_m, double most_m,
                                       Task& task) {
  const bool is_checker = target.measured.kind == TargetKind::kChecker;
  const double radius = is_checker ? kAround * most_m * std::numbers::sqrt2 : kAround * inner_m;
  const Surroundings near =
      surroundings_of(cloud, tree, target.place, target.measured.centre, radius);
  const Vec3 normal = target.measured.normal;
  const Vec3 away = std::fabs(normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = normalized(cross(away, normal)), v = cross(normal, u);
  const double depth =
      std::max(kGroundSigmas * target.measured.sigma_m, kGroundTolerance * tolerance_m);
  std::vector<BrightPoint> points;
  for (size_t i = 0; i < near.points.size(); ++i) {
    const Vec3 d = near.points[i] - target.measured.centre;
    const double value = intensity.number(near.indices[i]);
    if (std::fabs(dot(d, normal)) > depth || !std::isfinite(value)) continue;
    points.push_back({dot(d, u), dot(d, v), value});
  }
  if (is_checker) return checker_extent(points, inner_m, most_m, task);
  return disc_extent(points, 2 * target.measured.radius_m, 2 * target.measured.radius_sigma_m);
}

// Steps 2 and 3 at one place: nothing where there is no such pattern.
std::optional<RecognisedTarget> read_at(const Cloud& cloud, const Octree& tree,
                                        const Column& intensity, const PatternPlace& at,
                                        MeasuringSettings setting,
                                        std::pair<double, double> size_range_m, Task& task) {
  const bool is_checker = at.kind == TargetKind::kChecker;
  setting.pattern = is_checker ? TargetPattern::kChecker : TargetPattern::kDisc;
  RecognisedTarget out;
  out.place = at.place;
  double size = at.size_m, round_chance = 1;
  for (int pass = 0; pass < 2; ++pass) {  // the second at its own size
    setting.size_m = size;
    // Of its own size nothing but the sheet is looked at: what it sticks on would take the plane along.
    setting.search_m =
        (is_checker ? kWithinChecker + (pass == 0 ? kPlaceReach : 0) : kWithinDisc) * size;
    out.measured = measure_flat(cloud, tree, out.place, setting, task);
    if (out.measured.status != Status::kOk) return std::nullopt;
    const auto extent = extent_of(cloud, tree, intensity, out, size, setting.tolerance_m,
                                  kLargest * size_range_m.second, task);
    if (!extent || extent->size_m < kSmallest * size_range_m.first ||
        extent->size_m > kLargest * size_range_m.second ||
        extent->sigma_m > kVagueSize * extent->size_m)
      return std::nullopt;
    size = out.size_m = extent->size_m;
    out.size_sigma_m =
        std::hypot(extent->sigma_m, is_checker ? kAskew * setting.tolerance_m / 2 : 0);
    out.misfit = extent->misfit;
    out.contrast_to_noise = extent->contrast_to_noise;
    round_chance = extent->round_chance;
    out.place += out.measured.centre;
    out.measured.centre = {};
  }
  out.pattern_confidence = chance_of_pattern(at.kind, out.misfit) * round_chance;
  return out;
}

void require_brightness(const Cloud& cloud, const Column& intensity, const std::string& name) {
  const double first = cloud.size() > 0 ? intensity.number(0) : 0;
  for (size_t i = 1; i < cloud.size(); ++i)
    if (intensity.number(i) != first) return;
  fail(
      Status::kInsufficientData,
      "field \"%s\" is the same everywhere: no pattern shows; targets need a scan with intensities",
      name.c_str());
}

// A quadrant of a checker, read as a disc.
bool is_quadrant_of(const RecognisedTarget& disc, const RecognisedTarget& checker) {
  if (disc.measured.kind != TargetKind::kDisc || checker.measured.kind != TargetKind::kChecker)
    return false;
  const double apart = norm(disc.centre() - checker.centre()) / checker.size_m;
  return disc.size_m < checker.size_m && apart > kSameCentre && apart < kSamePlace;
}

// Readings of the same pattern: the likelier stands; another kind that is about as likely makes it ambiguous.
std::vector<RecognisedTarget> best_readings(std::vector<RecognisedTarget> read) {
  std::vector<RecognisedTarget> all;
  for (const RecognisedTarget& reading : read)
    if (std::none_of(read.begin(), read.end(),
                     [&](const auto& o) { return is_quadrant_of(reading, o); }))
      all.push_back(reading);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.misfit != b.misfit ? a.misfit < b.misfit : a.size_m > b.size_m;
  });
  std::vector<RecognisedTarget> out;
  for (RecognisedTarget& reading : all) {
    const auto apart = [&](const RecognisedTarget& o) {
      return norm(o.centre() - reading.centre()) / std::max(o.size_m, reading.size_m);
    };
    const auto same = std::find_if(
        out.begin(), out.end(), [&](const RecognisedTarget& o) { return apart(o) < kSamePlace; });
    if (same == out.end()) {
      out.push_back(reading);
      continue;
    }
    const bool is_part = reading.size_m < same->size_m && apart(*same) > kSameCentre;
    if (same->measured.kind != reading.measured.kind && !is_part &&
        reading.pattern_confidence > kAlikeReadings * same->pattern_confidence)
      same->verdict = TargetVerdict::kAmbiguous;
  }
  return out;
}

// Those of one plane follow each other, the planes in the order of their first targets: codes of windows come in pairs
// of a facade.
std::vector<RecognisedTarget> by_facade(std::vector<RecognisedTarget> all) {
  std::vector<RecognisedTarget> out;
  std::vector<bool> is_taken(all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    const Vec3 n = all[i].measured.normal;
    for (size_t k = i; k < all.size(); ++k) {
      const double off = dot(all[k].centre() - all[i].centre(), n);
      const bool same = std::fabs(dot(all[k].measured.normal, n)) > kSameDirection &&
                        std::fabs(off) < kSameFacade_m;
      if (is_taken[k] || !(same || k == i)) continue;
      is_taken[k] = true;
      out.push_back(all[k]);
    }
  }
  return out;
}

}  // namespace

void judge(const TargetCatalogue& catalogue, double least_confidence, RecognisedTarget& target) {
  const bool has_two_readings = target.verdict == TargetVerdict::kAmbiguous;
  const double sigma = std::hypot(target.size_sigma_m, catalogue.size_sigma_m);
  std::vector<std::pair<double, int32_t>> fits;
  double sum = kForeignShare / target.size_m;
  for (size_t i = 0; i < catalogue.entries.size(); ++i) {
    const CatalogueEntry& e = catalogue.entries[i];
    if (e.kind != target.measured.kind) continue;
    const double z = (target.size_m - e.size_m) / sigma;
    if (!(std::fabs(z) <= kEntryFits)) continue;
    const double density = std::exp(-z * z / 2) / (sigma * std::sqrt(2 * std::numbers::pi));
    fits.emplace_back(density, static_cast<int32_t>(i));
    sum += density;
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  target.entry = target.second = -1;
  target.confidence = target.pattern_confidence;
  if (!fits.empty()) {
    target.entry = fits[0].second;
    target.confidence *= fits[0].first / sum;
    if (fits.size() > 1 && fits[1].first / sum > kAlsoFits) target.second = fits[1].second;
  }
  if (target.pattern_confidence < least_confidence) target.verdict = TargetVerdict::kUncertain;
  else if (has_two_readings) target.verdict = TargetVerdict::kAmbiguous;
  else if (fits.empty()) target.verdict = TargetVerdict::kForeign;
  else if (target.confidence >= least_confidence) target.verdict = TargetVerdict::kKnown;
  else target.verdict = target.second >= 0 ? TargetVerdict::kAmbiguous : TargetVerdict::kUncertain;
}

std::vector<RecognisedTarget> recognised_targets(const Cloud& cloud,
                                                 const TargetCatalogue& catalogue,
                                                 const MeasuringSettings& settings, Task& task) {
  const Column* intensity = cloud.fields.find(settings.intensity_field);
  if (intensity == nullptr)
    fail(Status::kNotFound,
         "the scan has no field \"%s\": targets are recognised by their brightness",
         settings.intensity_field.c_str());
  require_brightness(cloud, *intensity, settings.intensity_field);
  const auto tree = cloud.octree(task);
  std::set<std::pair<TargetKind, double>> sought;
  std::pair<double, double> range{INFINITY, 0};
  for (const CatalogueEntry& e : catalogue.entries) {
    sought.insert({e.kind, e.size_m});
    range = {std::min(range.first, e.size_m), std::max(range.second, e.size_m)};
  }
  std::vector<PatternPlace> places;
  for (const auto& [kind, size] : sought) {
    const auto found = pattern_places(cloud, *tree, *intensity, kind, size, settings.tolerance_m,
                                      settings.min_points, task);
    places.insert(places.end(), found.begin(), found.end());
  }
  std::vector<std::optional<RecognisedTarget>> read(places.size());
  parallel_for(task, places.size(), 1, [&](size_t begin, size_t end) {
    Task own({.threads = 1});  // the adjustments within are serial
    for (size_t i = begin; i < end; ++i)
      read[i] = read_at(cloud, *tree, *intensity, places[i], settings, range, own);
  });
  std::vector<RecognisedTarget> all;
  for (const auto& r : read)
    if (r && r->pattern_confidence >= kLeastPattern) all.push_back(*r);
  std::vector<RecognisedTarget> out = best_readings(std::move(all));
  for (RecognisedTarget& target : out) judge(catalogue, settings.confidence, target);
  std::sort(out.begin(), out.end(), [](const RecognisedTarget& a, const RecognisedTarget& b) {
    const Vec3 p = a.centre(), q = b.centre();
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  return by_facade(std::move(out));
}

FieldTable recognise_targets(const Cloud& cloud, const MeasuringSettings& settings, Task& task) {
  const auto found =
      recognised_targets(cloud, target_catalogue_from_json(settings.catalogue), settings, task);
  std::vector<MeasuredTarget> measured;
  std::vector<Vec3> places;
  for (const RecognisedTarget& t : found) measured.push_back(t.measured), places.push_back(t.place);
  FieldTable table = measured_table(measured, places);
  using Row = const RecognisedTarget&;
  add_column<double>(table, found, "size", "m", "edge of a checker, diameter of a disc",
                     [](Row r) { return r.size_m; });
  add_column<double>(table, found, "size_sigma", "m", "its standard deviation",
                     [](Row r) { return r.size_sigma_m; });
  add_column<uint8_t>(table, found, "verdict", "", "JALON_RECOGNISED_...",
                      [](Row r) { return static_cast<uint8_t>(r.verdict); });
  add_column<int32_t>(table, found, "entry", "", "of the catalogue that fits best; -1: none",
                      [](Row r) { return r.entry; });
  add_column<int32_t>(table, found, "second", "", "entry that fits as well; -1: none",
                      [](Row r) { return r.second; });
  add_column<double>(table, found, "confidence", "1", "that it is that entry",
                     [](Row r) { return r.confidence; });
  add_column<double>(table, found, "pattern_confidence", "1", "that it is a target",
                     [](Row r) { return r.pattern_confidence; });
  add_column<double>(table, found, "misfit", "1", "share of the brightness left unexplained",
                     [](Row r) { return r.misfit; });
  return table;
}

}  // namespace jalon
