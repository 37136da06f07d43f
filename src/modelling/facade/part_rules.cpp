// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/part_rules.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr double kLevel = 0.94;     // |nz| of a plane within 20 degrees of level: slabs have a fall
constexpr double kUpright = 0.342;  // within 20 degrees of upright
constexpr double kFacing = 0.94;    // within 20 degrees of the facade's direction
constexpr double kFront_m = 0.01;   // in front of the wall
constexpr double kLong = 3;         // times as long as high or deep
constexpr double kGroundArea_m2 = 2, kGroundAbove_m = 1, kRoofArea_m2 = 4, kTop_m = 1;
constexpr double kSillGap_m = 0.15, kSillBeside_m = 0.5, kSillHeight_m = 0.5;
constexpr double kBaseHeight_m = 1.5, kBaseFoot_m = 0.5;
constexpr double kCourse_m = 1, kPostWidth_m = 1;

struct Element {
  const ElementShape& e;
  const FacadeShape& f;

  double width() const { return e.box.max.x - e.box.min.x; }
  double depth() const { return e.box.max.y - e.box.min.y; }
  double height() const { return e.box.max.z - e.box.min.z; }
  bool is_level() const { return std::fabs(e.normal.z) >= kLevel; }
  bool is_upright() const { return std::fabs(e.normal.z) <= kUpright; }
  bool is_facing() const { return std::fabs(e.normal.y) >= kFacing; }
  bool is_before() const { return e.box.max.y > kFront_m; }
  bool is_long() const { return width() >= kLong * std::max(height(), is_level() ? depth() : 0.0); }

  bool is_ground() const {
    return is_level() && e.area_m2 >= kGroundArea_m2 &&
           e.box.max.z <= f.box.min.z + kGroundAbove_m && e.box.max.y > kGroundAbove_m;
  }
  bool is_sill() const {
    if (!is_before() || height() > kSillHeight_m || !(is_level() || is_facing())) return false;
    return std::any_of(f.openings.begin(), f.openings.end(), [&](const Box3& o) {
      return e.box.max.z <= o.min.z + kSillGap_m && e.box.max.z >= o.min.z - kSillGap_m &&
             e.box.min.x >= o.min.x - kSillBeside_m && e.box.max.x <= o.max.x + kSillBeside_m;
    });
  }
  bool is_roof() const {
    return !is_upright() && e.area_m2 >= kRoofArea_m2 && e.box.max.z >= f.box.max.z - kTop_m &&
           e.box.min.y < -kTop_m;
  }
  bool is_cornice() const {
    return is_before() && is_long() && (is_level() || is_facing()) &&
           e.box.max.z >= f.box.max.z - kTop_m;
  }
  bool is_base_course() const {
    return is_before() && is_long() && is_facing() && height() <= kBaseHeight_m &&
           e.box.min.z <= f.box.min.z + kBaseFoot_m;
  }
  bool is_string_course() const {
    return is_before() && is_long() &&
           (is_level() ? depth() <= kCourse_m : is_facing() && height() <= kCourse_m);
  }
  bool is_post() const {
    return is_before() && is_upright() && std::max(width(), depth()) <= kPostWidth_m &&
           height() >= kLong * std::max(width(), depth());
  }
};

}  // namespace

const char* class_of_element(const ElementShape& shape, const FacadeShape& facade) {
  const Element element{shape, facade};
  if (facade.box.empty()) return part_class::kElement;
  if (element.is_ground()) return part_class::kGround;
  if (element.is_sill()) return part_class::kSill;
  if (element.is_roof()) return part_class::kRoof;
  if (element.is_cornice()) return part_class::kCornice;
  if (element.is_base_course()) return part_class::kBaseCourse;
  if (element.is_string_course()) return part_class::kStringCourse;
  if (element.is_post()) return part_class::kPost;
  return part_class::kElement;
}

std::vector<std::string> row_numbers(const std::vector<Box3>& boxes) {
  std::vector<size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto middle = [&](size_t i) { return (boxes[i].min.z + boxes[i].max.z) / 2; };
  const auto height = [&](size_t i) { return boxes[i].max.z - boxes[i].min.z; };
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return middle(a) < middle(b); });
  std::vector<std::string> out(boxes.size());
  size_t row = 0;
  for (size_t first = 0; first < order.size();) {
    size_t end = first + 1;
    while (end < order.size() && middle(order[end]) - middle(order[end - 1]) <
                                     0.5 * std::min(height(order[end]), height(order[end - 1])))
      ++end;
    std::stable_sort(order.begin() + static_cast<ptrdiff_t>(first),
                     order.begin() + static_cast<ptrdiff_t>(end),
                     [&](size_t a, size_t b) { return boxes[a].min.x < boxes[b].min.x; });
    ++row;
    for (size_t k = first; k < end; ++k)
      out[order[k]] = std::to_string(row) + "." + std::to_string(k - first + 1);
    first = end;
  }
  return out;
}

}  // namespace jalon
