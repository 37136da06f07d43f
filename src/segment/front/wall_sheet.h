// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "segment/front/walls.h"

namespace jalon {

/// A place before a wall: along it, up it, and out of its plane along the plane's normal.
struct WallPlace {
  double u = 0, v = 0, d = 0;
};

/// Where a wall was measured: the cells of its plane that hold points of it.
class WallSheet {
 public:
  /// origin: of the segments' frame. O(points).
  WallSheet(const Cloud& cloud, const Vec3& origin, std::span<const uint32_t> labels,
            const std::vector<Segment>& segments, const WallGroup& group, Task& task);

  /// p: in the segments' frame.
  WallPlace place_of(const Vec3& p) const {
    return {dot(p, along_), dot(p, up_), plane_.distance(p)};
  }
  double off_plane_m(const Vec3& p) const { return plane_.distance(p); }
  /// In the segments' frame.
  Vec3 point_of(const WallPlace& p) const {
    return p.u * along_ + p.v * up_ + (p.d + plane_.offset) * plane_.normal;
  }
  const Vec3& normal() const { return plane_.normal; }
  double cell_m() const { return cell_m_; }
  size_t cells() const { return columns_ * rows_; }
  double left() const { return left_; }
  double right() const { return left_ + cell_m_ * static_cast<double>(columns_); }
  double foot() const { return foot_; }
  double top() const { return foot_ + cell_m_ * static_cast<double>(rows_); }
  WallPlace middle_of(size_t cell) const {
    return {left_ + cell_m_ * (static_cast<double>(cell % columns_) + 0.5),
            foot_ + cell_m_ * (static_cast<double>(cell / columns_) + 0.5), 0};
  }
  /// cells() outside of the sheet's box.
  size_t cell_of(double u, double v) const;

  /// Measured all about: a beam does not pass here.
  bool is_solid(size_t cell) const { return kind_[cell] == Kind::kSolid; }
  /// Between what was measured of the wall, and nothing about: an opening or a shadow.
  bool is_open(size_t cell) const { return kind_[cell] == Kind::kOpen; }

 private:
  enum class Kind : uint8_t { kOutside, kSolid, kOpen, kBorder };
  void tell_kinds(const std::vector<uint8_t>& is_measured);

  Plane plane_;
  Vec3 along_, up_;
  double cell_m_ = 1, left_ = 0, foot_ = 0;
  size_t columns_ = 0, rows_ = 0;
  std::vector<Kind> kind_;
};

}  // namespace jalon
