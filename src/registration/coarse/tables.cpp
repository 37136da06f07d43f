// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/tables.h"

#include <algorithm>
#include <numeric>

#include "base/numbers.h"
#include "base/table_columns.h"
#include "registration/registration_tables.h"
#include "registration/symmetric_eigen6.h"

namespace jalon {

namespace {

// Share of the mean stiffness below which a direction is not held: normals of cells scatter by some degrees, most at
// edges, whose squared sine is what a plane seems to hold along itself. Corridors come to 0.02, rooms to 0.4.
constexpr double kHeld = 0.05;

// The weakest first. A start pose has no covariance worth the name: its sigmas are not known.
std::array<PoseDirection, 6> directions_of(const Square<6>& fixed, double extent_m) {
  const Eigen6 eigen = symmetric_eigen(fixed, 1 / extent_m);
  const double least = kHeld * std::accumulate(eigen.values.begin(), eigen.values.end(), 0.0) / 6;
  std::array<PoseDirection, 6> out;
  for (size_t i = 0; i < 6; ++i) {
    out[i].unit = eigen.vectors[i];
    out[i].sigma_m = kNaN;
    out[i].observable = eigen.values[i] > least;
  }
  return out;
}

}  // namespace

void fill_coarse_tables(Registration& r, const CoarseSearch& found, double cell_m,
                        size_t candidates) {
  const std::vector<RankedPose>& poses = found.poses;
  const RankedPose none{}, &best = poses.empty() ? none : poses[0],
                           &second = poses.size() < 2 ? none : poses[1];
  r.pairs = best.overlap.pairs;
  r.rms_m = best.overlap.rms_m;
  r.covariance.fill(kNaN);
  add_value<double>(r.summary, "score", "1", "overlap of both clouds times likeness, 0 ... 1",
                    best.overlap.score());
  add_value<double>(r.summary, "overlap_moving", "1",
                    "share of the moving surface on the reference", best.overlap.of_moving);
  add_value<double>(r.summary, "overlap_reference", "1",
                    "share of the reference's surface on the moving one",
                    best.overlap.of_reference);
  add_value<double>(r.summary, "likeness", "1",
                    "share of the salient places near the other that look alike there",
                    best.overlap.likeness);
  add_value<uint8_t>(r.summary, "ambiguous", "", "1: a clearly different pose fits about as well",
                     r.stopped == StopReason::kAmbiguous);
  add_value<double>(r.summary, "second_score", "1", "of the best pose that is clearly different",
                    second.overlap.score());
  add_value<double>(r.summary, "cell", "m", "edge of the cells that both were thinned to", cell_m);
  add_value<uint64_t>(r.summary, "candidates", "", "poses looked at", candidates);
  const auto score = [](const RankedPose& p) { return p.overlap.score(); };
  add_column<double>(r.iteration_log, poses, "score", "1", "overlap of both clouds times likeness",
                     score);
  add_column<double>(r.iteration_log, poses, "overlap_moving", "1",
                     "share of the moving surface on the reference",
                     [](const RankedPose& p) { return p.overlap.of_moving; });
  add_column<double>(r.iteration_log, poses, "overlap_reference", "1",
                     "share of the reference's surface on the moving one",
                     [](const RankedPose& p) { return p.overlap.of_reference; });
  add_column<double>(r.iteration_log, poses, "likeness", "1",
                     "share of the salient places near the other cloud that look alike there",
                     [](const RankedPose& p) { return p.overlap.likeness; });
  add_column<double>(r.iteration_log, poses, "salient", "1",
                     "share of the salient places near the other cloud",
                     [](const RankedPose& p) { return p.overlap.salient; });
  add_column<double>(r.iteration_log, poses, "rms", "m",
                     "of what lies on the other surface, off its planes",
                     [](const RankedPose& p) { return p.overlap.rms_m; });
  add_column<uint8_t>(r.iteration_log, poses, "source", "",
                      "what spoke for it: JALON_POSE_FROM_...",
                      [](const RankedPose& p) { return static_cast<uint8_t>(p.source); });
  add_columns<double, 12>(r.iteration_log, poses, "pose", "", "T_reference_moving, rows of [A | t]",
                          [](const RankedPose& p, double* out) {
                            std::copy_n(p.T_reference_moving.m.begin(), 12, out);
                          });
  fill_tables(r, directions_of(found.fixed, r.extent_m));
  fill_judgement(r, judgement_of_search(r.stopped));
}

}  // namespace jalon
