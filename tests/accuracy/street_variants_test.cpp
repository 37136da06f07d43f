// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The real facades made unlike themselves: pieces of them, mirrored, wider, higher, deeper, larger, with fewer points,
// more noise or a density that falls off, by draws. Stations are none, all parameters the default ones.
// JALON_VARIANT_SEEDS=A-B asks for other draws than the test's own. Long form: JALON_FULL=1.
#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "facade_axes.h"
#include "labelled_street.h"
#include "modelling/facade/facade.h"
#include "recipe.h"
#include "seed_range.h"
#include "segment/ransac_settings.h"
#include "segment/segmentation.h"

namespace jalon::street_variants_test {

using namespace jalon::test;

namespace {

constexpr double kLeastArea_m2 = 0.5, kLeastIou = 0.6;
constexpr double kWhole = 0.98;  // of the points of an opening that a piece still has
constexpr double kOfALabel =
    0.3;  // of an opening of the model: it stands for that label, or for a part of it
// Draws 7 and 11 were developed with: 0.92 and 0.90 found, 0.05 unknown, at most 0.007 with arcs (0.04 before they cost
// what they save). Draws 12 to 15, not looked at before: 0.919, 0.055 and 0.006. No label has an arc.
constexpr double kLeastFound = 0.88, kMostUnknown = 0.1, kMostArcs = 0.02;
constexpr uint64_t kVariantStream = 31;
constexpr SeedRange kShortRun{11, 11}, kFullRun{11, 15};

// Along the wall, up, and out of it, from its middle; extent: of 99 % of the points.
struct WallFrame {
  WallAxes axes;
  RingBox extent;

