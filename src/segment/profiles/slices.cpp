// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/profiles/slices.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "base/parallel.h"
#include "base/serial.h"
#include "spatial/polylines.h"

namespace jalon {

namespace {

constexpr size_t kSlicePointsPerChunk = 1 << 16;
constexpr size_t kSlicePointsPerLook = 1 << 15;  // all over the cloud, some 100 ns each
constexpr size_t kLeastLineNodes = 3;            // two points are always on one line
constexpr size_t kMostSlices = 1 << 20;
constexpr uint32_t kBetweenSlices = 0xffffffffu;
// Cosine between a normal and the axis of slices beyond which a surface, within 30 degrees of them, is none of theirs.
constexpr double kMostAlongAxis = 0.8660254037844386;

struct SliceAxes {
  Vec3 u, v;
};

// Which slice a point lies in.
struct SliceNumbers {
  Vec3 axis;
  double low, step_m, half_m;
  uint32_t count;
  uint32_t of(const Vec3& p) const {
    const double at = (dot(p, axis) - low) / step_m - 0.5, slice = std::round(at);
    if (!(slice >= 0) || slice >= count || std::fabs(at - slice) * step_m > half_m)
      return kBetweenSlices;
    return static_cast<uint32_t>(slice);
  }
  double middle_m(uint32_t slice) const { return low + (slice + 0.5) * step_m; }
};

// Where the surface about a point meets the plane of a slice: a slice has a thickness, and what it cuts at an angle
// would be a band in it and no line. Along the axis where no normal tells the surface, or it is the slice's own.
Vec3 in_slice(const SegmentScene& scene, uint32_t position, const Vec3& axis, double middle_m) {
  const Vec3 p = scene.local(position);
  const float* n = &scene.normals[3 * size_t{position}];
  const double off = dot(p, axis) - middle_m, along = n[0] * axis.x + n[1] * axis.y + n[2] * axis.z;
  if (!(std::fabs(along) < kMostAlongAxis)) return p - off * axis;
  const Vec3 in_surface = axis - along * Vec3{n[0], n[1], n[2]};
  return p - off / (1 - along * along) * in_surface;
}

struct AxisRange {
  double low = INFINITY, high = -INFINITY;
  AxisRange& operator+=(const AxisRange& b) {
    low = std::min(low, b.low);
    high = std::max(high, b.high);
    return *this;
  }
};

SliceNumbers number_slices(const SegmentScene& scene, const SliceRule& rule, Task& task) {
  const AxisRange range = parallel_reduce(task, scene.size(), kSlicePointsPerChunk, AxisRange{},
                                          [&](size_t begin, size_t end) {
                                            AxisRange part;
                                            for (size_t i = begin; i < end; ++i) {
                                              const double at = dot(scene.local(i), rule.axis);
                                              part += AxisRange{at, at};
                                            }
                                            return part;
                                          });
  const double extent = range.high - range.low;
  const double step = std::max(rule.step_m, extent / static_cast<double>(kMostSlices));
  const auto count = static_cast<uint32_t>(std::floor(extent / step)) + 1;
  // In the middle of what is left over at both ends.
  const double low = range.low - (count * step - extent) / 2;
  return {rule.axis, low, step, std::min(rule.thickness_m, step) / 2, count};
}

// Positions of the points of each slice, ascending: counted by stretches of points, then put in place.
struct SlicedPoints {
  std::vector<uint32_t> first, positions;
};
SlicedPoints points_of_slices(const SegmentScene& scene, const SliceNumbers& numbers, Task& task) {
  const size_t n = scene.size();
  struct Found {
    uint32_t position, slice;
  };
  std::vector<std::vector<Found>> found((n + kSlicePointsPerChunk - 1) / kSlicePointsPerChunk);
  parallel_for(task, n, kSlicePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (const uint32_t slice = numbers.of(scene.local(i)); slice != kBetweenSlices)
        found[begin / kSlicePointsPerChunk].push_back({static_cast<uint32_t>(i), slice});
  });
  SlicedPoints sliced;
  sliced.first.assign(numbers.count + 1u, 0);
  serial_for(task, found.size(), 1, [&](size_t part, size_t) {
    for (const Found& point : found[part]) ++sliced.first[point.slice + 1];
  });
  for (size_t k = 0; k < numbers.count; ++k) sliced.first[k + 1] += sliced.first[k];
  sliced.positions.resize(sliced.first.back());
  std::vector<uint32_t> next(sliced.first.begin(), sliced.first.end() - 1);
  serial_for(task, found.size(), 1, [&](size_t part, size_t) {
    for (const Found& point : found[part]) sliced.positions[next[point.slice]++] = point.position;
  });
  return sliced;
}

// The least-squares line of a run of nodes; false when they spread beyond the tolerance.
bool fit_line(std::span<const Vec2> run, double tolerance_m, ProfileLine& line) {
  const auto n = static_cast<double>(run.size());
  Vec2 mean{0, 0};
  for (const Vec2& p : run) mean = mean + p * (1 / n);
  double uu = 0, uv = 0, vv = 0;
  for (const Vec2& p : run) {
    const Vec2 d = p - mean;
    uu += d.u * d.u;
    uv += d.u * d.v;
    vv += d.v * d.v;
  }
  const double angle = 0.5 * std::atan2(2 * uv, uu - vv);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  const double across =
      uu * along.v * along.v - 2 * uv * along.u * along.v + vv * along.u * along.u;
  if (!(std::sqrt(std::max(0.0, across) / n) <= 0.5 * tolerance_m)) return false;
  const auto project = [&](const Vec2& p) {
    const Vec2 d = p - mean;
    return mean + along * (d.u * along.u + d.v * along.v);
  };
  line.from = project(run.front());
  line.to = project(run.back());
  return line.from != line.to;
}

class SliceLines {
 public:
  SliceLines(const SegmentScene& scene, const SliceRule& rule, Task& task)
      : scene_(scene), rule_(rule), task_(task) {
    const SurfaceAxes axes = plane_axes(rule.axis);
    axes_ = {axes.u, axes.v};
    const double half = scene.tree->cube().edge / 2;
    reference_ = {half, half, half};
  }

