// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/orientation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace jalon {

namespace {

struct Name {
  std::string_view text;
  Orientation orientation;
};
constexpr Name kNames[] = {{"parallel", Orientation::kParallel},
                           {"vertical", Orientation::kVertical},
                           {"horizontal", Orientation::kHorizontal},
                           {"inclined", Orientation::kInclined}};
constexpr std::string_view kSeparators = " ,;";

Orientation named(std::string_view word) {
  for (const Name& name : kNames)
    if (name.text == word) return name.orientation;
  fail(Status::kInvalidArgument,
       "orientation_order: \"%.*s\" is none of parallel, vertical, horizontal, inclined",
       static_cast<int>(std::min<size_t>(word.size(), 40)), word.data());
}

}  // namespace

OrientationOrder orientation_order(std::string_view text) {
  OrientationOrder order;
  for (;;) {
    const size_t begin = text.find_first_not_of(kSeparators);
    if (begin == std::string_view::npos) return order;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(kSeparators));
    text.remove_prefix(word.size());
    const Orientation orientation = named(word);
    const auto end = order.classes.begin() + order.count;
    if (std::find(order.classes.begin(), end, orientation) != end)
      fail(Status::kInvalidArgument, "orientation_order names \"%.*s\" twice",
           static_cast<int>(word.size()), word.data());
    order.classes[order.count++] = orientation;
  }
}

FacadeAxes FacadeAxes::of(const Vec3& normal) {
  FacadeAxes axes;
  axes.across = normalized({normal.x, normal.y, 0});
  axes.along = cross({0, 0, 1}, axes.across);
  return axes;
}

Orientation FacadeAxes::classify(const Vec3& n, double tolerance_rad) const {
  const double cosine = std::cos(tolerance_rad);
  return std::fabs(dot(n, across)) >= cosine  ? Orientation::kParallel
         : std::fabs(dot(n, along)) >= cosine ? Orientation::kVertical
         : std::fabs(n.z) >= cosine           ? Orientation::kHorizontal
                                              : Orientation::kInclined;
}

Vec3 FacadeAxes::axis(Orientation orientation) const {
  switch (orientation) {
    case Orientation::kParallel:
      return across;
    case Orientation::kVertical:
      return along;
    case Orientation::kHorizontal:
      return {0, 0, 1};
    case Orientation::kInclined:
    case Orientation::kNone:
      break;
  }
  fail(Status::kInternal, "planes of class %d have no axis", static_cast<int>(orientation));
}

}  // namespace jalon
