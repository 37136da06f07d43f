// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evaluation/face_pairing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "segment/evaluation/sparse_assignment.h"

namespace jalon {

namespace {

constexpr size_t kPairsPerChunk = 4;  // intersections of polygons: some 0.1 ms each
constexpr size_t kFacePairingFacesPerCheckpoint = 256;

struct FacePairingCandidate {
  uint32_t automatic, reference;
};

bool boxes_meet(const Box3& a, const Box3& b, double margin_m) {
  for (int i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] + margin_m || b.min[i] > a.max[i] + margin_m) return false;
  return true;
}

Box3 moved(Box3 box, const Vec3& shift) {
  box.min += shift;
  box.max += shift;
  return box;
}

// Kept faces whose planes agree and whose boxes meet, by a sweep along x; ascending by reference, automatic.
std::vector<FacePairingCandidate> candidates_of(std::span<const ComparedFace> automatic,
                                                std::span<const ComparedFace> reference,
                                                const Vec3& shift, const FaceChoice& choice,
                                                Task& task) {
  std::vector<uint32_t> order(automatic.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    return automatic[a].box.min.x < automatic[b].box.min.x;
  });
  std::vector<FacePairingCandidate> out;
  for (uint32_t r = 0; r < reference.size(); ++r) {
    if (r % kFacePairingFacesPerCheckpoint == 0) task.checkpoint(0);
    if (!reference[r].kept) continue;
    for (const uint32_t a : order) {
      const Box3 box = moved(automatic[a].box, shift);
      if (box.min.x > reference[r].box.max.x + choice.distance_m) break;
      if (automatic[a].kept && boxes_meet(box, reference[r].box, choice.distance_m) &&
          on_plane_of(reference[r], automatic[a], shift, choice))
        out.push_back({a, r});
    }
  }
  std::sort(
      out.begin(), out.end(), [](const FacePairingCandidate& a, const FacePairingCandidate& b) {
        return a.reference != b.reference ? a.reference < b.reference : a.automatic < b.automatic;
      });
  return out;
}

FacePair compare(const ComparedFace& a, const ComparedFace& r, const Vec3& shift) {
  FacePair pair;
  const SharedArea area = shared_area(region_in(r.frame, a, shift), r.region);
  pair.areas = {area.a, area.b, area.both};
  pair.angle_rad = plane_angle(a.frame.normal, r.frame.normal);
  pair.distance_m = plane_distance(r, a, shift);
  return pair;
}

}  // namespace

std::vector<FacePair> pair_faces(std::span<const ComparedFace> automatic,
                                 std::span<const ComparedFace> reference, const Vec3& shift,
                                 const FaceChoice& choice, double min_iou, Task& task) {
  const std::vector<FacePairingCandidate> candidates =
      candidates_of(automatic, reference, shift, choice, task);
  std::vector<FacePair> compared(candidates.size());
  parallel_for(task, candidates.size(), kPairsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      compared[i] =
          compare(automatic[candidates[i].automatic], reference[candidates[i].reference], shift);
      compared[i].automatic = candidates[i].automatic;
      compared[i].reference = candidates[i].reference;
    }
  });
  std::vector<WeightedEdge> edges;
  std::vector<const FacePair*> chosen;
  for (const FacePair& pair : compared) {
    if (!(pair.areas.intersection_m2 > 0) ||
        pair.areas.intersection_m2 < min_iou * pair.areas.union_m2())
      continue;
    // In squares of the grid, of which a shared area is a multiple of one half.
    const double weight =
        std::round(2 * pair.areas.intersection_m2 / (kPolygonGrid_m * kPolygonGrid_m));
    edges.push_back({pair.reference, pair.automatic, static_cast<int64_t>(weight)});
    chosen.push_back(&pair);
  }
  const std::vector<uint32_t> partners =
      assign_sparse(static_cast<uint32_t>(reference.size()),
                    static_cast<uint32_t>(automatic.size()), edges, task);
  std::vector<FacePair> out;
  for (size_t e = 0; e < edges.size(); ++e)
    if (partners[edges[e].row] == edges[e].column) out.push_back(*chosen[e]);
  return out;
}

}  // namespace jalon
