// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/blocked_points.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kRun = 64;  // points: a box costs as much as three of them
constexpr size_t kBlocksPerGroup = 64, kBlocksPerChunk = 256;
// Of the octree's cube: far above the rounding of a projection, far below a pixel.
constexpr double kShadowSlack = 1e-12;

bool holds(const FlatBox& outer, const FlatBox& inner) {
  return outer.low.u <= inner.low.u && outer.low.v <= inner.low.v && outer.high.u >= inner.high.u &&
         outer.high.v >= inner.high.v;
}
bool meet(const FlatBox& a, const FlatBox& b) {
  return a.low.u <= b.high.u && a.low.v <= b.high.v && b.low.u <= a.high.u && b.low.v <= a.high.v;
}

/// f(block, shadow) for the blocks whose shadow passes, group by group; until it says that it knows enough.
template <class Passes, class F>
void for_blocks(const BlockedPoints& points, const FlatFrame& frame, double slack_m,
                const Passes& passes, F&& f) {
  for (const BlockedPoints::Group& group : points.groups()) {
    if (!passes(shadow_of(group.box, frame, slack_m))) continue;
    for (const auto& block : points.blocks().subspan(group.begin, group.end - group.begin)) {
      const FlatBox shadow = shadow_of(block.box, frame, slack_m);
      if (passes(shadow) && f(block, shadow)) return;
    }
  }
}

/// The extent of the points, to the bit: looked at are those of the blocks that may stand out.
FlatBox extent_of(const SegmentScene& scene, const BlockedPoints& points, const FlatFrame& frame,
                  double slack_m) {
  FlatBox extent;
  const auto stands_out = [&](const FlatBox& shadow) { return !holds(extent, shadow); };
  const auto look_at = [&](const BlockedPoints::Block& block, const FlatBox&) {
    for (const uint32_t position : block.positions) extent.add(frame(scene.local(position)));
    return false;
  };
  // First a point of each group, so that most blocks are within these.
  for (const BlockedPoints::Group& group : points.groups())
    extent.add(frame(scene.local(points.blocks()[group.begin].positions.front())));
  for_blocks(points, frame, slack_m, stands_out, look_at);
  return extent;
}

/// Columns or rows of pixels, both included.
struct Cells {
  int64_t first = 0, last = -1;
  bool holds(int64_t cell) const { return first <= cell && cell <= last; }
  bool empty() const { return last < first; }
  size_t count() const { return static_cast<size_t>(last - first + 1); }
};

/// One direction of the image that bounded_raster() would make: the same pixels for the same numbers.
struct ImageAxis {
  double low = 0, pixel_m = 1, margin = 0;
  int64_t cells = 0;

  ImageAxis(double from, double to, double edge_m, uint32_t reach)
      : low(from),
        pixel_m(edge_m),
        margin(reach),
        cells(static_cast<int64_t>(std::floor((to - from) / edge_m)) + 1 + 2 * int64_t{reach}) {}
  /// Of a point of the image.
  int64_t own(double at) const {
    const auto shift = static_cast<int64_t>(margin);
    const double cell = std::floor((at - low) / pixel_m);
    const int64_t last = cells - 2 * shift - 1;
    if (!(cell > 0)) return shift;
    return shift + (cell >= static_cast<double>(last) ? last : static_cast<int64_t>(cell));
  }
  /// Of any point, maybe outside. Rises with it.
  double any(double at) const { return std::floor((at - (low - margin * pixel_m)) / pixel_m); }
  /// Where a pixel begins.
  double begin(int64_t cell) const { return low + (static_cast<double>(cell) - margin) * pixel_m; }
  /// Those between two places that are in the image.
  Cells between(double from, double to) const {
    const double last = static_cast<double>(cells - 1);
    if (!(any(to) >= 0) || !(any(from) <= last)) return {};
    return {static_cast<int64_t>(std::max(0.0, any(from))),
            static_cast<int64_t>(std::min(last, any(to)))};
  }
};

Cells widened(const Cells& cells, int64_t by, const ImageAxis& axis) {
  return {std::max<int64_t>(0, cells.first - by), std::min(axis.cells - 1, cells.last + by)};
}

/// What the image holds within a window of it.
class ImageWindow {
 public:
  ImageWindow(const ImageAxis& u, const ImageAxis& v, Cells columns, Cells rows)
      : u_(u), v_(v), columns_(columns), rows_(rows) {
    raster_.columns = static_cast<uint32_t>(columns.count());
    raster_.rows = static_cast<uint32_t>(rows.count());
    raster_.pixels.assign(columns.count() * rows.count(), 0);
  }
  /// In metres, with a pixel to spare.
  FlatBox box() const {
    return {{u_.begin(columns_.first - 1), v_.begin(rows_.first - 1)},
            {u_.begin(columns_.last + 2), v_.begin(rows_.last + 2)}};
  }
  void mark(const Vec2& p) {
    const int64_t column = u_.own(p.u), row = v_.own(p.v);
    if (columns_.holds(column) && rows_.holds(row)) raster_.pixels[place(column, row)] = 1;
  }
  void dilate(uint32_t reach) { raster_ = dilated(raster_, reach); }
  bool holds(const Vec2& p) const {
    const double column = u_.any(p.u), row = v_.any(p.v);
    if (!(column >= 0 && row >= 0 && column < static_cast<double>(u_.cells) &&
          row < static_cast<double>(v_.cells)))
      return false;
    return raster_.pixels[place(static_cast<int64_t>(column), static_cast<int64_t>(row))] != 0;
  }

