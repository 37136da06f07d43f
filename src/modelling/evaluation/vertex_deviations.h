// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/field.h"
#include "base/numbers.h"
#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// A vertex and its counterpart (Boulaassal 2010, table 5.8).
struct VertexPair {
  uint32_t automatic = 0, reference = 0;  ///< vertices of the two models, or rows of the lists
  Vec3 deviation;                         ///< automatic less reference: DX, DY, DZ
  Vec3 in_facade{kNaN, kNaN,
                 kNaN};  ///< the same along the facade, up and out of it; NaN: no face told
  double normalised =
      kNaN;  ///< sqrt(e^T C^-1 e), C the sum of the two covariances; NaN where neither is known
  double distance_m() const { return norm(deviation); }
};

/// Homologous vertices, one to one: the nearest pair first, then the nearest of what is left, up to the tolerance;
/// ties by index. Ascending by the reference's index. O(n log n + pairs within the tolerance).
std::vector<VertexPair> homologous_vertices(std::span<const Vec3> automatic,
                                            std::span<const Vec3> reference, double tolerance_m,
                                            Task& task);

/// sqrt(e^T C^-1 e) for a covariance (m2, row-major); NaN where C is not known, inf where e leaves a flat C.
double normalised_deviation(const Vec3& e, const std::array<double, 9>& covariance);

/// One row a pair: indices, "dx", "dy", "dz", "distance", "along", "up", "out", "normalised".
FieldTable vertex_pair_table(std::span<const VertexPair> pairs);
/// Adds "vertices" and, of each of those columns, "mean_", "std_" (n - 1) and "rms_"; "max_distance", "within_95".
void add_vertex_totals(FieldTable& table, std::span<const VertexPair> pairs);

}  // namespace jalon
