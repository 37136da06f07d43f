// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/evaluation/parts.h"
#include "segment/evaluation/sparse_assignment.h"
#include "segment/labels/key_counts.h"
#include "segment/labels/label_groups.h"

namespace jalon {

namespace {

constexpr size_t kPairsPointsPerChunk = 1 << 15;

SegmentPair make_pair(const Overlap& overlap, const Evaluation& verdicts) {
  SegmentPair pair;
  pair.automatic = overlap.automatic;
  pair.reference = overlap.reference;
  pair.card_automatic = verdicts.automatic[overlap.automatic - 1].points;
  pair.card_reference = verdicts.reference[overlap.reference - 1].points;
  pair.intersection = overlap.points;
  return pair;
}

// Angle between lines: exact for small angles too, where the arc cosine of 5.11 has lost all digits.
double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), std::fabs(dot(a, b)));
}

}  // namespace

std::vector<Overlap> count_overlaps(const Segmentation& automatic, const Segmentation& reference,
                                    const Evaluation& verdicts, Task& task) {
  const auto a = automatic.labels->values<uint32_t>(), r = reference.labels->values<uint32_t>();
  const std::vector<KeyCount> counts =
      count_keys(task, a.size(), [&](size_t begin, size_t end, uint64_t* keys) {
        for (size_t i = begin; i < end; ++i) {
          const bool on_both = a[i] != 0 && r[i] != 0;
          keys[i - begin] =
              on_both && verdicts.automatic[a[i] - 1].kept && verdicts.reference[r[i] - 1].kept
                  ? uint64_t{r[i]} << 32 | a[i]
                  : kNoKey;
        }
      });
  std::vector<Overlap> out;
  out.reserve(counts.size());
  for (const KeyCount& c : counts)
    out.push_back({static_cast<uint32_t>(c.key), static_cast<uint32_t>(c.key >> 32), c.count});
  return out;
}

void pair_segments(std::span<const Overlap> overlaps, double min_iou, Evaluation& out, Task& task) {
  std::vector<WeightedEdge> edges;
  std::vector<const Overlap*> chosen;  // of each edge
  for (const Overlap& overlap : overlaps) {
    if (make_pair(overlap, out).iou() < min_iou) continue;
    edges.push_back(
        {overlap.reference - 1, overlap.automatic - 1, static_cast<int64_t>(overlap.points)});
    chosen.push_back(&overlap);
  }
  const auto rows = static_cast<uint32_t>(out.reference.size()),
             columns = static_cast<uint32_t>(out.automatic.size());
  const std::vector<uint32_t> partners = assign_sparse(rows, columns, edges, task);
  for (size_t e = 0; e < edges.size(); ++e) {
    if (partners[edges[e].row] != edges[e].column) continue;
    out.pairs.push_back(make_pair(*chosen[e], out));
    out.automatic[edges[e].column].partner = edges[e].row + 1;
    out.reference[edges[e].row].partner = edges[e].column + 1;
  }
}

void compare_planes(const Segmentation& automatic, const Segmentation& reference,
                    std::vector<SegmentPair>& pairs, Task& task) {
  std::vector<SegmentPair*> pair_of(automatic.segments.size() + 1, nullptr);
  for (SegmentPair& pair : pairs)
    if (reference.segments[pair.reference - 1].has_plane()) pair_of[pair.automatic] = &pair;
  const LabelGroups groups = [&] {
    ProgressSpan span(task, 0, 0.4);
    return LabelGroups(automatic.labels->values<uint32_t>(), automatic.segments.size(), task);
  }();
  ProgressSpan span(task, 0.4, 1);
  const Cloud& cloud = *automatic.cloud;
  groups.for_each(task, [&](uint32_t label) {
    SegmentPair* pair = pair_of[label];
    if (pair == nullptr) return;
    const auto points = groups.of(label);
    const PlaneFit& plane = reference.segments[pair->reference - 1].fit;
    // From the plane's centroid, so that national coordinates cancel before they are multiplied.
    const double sum = parallel_reduce(
        task, points.size(), kPairsPointsPerChunk, 0.0, [&](size_t begin, size_t end) {
          double part = 0;
          for (size_t i = begin; i < end; ++i)
            part += std::fabs(dot(plane.plane.normal, cloud.point(points[i]) - plane.centroid));
          return part;
        });
    pair->distance_m = sum / static_cast<double>(points.size());
    const Segment& own = automatic.segments[label - 1];
    if (!own.has_plane()) return;
    pair->angle_rad = angle_between(own.fit.plane.normal, plane.plane.normal);
    pair->offset_m = dot(plane.plane.normal, own.fit.centroid - plane.centroid);
  });
}

}  // namespace jalon