  std::vector<ProfileLine> of(uint32_t slice, double middle_m,
                              std::span<const uint32_t> positions) const {
    std::vector<Vec2> flat;
    serial_for(task_, positions.size(), kSlicePointsPerLook, [&](size_t begin, size_t end) {
      for (const uint32_t position : positions.subspan(begin, end - begin)) {
        const Vec3 p = in_slice(scene_, position, rule_.axis, middle_m);
        flat.push_back({dot(p, axes_.u), dot(p, axes_.v)});
      }
    });
    std::vector<uint32_t> order;
    const std::vector<ProfileNode> nodes = thin_points(flat, rule_.cell_m, order, task_);
    std::vector<ProfileLine> lines;
    for (const auto& chain : chain_nodes(nodes, rule_.cell_m, rule_.gap_m, task_)) {
      task_.checkpoint(0);
      std::vector<Vec2> middles;
      for (const uint32_t node : chain) middles.push_back(nodes[node].middle);
      const std::vector<uint32_t> kept = simplify(middles, rule_.tolerance_m);
      for (size_t k = 0; k + 1 < kept.size(); ++k) {
        ProfileLine line;
        line.slice = slice;
        const std::span<const Vec2> run(middles.data() + kept[k], kept[k + 1] - kept[k] + 1);
        if (run.size() < kLeastLineNodes || !fit_line(run, rule_.tolerance_m, line)) continue;
        take_points({chain.data() + kept[k], run.size()}, nodes, order, positions, line);
        lines.push_back(std::move(line));
      }
    }
    return lines;
  }

 private:
  // Nodes at both ends belong to the corner, not to the line.
  void take_points(std::span<const uint32_t> run, std::span<const ProfileNode> nodes,
                   std::span<const uint32_t> order, std::span<const uint32_t> positions,
                   ProfileLine& line) const {
    line.moments.reference = reference_;
    const size_t margin = run.size() > kLeastLineNodes + 1 ? 1 : 0;
    for (size_t i = margin; i + margin < run.size(); ++i) {
      const ProfileNode& node = nodes[run[i]];
      for (uint32_t k = node.first; k < node.first + node.count; ++k) {
        const uint32_t position = positions[order[k]];
        line.positions.push_back(position);
        line.moments.add(scene_.local(position));
      }
    }
  }

  const SegmentScene& scene_;
  const SliceRule& rule_;
  Task& task_;
  SliceAxes axes_;
  Vec3 reference_;
};

}  // namespace

std::vector<ProfileLine> profile_lines(const SegmentScene& scene, const SliceRule& rule,
                                       Task& task) {
  const SliceNumbers numbers = number_slices(scene, rule, task);
  const SlicedPoints sliced = points_of_slices(scene, numbers, task);
  const SliceLines lines_of(scene, rule, task);
  std::vector<std::vector<ProfileLine>> parts(numbers.count);
  parallel_for(task, numbers.count, 1, [&](size_t k, size_t) {
    const std::span<const uint32_t> own(sliced.positions.data() + sliced.first[k],
                                        sliced.first[k + 1] - sliced.first[k]);
    const auto slice = static_cast<uint32_t>(k);
    parts[k] = lines_of.of(slice, numbers.middle_m(slice), own);
  });
  std::vector<ProfileLine> lines;
  for (auto& part : parts)
    lines.insert(lines.end(), std::make_move_iterator(part.begin()),
                 std::make_move_iterator(part.end()));
  return lines;
}

}  // namespace jalon
