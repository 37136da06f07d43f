// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evaluation/vertex_deviations.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/distributions.h"
#include "base/numbers.h"
#include "base/table_columns.h"
#include "geometry/symmetric_eigen.h"
#include "modelling/evaluation/area_indices.h"

namespace jalon {

namespace {

constexpr size_t kVerticesPerCheckpoint = 1024;
constexpr double kFlat = 1e-12;     // variance against the largest: none, to rounding
constexpr double kOnFlat_m = 1e-9;  // a deviation of nothing, to rounding

struct VertexDeviationsCandidate {
  double distance_m;
  uint32_t automatic, reference;
};

std::vector<uint32_t> order_along_x(std::span<const Vec3> points) {
  std::vector<uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return points[a].x < points[b].x; });
  return order;
}

// All pairs within the tolerance, by a sweep along x.
std::vector<VertexDeviationsCandidate> near_pairs(std::span<const Vec3> automatic,
                                                  std::span<const Vec3> reference,
                                                  double tolerance_m, Task& task) {
  const std::vector<uint32_t> a = order_along_x(automatic), r = order_along_x(reference);
  std::vector<VertexDeviationsCandidate> out;
  size_t from = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (i % kVerticesPerCheckpoint == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(a.size()));
    const Vec3& p = automatic[a[i]];
    while (from < r.size() && reference[r[from]].x < p.x - tolerance_m) ++from;
    for (size_t k = from; k < r.size() && reference[r[k]].x <= p.x + tolerance_m; ++k)
      if (const double d = norm(p - reference[r[k]]); d <= tolerance_m)
        out.push_back({d, a[i], r[k]});
  }
  return out;
}

struct DeviationColumn {
  const char* name;
  const char* meaning;
  double (*value)(const VertexPair&);
};
constexpr DeviationColumn kColumns[] = {
    {"dx", "automatic less reference", [](const VertexPair& p) { return p.deviation.x; }},
    {"dy", "automatic less reference", [](const VertexPair& p) { return p.deviation.y; }},
    {"dz", "automatic less reference", [](const VertexPair& p) { return p.deviation.z; }},
    {"distance", "D: length of the deviation", [](const VertexPair& p) { return p.distance_m(); }},
    {"along", "along the reference's face, to the right",
     [](const VertexPair& p) { return p.in_facade.x; }},
    {"up", "up the reference's face", [](const VertexPair& p) { return p.in_facade.y; }},
    {"out", "along the reference's normal", [](const VertexPair& p) { return p.in_facade.z; }},
};

double root_mean_square(std::span<const double> values) {
  double squares = 0;
  size_t n = 0;
  for (const double v : values)
    if (std::isfinite(v)) squares += v * v, ++n;
  return n > 0 ? std::sqrt(squares / static_cast<double>(n)) : kNaN;
}

}  // namespace

std::vector<VertexPair> homologous_vertices(std::span<const Vec3> automatic,
                                            std::span<const Vec3> reference, double tolerance_m,
                                            Task& task) {
  std::vector<VertexDeviationsCandidate> candidates =
      near_pairs(automatic, reference, tolerance_m, task);
  std::sort(candidates.begin(), candidates.end(),
            [](const VertexDeviationsCandidate& a, const VertexDeviationsCandidate& b) {
              if (a.distance_m != b.distance_m) return a.distance_m < b.distance_m;
              return a.reference != b.reference ? a.reference < b.reference
                                                : a.automatic < b.automatic;
            });
  std::vector<uint8_t> used_a(automatic.size()), used_r(reference.size());
  std::vector<VertexPair> out;
  for (const VertexDeviationsCandidate& c : candidates) {
    if (used_a[c.automatic] != 0 || used_r[c.reference] != 0) continue;
    used_a[c.automatic] = used_r[c.reference] = 1;
    out.push_back({c.automatic, c.reference, automatic[c.automatic] - reference[c.reference]});
  }
  std::sort(out.begin(), out.end(),
            [](const VertexPair& a, const VertexPair& b) { return a.reference < b.reference; });
  return out;
}

double normalised_deviation(const Vec3& e, const std::array<double, 9>& c) {
  for (const double value : c)
    if (!std::isfinite(value)) return kNaN;
  const Eigen3 eigen = symmetric_eigen({c[0], c[1], c[2], c[4], c[5], c[8]});
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const double along = dot(eigen.vectors[i], e);
    if (eigen.values[i] > kFlat * eigen.values[2]) sum += along * along / eigen.values[i];
    else if (std::fabs(along) > kOnFlat_m) return std::numeric_limits<double>::infinity();
  }
  return std::sqrt(sum);
}

FieldTable vertex_pair_table(std::span<const VertexPair> pairs) {
  FieldTable t;
  add_column<uint32_t>(t, pairs, "automatic", "", "vertex",
                       [](const VertexPair& p) { return p.automatic; });
  add_column<uint32_t>(t, pairs, "reference", "", "vertex",
                       [](const VertexPair& p) { return p.reference; });
  for (const DeviationColumn& c : kColumns)
    add_column<double>(t, pairs, c.name, "m", c.meaning, c.value);
  add_column<double>(t, pairs, "normalised", "1", "deviation against its covariance",
                     [](const VertexPair& p) { return p.normalised; });
  return t;
}

void add_vertex_totals(FieldTable& table, std::span<const VertexPair> pairs) {
  add_value<uint64_t>(table, "vertices", "", "homologous vertices", pairs.size());
  double largest = pairs.empty() ? kNaN : 0;
  for (const VertexPair& pair : pairs) largest = std::max(largest, pair.distance_m());
  for (const DeviationColumn& c : kColumns) {
    std::vector<double> values;
    for (const VertexPair& pair : pairs) values.push_back(c.value(pair));
    const MeanAndStd spread = mean_and_std(values);
    const std::string name = c.name;
    add_value<double>(table, "mean_" + name, "m", "bias", spread.mean);
    add_value<double>(table, "std_" + name, "m", "about the mean, divided by n - 1", spread.std);
    add_value<double>(table, "rms_" + name, "m", "about 0", root_mean_square(values));
  }
  add_value<double>(table, "max_distance", "m", "largest D", largest);
  uint64_t known = 0, within = 0;
  for (const VertexPair& pair : pairs) {
    known += !std::isnan(pair.normalised);
    within += pair.normalised * pair.normalised <= chi_square_quantile(3, 0.95);
  }
  add_value<double>(table, "within_95", "1",
                    "share of the known covariances whose 95 % ellipsoid holds the deviation",
                    known > 0 ? static_cast<double>(within) / static_cast<double>(known) : kNaN);
}

}  // namespace jalon
