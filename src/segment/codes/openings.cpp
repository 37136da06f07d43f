// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/openings.h"

#include <algorithm>

#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kDeepestReveal_m =
    0.5;  // measured ones reach 0.21 m; faults of the annex 2.2 and 12 m

OpeningCorners faulty(std::string why, size_t at) { return {{}, {}, std::move(why), at}; }

bool is_offset(const CodedPoint& point, int64_t modifier) { return point.modifier == modifier; }

// The recessed twin and the front corner it belongs to, and what follows from their step.
OpeningCorners stepped(const CodedPoint& front, const CodedPoint& twin, const Vec3& at_frame,
                       const Vec3& other_front, size_t twin_number) {
  const Vec3 step = twin.position - front.position;
  if (norm(step) > kDeepestReveal_m)
    return faulty("point " + twin.id + " lies " + text_of(norm(step), 3) + " m from its corner " +
                      front.id + ", 0.5 m at most: left out",
                  twin_number);
  return {at_frame, other_front + step, "", 0};
}

OpeningCorners of_three(std::span<const CodedPoint> p, int64_t modifier) {
  const auto offset =
      std::find_if(p.begin(), p.end(), [&](const CodedPoint& q) { return is_offset(q, modifier); });
  const auto offsets = std::count_if(p.begin(), p.end(),
                                     [&](const CodedPoint& q) { return is_offset(q, modifier); });
  if (offsets != 1)
    return faulty(std::to_string(offsets) + " offset points, one is needed: left out", 0);
  const auto r = static_cast<size_t>(offset - p.begin());
  if (r == 0) return faulty("the offset point " + p[0].id + " follows no corner: left out", 0);
  const size_t other = r == 1 ? 2 : 0;
  return stepped(p[r - 1], p[r], p[r].position, p[other].position, r);
}

OpeningCorners of_four(std::span<const CodedPoint> p, int64_t modifier) {
  for (size_t i = 0; i < p.size(); ++i)
    if (is_offset(p[i], modifier) != (i >= 2))
      return faulty(
          "the 3rd and 4th point are offset, no others; " + p[i].id + " breaks that: left out", i);
  return stepped(p[1], p[2], p[3].position, p[0].position, 2);
}

}  // namespace

OpeningCorners opening_corners(std::span<const CodedPoint> points, int64_t offset_modifier) {
  OpeningCorners corners;
  if (points.size() == 2) corners = {points[0].position, points[1].position, "", 0};
  else
    corners =
        points.size() == 3 ? of_three(points, offset_modifier) : of_four(points, offset_modifier);
  if (!corners.fault.empty()) return corners;
  const Vec3 across = corners.b - corners.a;
  if (across.x == 0 && across.y == 0)
    return faulty("its corners stand above each other: left out", 0);
  return corners;
}

}  // namespace jalon
