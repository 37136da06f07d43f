// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/clearance_places.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/charts/column_vector.h"
#include "solid/motion.h"

namespace jalon {

GaugePath::GaugePath(std::vector<Transform> poses) : poses_(std::move(poses)) {
  chainage_.push_back(0);
  for (size_t i = 1; i < poses_.size(); ++i)
    chainage_.push_back(chainage_.back() +
                        norm(poses_[i].translation() - poses_[i - 1].translation()));
}

// A parameter beyond the ends, or none, is that of an end.
GaugePath::Step GaugePath::step(double parameter) const {
  const size_t last = poses_.size() - 1;
  if (last == 0 || !(parameter > 0)) return {0, std::min<size_t>(1, last), 0};
  const double at = std::min(parameter, static_cast<double>(last));
  const size_t from = std::min(static_cast<size_t>(at), last - 1);
  return {from, from + 1, at - static_cast<double>(from)};
}

double GaugePath::chainage_m(double parameter) const {
  const auto [i, next, share] = step(parameter);
  return chainage_[i] + share * (chainage_[next] - chainage_[i]);
}

Transform GaugePath::section_of_gauge(double parameter) const {
  const auto [i, next, t] = step(parameter);
  const Motion motion(poses_[i], poses_[next]);
  const Vec3 travel = poses_[next].translation() - poses_[i].translation(),
             origin = poses_[i].translation();
  const Vec3 seen =
      motion.seen_at(motion.start(origin + travel), t) - motion.seen_at(motion.start(origin), t);
  // A gauge that stands or only turns is looked at along its own x.
  const Vec3 ahead = norm(travel) > 0 ? normalized(seen) : Vec3{1, 0, 0};
  const Vec3 upright = std::abs(ahead.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 right = normalized(cross(ahead, upright)), up = cross(right, ahead), back = -ahead;
  return {{right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, back.x, back.y, back.z, 0}};
}

Transform GaugePath::section(double parameter) const {
  const auto [i, next, t] = step(parameter);
  const Motion motion(poses_[i], poses_[next]);
  const Vec3 o = motion.to_world({0, 0, 0}, t);
  const Vec3 x = motion.to_world({1, 0, 0}, t) - o, y = motion.to_world({0, 1, 0}, t) - o,
             z = motion.to_world({0, 0, 1}, t) - o;
  const Transform world_of_gauge{{x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z}};
  return section_of_gauge(parameter) * inverse(world_of_gauge);
}

std::vector<TightPlace> tight_places(const FieldTable& places, const GaugePath& path,
                                     double apart_m, size_t most) {
  const Column &clearance = places.require("clearance"), &parameter = places.require("parameter"),
               &xyz = places.require("xyz"), &foot = places.require("gauge_xyz");
  std::vector<size_t> order(clearance.count());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return clearance.number(a) < clearance.number(b); });
  std::vector<TightPlace> out;
  for (const size_t row : order) {
    if (out.size() == most) break;
    const Vec3 at = vector_at(xyz, row);
    const auto is_near = [&](const TightPlace& other) {
      return norm(other.obstacle - at) < apart_m;
    };
    if (!std::isfinite(clearance.number(row)) || std::any_of(out.begin(), out.end(), is_near))
      continue;
    TightPlace place;
    place.row = row;
    place.parameter = parameter.number(row);
    place.chainage_m = path.chainage_m(place.parameter);
    place.clearance_m = clearance.number(row);
    place.obstacle = at;
    const Transform section = path.section(place.parameter);
    place.in_section = section.point(at);
    place.gauge_in_section = section.point(vector_at(foot, row));
    out.push_back(place);
  }
  return out;
}

}  // namespace jalon
