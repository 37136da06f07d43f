// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/near_wall.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kNearPointsPerChunk = 1 << 15;
constexpr double kNear_m = 1;         // of what fills an opening or hangs on a wall
constexpr double kLeastOff_m = 0.04;  // a wall's own bulges and noise are nearer to its plane
constexpr double kOffSigmas = 4;
// Ground: pavements and kerbs along a house, a step or a low plinth above or below its foot.
constexpr double kGroundReach_m = 4, kGroundStep_m = 1, kGroundCell_m = 0.25;

enum Mark : uint8_t { kBefore = 1, kBehind = 2 };

void set_mark(uint8_t& cell, Mark mark) {
  std::atomic_ref<uint8_t>(cell).fetch_or(mark, std::memory_order_relaxed);
}

BothSides areas(const std::vector<uint8_t>& marks, double cell_m, auto&& counts) {
  BothSides out;
  for (size_t cell = 0; cell < marks.size(); ++cell) {
    if (marks[cell] == 0 || !counts(cell)) continue;
    if ((marks[cell] & kBefore) != 0) out.before += cell_m * cell_m;
    if ((marks[cell] & kBehind) != 0) out.behind += cell_m * cell_m;
  }
  return out;
}

// Cells of the ground along a wall, the same on either side of it.
struct GroundStrip {
  double left, foot;
  size_t columns, rows;

  explicit GroundStrip(const WallSheet& sheet)
      : left(sheet.left()),
        foot(sheet.foot()),
        columns(static_cast<size_t>((sheet.right() - sheet.left()) / kGroundCell_m) + 1),
        rows(static_cast<size_t>(kGroundReach_m / kGroundCell_m) + 1) {}
  size_t cells() const { return columns * rows; }
  /// cells() outside.
  size_t cell_of(const WallPlace& p) const {
    const double column = std::floor((p.u - left) / kGroundCell_m),
                 row = std::floor(std::fabs(p.d) / kGroundCell_m);
    if (!(column >= 0 && column < static_cast<double>(columns) && row < static_cast<double>(rows)))
      return cells();
    return static_cast<size_t>(row) * columns + static_cast<size_t>(column);
  }
};

// By label: what a point is a part of. Walls that meet it at a corner recede or stand out, and say nothing.
enum class Role : uint8_t { kOther, kWall, kLevel };
constexpr double kCornerWall_m2 = 4;
std::vector<Role> roles_of(const std::vector<Segment>& segments, const WallGroup& group) {
  const Vec3 normal = segments[group.main].fit.plane.normal;
  std::vector<Role> out(segments.size() + 1, Role::kOther);
  for (size_t s = 0; s < segments.size(); ++s)
    if (segments[s].has_plane() && std::fabs(segments[s].fit.plane.normal.z) >= kSameDirection)
      out[s + 1] = Role::kLevel;
    else if (is_upright(segments[s]) && segments[s].area_m2 >= kCornerWall_m2 &&
             std::fabs(dot(segments[s].fit.plane.normal, normal)) < kSameDirection)
      out[s + 1] = Role::kWall;
  for (const size_t member : group.members) out[member + 1] = Role::kWall;
  return out;
}

}  // namespace

void look_near(const Cloud& cloud, const Vec3& origin, std::span<const uint32_t> labels,
               const std::vector<Segment>& segments, const WallGroup& group, const WallSheet& sheet,
               FrontEvidence& evidence, Task& task) {
  const std::vector<Role> roles = roles_of(segments, group);
  const double least_off_m = std::max(kLeastOff_m, kOffSigmas * segments[group.main].fit.sigma);
  const GroundStrip strip(sheet);
  std::vector<uint8_t> near(sheet.cells() + 1, 0), ground(strip.cells() + 1, 0);
  parallel_for(task, cloud.size(), kNearPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Role role = roles[labels[i]];
      if (role == Role::kWall) continue;
      const Vec3 at = cloud.point(i) - origin;
      const double off_m = std::fabs(sheet.off_plane_m(at));
      if (off_m < least_off_m || off_m > kGroundReach_m) continue;
      const WallPlace p = sheet.place_of(at);
      const Mark mark = p.d > 0 ? kBefore : kBehind;
      if (role == Role::kLevel && std::fabs(p.v - sheet.foot()) <= kGroundStep_m)
        set_mark(ground[strip.cell_of(p)], mark);
      if (off_m <= kNear_m) set_mark(near[sheet.cell_of(p.u, p.v)], mark);
    }
  });
  near.pop_back();  // what lies outside
  ground.pop_back();
  evidence.filling = areas(near, sheet.cell_m(), [&](size_t cell) { return sheet.is_open(cell); });
  evidence.hung = areas(near, sheet.cell_m(), [&](size_t cell) { return sheet.is_solid(cell); });
  evidence.ground = areas(ground, kGroundCell_m, [](size_t) { return true; });
}

}  // namespace jalon