  Vec3 to(const Vec3& p) const {
    const Vec2 q = axes.project(p);
    return {q.u, q.v, axes.height_m(p)};
  }
  Vec3 from(const Vec3& p) const {
    return axes.origin + axes.u * p.x + axes.v * p.y + axes.n * p.z;
  }
};

WallFrame frame_of(const LabelledStreet& street) {
  Task task;
  const Segmentation planes = segment_ransac(street.cloud, RansacSettings{}, task);
  WallFrame out{WallAxes(planes.segments[0].fit.plane, planes.segments[0].fit.centroid), {}};
  std::vector<double> u, v;
  for (size_t i = 0; i < street.cloud->size(); ++i) {
    const Vec2 p = out.axes.project(street.cloud->point(i));
    u.push_back(p.u), v.push_back(p.v);
  }
  const auto range = [](std::vector<double>& of) {
    std::sort(of.begin(), of.end());
    return Vec2{of[of.size() / 200], of[of.size() - 1 - of.size() / 200]};
  };
  const Vec2 along = range(u), up = range(v);
  out.extent.add(Vec2{along.u, up.u});
  out.extent.add(Vec2{along.v, up.v});
  return out;
}

struct StreetVariant {
  std::string name;
  std::function<bool(const Vec3&)> keeps = [](const Vec3&) { return true; };
  std::function<Vec3(const Vec3&)> moves = [](const Vec3& p) { return p; };
};

std::vector<StreetVariant> variants_of(const RingBox& wall, RandomStream& random) {
  const auto drawn = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const double width = wall.width(), height = wall.height();
  const double left = wall.low.u + drawn(0.5, 0.75) * width,
               right = wall.high.u - drawn(0.5, 0.75) * width, side = drawn(0.12, 0.25) * width,
               top = wall.low.v + drawn(0.5, 0.7) * height;
  const double wider = drawn(1.1, 1.4), higher = drawn(1.1, 1.4), deeper = drawn(0.7, 1.4),
               larger = drawn(0.8, 1.25);
  const double share = drawn(0.55, 0.85), noise_m = drawn(0.002, 0.006), falls_to = drawn(0.3, 0.6);
  return {{"left piece", [=](const Vec3& p) { return p.x < left; }},
          {"right piece", [=](const Vec3& p) { return p.x > right; }},
          {"middle",
           [=](const Vec3& p) { return p.x > wall.low.u + side && p.x < wall.high.u - side; }},
          {"lower storey", [=](const Vec3& p) { return p.y < top; }},
          {"fewer points", [=, &random](const Vec3&) { return random.uniform() < share; }},
          {"density that falls off",
           [=, &random](const Vec3& p) {
             return random.uniform() < 1 - (1 - falls_to) * (p.x - wall.low.u) / width;
           }},
          {"mirrored",
           {},
           [](const Vec3& p) {
             return Vec3{-p.x, p.y, p.z};
           }},
          {"wider",
           {},
           [=](const Vec3& p) {
             return Vec3{p.x * wider, p.y, p.z};
           }},
          {"higher",
           {},
           [=](const Vec3& p) {
             return Vec3{p.x, p.y * higher, p.z};
           }},
          {"deeper",
           {},
           [=](const Vec3& p) {
             return Vec3{p.x, p.y, p.z * deeper};
           }},
          {"larger", {}, [=](const Vec3& p) { return p * larger; }},
          {"more noise", {}, [=, &random](const Vec3& p) {
             return p + Vec3{random.normal(), random.normal(), random.normal()} * noise_m;
           }}};
}

LabelledStreet varied(const LabelledStreet& street, const WallFrame& frame,
                      const StreetVariant& by) {
  std::vector<Vec3> points;
  LabelledStreet out = street;
  out.labels.clear();
  for (size_t i = 0; i < street.cloud->size(); ++i) {
    const Vec3 p = frame.to(street.cloud->point(i));
    if (by.keeps && !by.keeps(p)) continue;
    points.push_back(frame.from(by.moves ? by.moves(p) : p));
    out.labels.push_back(street.labels[i]);
  }
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k];
  out.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  return out;
}

struct VariantFigures {
  size_t wanted = 0, found = 0, named = 0, right = 0, drawn = 0, unknown = 0, arcs = 0;
  VariantFigures& operator+=(const VariantFigures& o) {
    wanted += o.wanted, found += o.found, named += o.named, right += o.right;
    drawn += o.drawn, unknown += o.unknown, arcs += o.arcs;
    return *this;
  }
};

double shared_m2(const Extent2& a, const Extent2& b) {
  const double width = std::min(a.high.u, b.high.u) - std::max(a.low.u, b.low.u),
               height = std::min(a.high.v, b.high.v) - std::max(a.low.v, b.low.v);
  return std::max(0.0, width) * std::max(0.0, height);
}
double area_m2(const Extent2& a) { return shared_m2(a, a); }

VariantFigures figures_of(const LabelledStreet& street,
                          const std::map<std::array<int, 2>, size_t>& whole, std::string& notes) {
  Task task;
  const Model model =
      model_facade(segment_ransac(street.cloud, RansacSettings{}, task), FacadeSettings{}, task);
  const FacadeTruth frame = axes_of_largest(model);
  VariantFigures out;
  if (frame.walls.empty()) return out;
  const FoundFacade found = found_facade(model, frame);
  WallAxes axes;
  axes.origin = frame.walls[0].origin, axes.n = frame.walls[0].normal;
  axes.u = frame.walls[0].along, axes.v = frame.walls[0].up;
  std::map<std::array<int, 2>, size_t> left;
  for (const std::array<int, 2>& label : street.labels) ++left[label];
  // What a piece cuts through is neither asked for nor wrong.
  std::vector<Extent2> labelled;
  for (const Drawn& label : street.openings(axes, 0)) {
    const Extent2 mine = extent_of(label.region);
    labelled.push_back(mine);
    const bool is_door = label.part_class[0] == 'd';
    const std::array<int, 2> key{is_door ? kStreetDoor : kStreetWindow,
                                 std::stoi(label.part_class.substr(label.part_class.find(' ')))};
    const auto all = whole.find(key);
    if (area_m2(mine) < kLeastArea_m2 ||
        (all != whole.end() &&
         static_cast<double>(left[key]) < kWhole * static_cast<double>(all->second)))
      continue;
    ++out.wanted;
    double best = 0;
    const FoundOpening* by = nullptr;
    for (const FoundOpening& opening : found.openings) {
      const Extent2 other = extent_of(opening.drawn.region);
      const double both = shared_m2(mine, other),
                   iou = both / (area_m2(mine) + area_m2(other) - both);
      if (iou > best) best = iou, by = &opening;
    }
    if (best < kLeastIou) {
      notes += "\n    missed " + label.part_class;
      continue;
    }
    ++out.found;
    out.named += by->is_certain();
    out.right += by->is_certain() && (by->part_class == "window") != is_door;
  }
  for (const FoundOpening& opening : found.openings) {
    const Extent2 mine = extent_of(opening.drawn.region);
    ++out.drawn;
    out.arcs += !opening.drawn.arcs.empty();
    const bool is_known = std::any_of(labelled.begin(), labelled.end(), [&](const Extent2& other) {
      return shared_m2(mine, other) >= kOfALabel * area_m2(mine);
    });
    out.unknown += !is_known;
    if (!is_known)
      notes += "\n    unknown " + opening.part_class + " " + text_of_extent(opening.drawn.region);
  }
  return out;
}

std::string text_of(const VariantFigures& f) {
  std::ostringstream out;
  out << f.found << " of " << f.wanted << " doors and windows, class right " << f.right << " of "
      << f.named << ", " << f.unknown << " of " << f.drawn << " openings unknown, " << f.arcs
      << " with arcs";
  return out.str();
}

}  // namespace

