// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/coplanar.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "segment/labels/label_groups.h"
#include "segment/upright.h"

namespace jalon {

namespace {

constexpr double kCoplanarParallel =
    0.966;  // cosine of 15 degrees: small pieces turn by their noise
constexpr double kCoplanarSigmas = 4;
// Of a piece's points on the larger plane. Panels proud of the wall and panes behind it have none there; a wall that
// bends by the tolerance along its length has most.
constexpr double kOnPlaneShare = 0.75;
constexpr size_t kLookedAt = 400;  // points of a piece
constexpr size_t kCoplanarPointsPerChunk = 1 << 16;

bool may_be_wall(const Segment& segment) {
  return segment.has_plane() && std::fabs(segment.fit.plane.normal.z) <= kWallSine;
}

// Share of a piece's points that lie on the plane.
double share_on(const Cloud& cloud, std::span<const uint32_t> points, const PlaneFit& fit,
                double tolerance_m) {
  const size_t step = std::max<size_t>(1, points.size() / kLookedAt);
  size_t looked = 0, on = 0;
  for (size_t i = step / 2; i < points.size(); i += step, ++looked)
    on += std::fabs(dot(fit.plane.normal, cloud.point(points[i]) - fit.centroid)) <= tolerance_m;
  return looked > 0 ? static_cast<double>(on) / static_cast<double>(looked) : 0;
}

Segment emptied(const Segment& piece) {
  Segment out;
  out.label = piece.label;
  out.source_label = piece.source_label;
  out.fit.plane.offset = kNaN;
  return out;
}

}  // namespace

std::vector<uint32_t> whole_walls(const Segmentation& segmentation, double tolerance_m,
                                  Task& task) {
  const auto& segments = segmentation.segments;
  const LabelGroups groups(segmentation.labels->values<uint32_t>(), segments.size(), task);
  std::vector<size_t> upright;
  for (size_t s = 0; s < segments.size(); ++s)
    if (may_be_wall(segments[s])) upright.push_back(s);
  std::stable_sort(upright.begin(), upright.end(), [&](size_t a, size_t b) {
    return segments[a].point_count() > segments[b].point_count();
  });
  std::vector<uint32_t> out(segments.size());
  for (size_t s = 0; s < segments.size(); ++s) out[s] = segments[s].label;
  for (size_t a = 0; a < upright.size(); ++a) {
    const Segment& large = segments[upright[a]];
    if (out[upright[a]] != large.label) continue;
    const double near = std::max(tolerance_m, kCoplanarSigmas * large.fit.sigma);
    for (size_t b = a + 1; b < upright.size(); ++b) {
      const Segment& piece = segments[upright[b]];
      if (out[upright[b]] != piece.label) continue;
      task.checkpoint(0);
      const double along = std::fabs(dot(large.fit.plane.normal, piece.fit.plane.normal));
      if (along < kCoplanarParallel) continue;
      if (share_on(*segmentation.cloud, groups.of(piece.label), large.fit, near) >= kOnPlaneShare)
        out[upright[b]] = large.label;
    }
  }
  return out;
}

Segmentation joined_pieces(const Segmentation& segmentation, const std::vector<uint32_t>& whole,
                           Task& task) {
  Segmentation out = segmentation;
  bool any = false;
  for (size_t s = 0; s < whole.size(); ++s) {
    if (whole[s] == out.segments[s].label) continue;
    any = true;
    const Segment& piece = segmentation.segments[s];
    Segment& into = out.segments[whole[s] - 1];
    into.fit.n += piece.fit.n;
    into.area_m2 += piece.area_m2;
    out.segments[s] = emptied(piece);
  }
  if (!any) return out;
  const auto before = segmentation.labels->values<uint32_t>();
  auto labels = std::make_shared<Column>(segmentation.labels->info(), before.size());
  const auto after = labels->values<uint32_t>();
  parallel_for(task, before.size(), kCoplanarPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) after[i] = before[i] == 0 ? 0 : whole[before[i] - 1];
  });
  out.labels = std::move(labels);
  return out;
}

}  // namespace jalon
