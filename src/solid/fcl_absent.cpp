// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/error.h"
#include "solid/fcl_distance.h"

namespace jalon {

void require_fcl() {
  fail(Status::kUnsupported,
       "this library was built without FCL (JALON_WITH_FCL=OFF): no clearance between two models");
}
TrianglePair nearest_pair(const TriangleBoxes&, const TriangleBoxes&) {
  require_fcl();
  return {};
}
double triangle_distance(const std::array<Vec3, 3>&, const std::array<Vec3, 3>&, Vec3&, Vec3&) {
  require_fcl();
  return 0;
}

}  // namespace jalon
