// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/text_number.h"
#include "segment/codes/coded_object.h"
#include "scan/scanner.h"
#include "scan/yard/plan.h"
#include "scan/yard/yard.h"
#include "segment/codes_methods.h"

namespace jalon::test {

/// Classes of points against the truth: rest, walls, doors, windows, gutters.
struct ClassFigures {
  std::array<std::array<uint64_t, 5>, 5> counts{};  ///< [truth][given]

  uint64_t row(size_t c) const {
    uint64_t n = 0;
    for (const uint64_t k : counts[c]) n += k;
    return n;
  }
  uint64_t column(size_t c) const {
    uint64_t n = 0;
    for (const auto& r : counts) n += r[c];
    return n;
  }
  double precision(size_t c) const { return ratio(counts[c][c], column(c)); }
  double recall(size_t c) const { return ratio(counts[c][c], row(c)); }
  double f1(size_t c) const {
    const double p = precision(c), r = recall(c);
    return p + r > 0 ? 2 * p * r / (p + r) : 0;
  }
  double overall() const {
    uint64_t right = 0, all = 0;
    for (size_t c = 0; c < 5; ++c) right += counts[c][c], all += row(c);
    return ratio(right, all);
  }
  /// Over the classes that the truth has, the rest included.
  double mean_f1() const {
    double sum = 0, n = 0;
    for (size_t c = 0; c < 5; ++c)
      if (row(c) > 0) sum += f1(c), ++n;
    return n > 0 ? sum / n : 0;
  }
  std::string text() const {
    std::string out =
        "oAcc " + jalon::text_of(overall(), 4) + ", mean F1 " + jalon::text_of(mean_f1(), 3);
    for (size_t c = 0; c < 5; ++c)
      if (row(c) > 0)
        out += std::string(", ") + kNames[c] + " " + jalon::text_of(precision(c), 3) + " " +
               jalon::text_of(recall(c), 3) + " " + jalon::text_of(f1(c), 3);
    return out;
  }
  /// Points by truth / given class, of those that got another class than theirs.
  std::string confusions() const {
    std::string out;
    for (size_t t = 0; t < 5; ++t)
      for (size_t g = 0; g < 5; ++g)
        if (t != g && counts[t][g] > 0)
          out += std::string(out.empty() ? "" : ", ") + kNames[t] + " as " + kNames[g] + " " +
                 std::to_string(counts[t][g]);
    return out;
  }