TEST_CASE("street_variants__have_their_doors_and_windows_and_few_other_openings") {
  SeedRange seeds = is_full() ? kFullRun : kShortRun;
  if (const auto asked = seeds_asked_for("JALON_VARIANT_SEEDS")) seeds = *asked;
  std::map<std::string, VariantFigures> by_name;
  VariantFigures all;
  for (const std::string file : {"street_1.txt", "street_3.txt", "building_2.txt"}) {
    const LabelledStreet street(file);
    if (street.cloud == nullptr) {
      if (std::getenv("CI") != nullptr) FAIL("JALON_SHARED_DATA holds no facades");
      MESSAGE("skipped: no " << file << " in " << JALON_SHARED_DATA << "/facades");
      return;
    }
    const WallFrame frame = frame_of(street);
    std::map<std::array<int, 2>, size_t> whole;
    for (const std::array<int, 2>& label : street.labels) ++whole[label];
    for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      RandomStream random(seed, kVariantStream);
      for (const StreetVariant& variant : variants_of(frame.extent, random)) {
        const bool is_piece = variant.name.find("piece") != std::string::npos ||
                              variant.name == "middle" || variant.name == "lower storey";
        std::string notes;
        const VariantFigures one =
            figures_of(varied(street, frame, variant), is_piece ? whole : decltype(whole){}, notes);
        MESSAGE("FIGURE " << file << ", seed " << seed << ", " << variant.name << ": "
                          << text_of(one) << notes);
        by_name[variant.name] += one;
        all += one;
      }
    }
  }
  for (const auto& [name, f] : by_name) MESSAGE("FIGURE streets, " << name << ": " << text_of(f));
  MESSAGE("FIGURE streets, all variants: " << text_of(all));
  REQUIRE(all.wanted > 0);
  CHECK(static_cast<double>(all.found) >= kLeastFound * static_cast<double>(all.wanted));
  CHECK(static_cast<double>(all.unknown) <= kMostUnknown * static_cast<double>(all.drawn));
  CHECK(static_cast<double>(all.arcs) <= kMostArcs * static_cast<double>(all.drawn));
}

}  // namespace jalon::street_variants_test
