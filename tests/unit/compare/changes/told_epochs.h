// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/random.h"
#include "base/table_columns.h"
#include "compare/changes/object_motion.h"
#include "unit/compare/changes/epochs.h"

namespace jalon::test {

/// Two epochs whose changed points say that their place was seen through, as a comparison with detection does.
struct ToldEpochs : TwoEpochs {
  ToldEpochs(const std::vector<Vec3>& was, const std::vector<Vec3>& is) : TwoEpochs(was, is) {
    tell(forward, after);
    tell(reverse, before);
  }
  ObjectMotionJob job(Task& task) const {
    return {before, after, kApart_m / 2, kApart_m, kApart_m, {}, {}, task};
  }

 private:
  static void tell(Comparison& comparison, const Epoch& epoch) {
    std::vector<uint8_t> evidence;
    for (const uint32_t label : epoch.regions.labels) evidence.push_back(label != 0 ? 2 : 0);
    set_column(comparison.points, "evidence", evidence);
    set_column(comparison.points, "level_of_detection", std::vector<float>(evidence.size(), -1.0F));
    add_value<double>(comparison.summary, "noise", "m", "", 0.002);
    add_value<uint64_t>(comparison.summary, "stations", "", "", 2);
  }
};

/// A floor of 3.6 m with boxes on it.
struct BoxOnFloor {
  Vec3 foot_corner, size;
};
inline std::vector<Vec3> floor_with(const std::vector<BoxOnFloor>& boxes, uint64_t stream) {
  constexpr double kNoise_m = 0.002;
  RandomStream random(9, stream);
  std::vector<Vec3> points;
  add_sheet(points, {-1.8, -1.8, 0}, {3.6, 0, 0}, {0, 3.6, 0}, random);
  for (const BoxOnFloor& box : boxes) add_box(points, box.foot_corner, box.size, random);
  for (Vec3& p : points)
    for (int c = 0; c < 3; ++c) p[c] += kNoise_m * random.normal();
  return points;
}

}  // namespace jalon::test