 private:
  static constexpr const char* kNames[] = {"rest", "walls", "doors", "windows", "gutters"};
  static double ratio(uint64_t part, uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// Points of a scan over the parts of a yard: all walls alike, or as the source's tables of classes tell of its own.
enum class YardDensity { kEven, kSource };

/// Shares of the points that the even density has. Of the source's walls (table 4) 3.0 % are rest by targets; reveals
/// deeper than their 6 cm are 14.3 m2 beside 196 m2 of walls, so that they have at most 0.43 of the
/// walls' density. Of its doors (table 8) the two that are flush, 5.80 m2, hold 50 833 points and the others, 6.29 m2,
/// 159 831. Of its gutters the two without target hold at most the 4 901 points that are rest, the four others 52 191.
constexpr double kSourceReveals = 0.4, kSourceFlushDoors = 0.34, kSourceFarGutters = 0.19;

/// From how far aside the source's scans saw its gutters: then the cylinders about their surveyed axes hold as many
/// points of the wall behind them, whose rest the pipe hides, as in its table 9 (10 663 of 13 444 142, 0.08 %).
constexpr double kSourceAside_rad = 60 * std::numbers::pi / 180;

/// Of the level directions in which a place of a wall can be seen, the share that a pipe before it does not hide.
inline double seen_share(const Vec2& place, const yard::Gutter& gutter) {
  const Vec2 to_axis = gutter.centre - place;
  const double apart = norm(to_axis);
  if (apart <= yard::kGutterRadius_m) return 0;
  const double middle = std::atan2(cross(gutter.outward, to_axis), dot(gutter.outward, to_axis)),
               half = std::asin(yard::kGutterRadius_m / apart);
  const double hidden =
      std::min(middle + half, kSourceAside_rad) - std::max(middle - half, -kSourceAside_rad);
  return 1 - std::max(0.0, hidden) / (2 * kSourceAside_rad);
}

/// How much of the even density a point of the scene's facades keeps.
inline double source_share(const Vec3& in_scene, uint8_t given_class,
                           const std::vector<yard::Gutter>& gutters) {
  constexpr uint8_t kWallClass = 1, kDoorClass = 2, kGutterClass = 4;
  constexpr double kAboutDoor_m = 1.5, kAboutGutter_m = 0.3;
  constexpr Vec2 kFlushDoors[] = {{49.50, 90.75}, {62.74, 71.48}};
  constexpr Vec2 kFarGutters[] = {{48.463, 91.871}, {44.070, 96.126}};
  const auto is_about = [&](const auto& places, double reach_m) {
    return std::any_of(std::begin(places), std::end(places),
                       [&](const Vec2& q) { return norm(in_plan(in_scene) - q) < reach_m; });
  };
  if (given_class == kDoorClass && is_about(kFlushDoors, kAboutDoor_m)) return kSourceFlushDoors;
  if (given_class == kGutterClass && is_about(kFarGutters, kAboutGutter_m))
    return kSourceFarGutters;
  if (given_class == kWallClass)
    for (const yard::Gutter& gutter : gutters)
      if (norm(Vec2{in_scene.x, in_scene.y} - gutter.centre) < kAboutGutter_m)
        return seen_share({in_scene.x, in_scene.y}, gutter);
  return 1;
}

constexpr double kGlassReturn = 0.05;  // of panes, as the scene is told

/// A yard, scanned, with its code lists and the class of each point.
struct CodedYard {
  CloudPtr cloud;
  std::vector<uint8_t> truth;
  std::string survey, targets;

  CodedYard(const YardSettings& yard, uint64_t seed, double spacing_m,
            YardDensity density = YardDensity::kEven, double glass_return = kGlassReturn) {
    SceneSettings scene{.name = SceneName::kYard, .seed = seed};
    scene.yard = yard;
    Task task;
    const Model model = build_scene(scene, task);
    SampleSettings sample;
    sample.spacing_m = spacing_m;
    sample.noise_m = 0.002;
    sample.seed = seed;
    sample.surfaces.glass_return_min = sample.surfaces.glass_return_max = glass_return;
    // Targets are as dense as the source's cloud, 60 000 points/m2; gutters are grown in steps of 2 cm.
    sample.densities = "ground=0.3,target=" + jalon::text_of(60000 * spacing_m * spacing_m);
    if (yard.zone != YardZone::kComplete)
      sample.densities += ",gutter=" + jalon::text_of(std::pow(spacing_m / 0.01, 2));
    if (density == YardDensity::kSource)
      sample.densities += ",reveal=" + jalon::text_of(kSourceReveals);
    cloud = std::make_shared<const Cloud>(scan_sample(model, {}, sample, task));
    const YardTruth known = yard_truth(scene);
    for (const uint32_t face : cloud->fields.require("face").values<uint32_t>())
      truth.push_back(face >= 1 && face <= known.face_classes.size() ? known.face_classes[face - 1]
                                                                     : uint8_t{0});
    if (density == YardDensity::kSource) thin(jalon::yard::plan_of(yard, seed).gutters, seed, task);
    for (const std::string& line : known.survey) survey += line + "\n";
    for (const std::string& line : known.targets) targets += line + "\n";
  }

  ClassFigures of(const Segmentation& coded) const {
    ClassFigures figures;
    const auto given = coded.cloud->fields.require("classification").values<uint8_t>();
    for (size_t i = 0; i < truth.size(); ++i) ++figures.counts[truth[i]][given[i]];
    return figures;
  }

 private:
  void thin(const std::vector<yard::Gutter>& gutters, uint64_t seed, Task& task) {
    constexpr uint64_t kThinStream = 22;
    RandomStream random(seed, kThinStream);
    std::vector<uint64_t> kept;
    const Vec3 shift{kYardShift_m[0], kYardShift_m[1], kYardShift_m[2]};
    for (size_t i = 0; i < truth.size(); ++i)
      if (random.uniform() < source_share(cloud->point(i) - shift, truth[i], gutters))
        kept.push_back(i);
    for (size_t k = 0; k < kept.size(); ++k) truth[k] = truth[kept[k]];
    truth.resize(kept.size());
    cloud = std::make_shared<const Cloud>(select(*cloud, kept, task));
  }
};

}  // namespace jalon::test
