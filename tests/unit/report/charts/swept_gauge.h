// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "compare/clearance/clearance.h"
#include "report/charts/clearance_places.h"
#include "solid/convex_piece.h"

/// A box 2 m wide and 3 m high on a straight way of 20 m along x, and what it passes: points at both sides.
namespace swept {

using namespace jalon;

inline std::vector<Transform> way() {
  std::vector<Transform> poses(11);
  for (size_t i = 0; i < poses.size(); ++i) poses[i].m[3] = 2 * static_cast<double>(i);
  return poses;
}

inline CloudPtr obstacles() {
  Buffer<double> xyz(9);
  const double at[] = {5, 1.05, 1, 5.3, 1.08, 1, 15, -0.9, 0.5};
  std::copy(std::begin(at), std::end(at), xyz.data());
  return std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
}

inline SweepTables tables() {
  Task task;
  const std::vector<ConvexPiece> gauge{ConvexPiece::box({}, {2, 2, 3})};
  return sweep_tables(gauge, way(), obstacles().get(), nullptr, {}, task);
}

inline std::vector<std::vector<Vec3>> corners() {
  std::vector<Vec3> out;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.5, 1.5}) out.push_back({x, y, z});
  return {out};
}

}  // namespace swept
