// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Planes of single turns of spinning heads, against the faces that the beams met. Each beam draws a line, and any line
// lies in some plane: one that is no face is false. Constants were chosen on a real pair of scans and on scans by
// tripods, which must stay as they were, not on these.
#include <doctest/doctest.h>

#include <string>

#include "accuracy/beam_scans.h"
#include "accuracy/pair_kinds.h"
#include "accuracy/recipe.h"
#include "segment/segmentation.h"

namespace jalon::segment_beams_test {

using namespace jalon::test;

namespace {

constexpr double kLikeFace = 0.94;    // cosine: 20 degrees, for small planes of noisy lines
constexpr double kMostlyFaces = 0.5;  // of a plane's points; with fewer it is false
// Share of planes. Most of the false ones are of rough things, as boulders and machines are, which have none.
constexpr double kMostFalse = 0.15;

struct Tally {
  size_t planes = 0, false_planes = 0;
  size_t points = 0, in_planes = 0, in_false = 0;

  Tally& operator+=(const Tally& b) {
    planes += b.planes, false_planes += b.false_planes;
    points += b.points, in_planes += b.in_planes, in_false += b.in_false;
    return *this;
  }
};

// Normal of the face that the beam to a point met.
Vec3 met_by(const TriangleTree& tree, const PairScene& scene, const Vec3& from, const Vec3& point) {
  RayHit hit;
  if (!tree.nearest({from, normalized(point - from), 0.5, 2 * scene.range_m}, hit)) return {};
  const auto& corners = scene.triangles[hit.triangle];
  const Vec3 a = scene.vertices[corners[0]];
  return normalized(cross(scene.vertices[corners[1]] - a, scene.vertices[corners[2]] - a));
}

Tally trial(const PairKind& kind, const BeamHead& head, uint64_t seed) {
  Task task;
  const PairScene scene = kind.make(seed, seed);
  const StandScan scan = turn_of(head, scene, 0, 10 * seed + 1);
  const auto tree = TriangleTree::build(scene.vertices, scene.triangles, task);
  const Segmentation found = segment_ransac(scan.cloud, {}, task);
  const auto labels = found.labels->values<uint32_t>();
  std::vector<size_t> points(found.segments.size()), like(found.segments.size());
  Tally out;
  out.points = labels.size();
  for (size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;
    const size_t s = labels[i] - 1;
    const Vec3 normal = scan.T_world_scan.direction(found.segments[s].fit.plane.normal);
    const Vec3 face =
        met_by(*tree, scene, scene.standpoints[0], scan.T_world_scan.point(scan.cloud->point(i)));
    ++points[s];
    like[s] += std::abs(dot(face, normal)) > kLikeFace;
  }
  for (size_t s = 0; s < points.size(); ++s) {
    const bool is_false =
        static_cast<double>(like[s]) < kMostlyFaces * static_cast<double>(points[s]);
    ++out.planes;
    out.in_planes += points[s];
    out.false_planes += is_false;
    out.in_false += is_false ? points[s] : 0;
  }
  return out;
}

Tally tally_of(std::span<const PairKind> kinds, std::span<const BeamHead> heads,
               uint64_t first_seed, uint64_t seeds, const char* what) {
  Tally all;
  const auto tell = [&](const std::string& of, const Tally& t) {
    MESSAGE("FIGURE planes of beams, " << std::string(what) << ", " << of << ": " << t.false_planes
                                       << " of " << t.planes << " false, with " << t.in_false
                                       << " of " << t.in_planes << " points of planes, of "
                                       << t.points);
  };
  for (const BeamHead& head : heads)
    for (const PairKind& kind : kinds) {
      Tally of_kind;
      for (uint64_t seed = first_seed; seed < first_seed + seeds; ++seed)
        of_kind += trial(kind, head, seed);
      tell(std::string(head.name) + ", " + kind.name, of_kind);
      all += of_kind;
    }
  tell("all", all);
  return all;
}

}  // namespace

TEST_CASE("segment_beams__false_planes_of_heads_and_kinds_developed_with") {
  const std::span<const PairKind> kinds = kDevelopedKinds;
  const Tally all =
      is_full() ? tally_of(kinds, kDevelopedHeads, 1, 3, "developed")
                : tally_of(kinds.first(3), std::span(kDevelopedHeads).first(1), 1, 1, "developed");
  CHECK(static_cast<double>(all.false_planes) <= kMostFalse * static_cast<double>(all.planes));
}

TEST_CASE("segment_beams__false_planes_of_heads_and_kinds_kept_for_the_report") {
  const std::span<const PairKind> kinds = kReportedKinds;
  const Tally all =
      is_full() ? tally_of(kinds, kReportedHeads, 101, 2, "reported")
                : tally_of(kinds.first(2), std::span(kReportedHeads).first(1), 101, 1, "reported");
  CHECK(static_cast<double>(all.false_planes) <= kMostFalse * static_cast<double>(all.planes));
}

}  // namespace jalon::segment_beams_test