 private:
  size_t place(int64_t column, int64_t row) const {
    return static_cast<size_t>(row - rows_.first) * raster_.columns +
           static_cast<size_t>(column - columns_.first);
  }
  const ImageAxis &u_, &v_;
  Cells columns_, rows_;
  Raster raster_;
};

}  // namespace

FlatBox shadow_of(const Box3& box, const FlatFrame& frame, double slack_m) {
  const Vec3 half = 0.5 * (box.max - box.min);
  const Vec2 middle = frame(box.min + half);
  const auto reach = [&](const Vec3& axis) {
    return std::fabs(axis.x) * half.x + std::fabs(axis.y) * half.y + std::fabs(axis.z) * half.z +
           slack_m;
  };
  const Vec2 wide{reach(frame.u), reach(frame.v)};
  return {{middle.u - wide.u, middle.v - wide.v}, {middle.u + wide.u, middle.v + wide.v}};
}

double projection_slack_m(const SegmentScene& scene) {
  return kShadowSlack * scene.tree->cube().edge;
}

BlockedPoints::BlockedPoints(const SegmentScene& scene, std::span<const uint32_t> positions,
                             Task& task)
    : blocks_((positions.size() + kRun - 1) / kRun), size_(positions.size()) {
  if (!positions.empty()) first_ = positions.front();
  parallel_for(task, blocks_.size(), kBlocksPerChunk, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      Block& block = blocks_[b];
      block.positions = positions.subspan(b * kRun, std::min(kRun, positions.size() - b * kRun));
      for (const uint32_t position : block.positions) block.box.add(scene.local(position));
    }
  });
  for (size_t b = 0; b < blocks_.size(); b += kBlocksPerGroup) {
    Group group{{}, b, std::min(blocks_.size(), b + kBlocksPerGroup)};
    for (size_t k = group.begin; k < group.end; ++k) group.box += blocks_[k].box;
    groups_.push_back(group);
  }
}

void BlockedPoints::take(BlockedPoints&& other) {
  const size_t before = blocks_.size();
  blocks_.insert(blocks_.end(), other.blocks_.begin(), other.blocks_.end());
  for (const Group& group : other.groups_)
    groups_.push_back({group.box, before + group.begin, before + group.end});
  first_ = std::min(first_, other.first_);
  size_ += other.size_;
  other = {};
}

bool lie_over(const SegmentScene& scene, const BlockedPoints& points, size_t least,
              const BlockedPoints& image, const FlatFrame& frame, double pixel_m, uint32_t reach) {
  const double slack_m = projection_slack_m(scene);
  const FlatBox extent = extent_of(scene, image, frame, slack_m);
  pixel_m = bounded_pixel(extent, pixel_m, reach);
  const ImageAxis u(extent.low.u, extent.high.u, pixel_m, reach),
      v(extent.low.v, extent.high.v, pixel_m, reach);

  FlatBox common;  // of the blocks that come near the image
  const double margin = reach * pixel_m;
  const FlatBox near{{extent.low.u - margin - pixel_m, extent.low.v - margin - pixel_m},
                     {extent.high.u + margin + pixel_m, extent.high.v + margin + pixel_m}};
  const auto comes_near = [&](const FlatBox& shadow) { return meet(shadow, near); };
  for_blocks(points, frame, slack_m, comes_near,
             [&](const BlockedPoints::Block&, const FlatBox& shadow) {
               common += shadow;
               return false;
             });
  const Cells columns = u.between(common.low.u, common.high.u),
              rows = v.between(common.low.v, common.high.v);
  if (columns.empty() || rows.empty()) return least == 0;

  ImageWindow window(u, v, widened(columns, reach, u), widened(rows, reach, v));
  const FlatBox shown = window.box();
  for_blocks(
      image, frame, slack_m, [&](const FlatBox& shadow) { return meet(shadow, shown); },
      [&](const BlockedPoints::Block& block, const FlatBox&) {
        for (const uint32_t position : block.positions) window.mark(frame(scene.local(position)));
        return false;
      });
  window.dilate(reach);
  size_t over = 0;
  for_blocks(points, frame, slack_m, comes_near,
             [&](const BlockedPoints::Block& block, const FlatBox&) {
               for (const uint32_t position : block.positions)
                 over += window.holds(frame(scene.local(position)));
               return over >= least;
             });
  return over >= least;
}

}  // namespace jalon
