// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/edge_adjust.h"

#include <algorithm>
#include <cmath>

#include "modelling/edges/adjust/edge_reveal.h"

namespace jalon {

namespace {

// Standard deviation of a provisional edge, in spacings: the set-back of contour points is 0.2 to 0.5.
constexpr double kContourSigma = 0.35;
// An edge that is measured less well than this stays near its contour, in spacings.
constexpr double kPoor = 0.5;
// And of what the contour says of an edge's slope (rad) and an arc's centre (spacings): weak, for edges with few
// offsets.
constexpr double kEdgeAdjustSlopeSigma = 0.1, kCentreSigma = 3;
// Offsets beyond this were measured on something else.
constexpr double kMostOffset = 1.5;
constexpr double kEdgeAdjustOutlier = 4, kConflict = 4;
constexpr double kManyPoints = 20;
constexpr double kSnapSigmas = 3;

// Normal equations of an edge's corrections.
struct Information {
  EdgeInformation matrix{};
  Coefficients<3> right{};

  void add(const Coefficients<3>& row, double value, double weight) {
    for (size_t i = 0; i < 3; ++i) {
      right[i] += weight * row[i] * value;
      for (size_t j = 0; j < 3; ++j) matrix[3 * i + j] += weight * row[i] * row[j];
    }
  }
  // Adds a variance that all values share to unknown k: (N^-1 + b e e')^-1 by Sherman & Morrison (1950).
  void share(size_t k, double variance) {
    const double scale = variance / (1 + variance * matrix[4 * k]);
    const EdgeInformation n = matrix;
    const double rk = right[k];
    for (size_t i = 0; i < 3; ++i) {
      right[i] -= scale * n[3 * i + k] * rk;
      for (size_t j = 0; j < 3; ++j) matrix[3 * i + j] -= scale * n[3 * i + k] * n[3 * k + j];
    }
  }
  Information& operator+=(const Information& b) {
    for (size_t i = 0; i < 9; ++i) matrix[i] += b.matrix[i];
    for (size_t i = 0; i < 3; ++i) right[i] += b.right[i];
    return *this;
  }
};

// What one kind of evidence says of an edge as a whole.
struct EdgeEvidence {
  std::vector<EdgeOffset> offsets;
  double common_m2 = 0, mean_m = 0, variance_m2 = INFINITY;

  bool empty() const { return offsets.empty(); }
  void summarise() {
    double sum = 0, weight = 0;
    for (const EdgeOffset& o : offsets) {
      sum += o.weight * o.offset_m;
      weight += o.weight;
    }
    if (!(weight > 0)) return;
    mean_m = sum / weight;
    variance_m2 = 1 / weight + common_m2;
  }
};

// Drops offsets far from their median: parts of the edge that something hides.
void drop_outliers(EdgeEvidence& evidence, double spacing_m) {
  auto& all = evidence.offsets;
  if (all.size() < 3) return;
  std::vector<double> values;
  for (const EdgeOffset& o : all) values.push_back(o.offset_m);
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  std::erase_if(all, [&](const EdgeOffset& o) {
    return std::fabs(o.offset_m - *middle) >
           kEdgeAdjustOutlier * std::sqrt(1 / o.weight) + spacing_m / 4;
  });
}

// Unknowns of an edge: which row an offset at t is, and which unknown is its common one.
struct Unknowns {
  const EdgeShape& shape;
  size_t common() const { return shape.is_arc ? 2 : 0; }
  bool is_turned() const {
    return shape.is_arc || (shape.line.direction.u != 0 && shape.line.direction.v != 0);
  }
  Coefficients<3> row(double t) const {
    if (!shape.is_arc) return {1, is_turned() ? t - shape.length_m / 2 : 0, 0};
    const Vec2 d = (shape.at(t, 0) - shape.circle.centre) * (1 / shape.circle.radius);
    return {d.u, d.v, 1};
  }
  double value(double offset) const { return shape.is_arc ? -shape.turn * offset : offset; }
};

Information information_of(const EdgeEvidence& evidence, const Unknowns& unknowns) {
  Information out;
  for (const EdgeOffset& o : evidence.offsets)
    out.add(unknowns.row(o.t_m), unknowns.value(o.offset_m), o.weight);
  out.share(unknowns.common(), evidence.common_m2);
  return out;
}

Information prior_of(const Unknowns& unknowns, double spacing_m) {
  Information out;
  if (unknowns.shape.is_arc) {
    const double weight = 1 / (kCentreSigma * kCentreSigma * spacing_m * spacing_m);
    for (size_t k = 0; k < 3; ++k) out.matrix[4 * k] = weight;
  } else {
    out.matrix[4] = 1 / (kEdgeAdjustSlopeSigma * kEdgeAdjustSlopeSigma);
    out.matrix[8] = 1;  // lines have no third unknown
  }
  return out;
}

void move(EdgeShape& shape, const Coefficients<3>& x) {
  if (shape.is_arc) {
    shape.circle.centre = shape.circle.centre + Vec2{x[0], x[1]};
    shape.circle.radius += x[2];
  } else {
    const Vec2 along = shape.line.direction, left{-along.v, along.u};
    shape.line.point = shape.at(shape.length_m / 2, x[0]);
    if (x[1] != 0) {
      const Vec2 turned = along + left * x[1];
      shape.line.direction = turned * (1 / norm(turned));
    } else {  // to the last bit
      if (along.u == 0) shape.line.point.v = shape.first.v;
      if (along.v == 0) shape.line.point.u = shape.first.u;
    }
  }
  shape.set_ends(shape.first, shape.last);
}

// The reveal on the side of the plane where more is seen of it; the points that all reveals put on the plane.
EdgeEvidence reveal_evidence(const EdgeSetting& setting, const MeasuredEdge& edge,
                             double& extra_per_m) {
  EdgeEvidence best;
  extra_per_m = 0;
  if (!setting.reveals) return best;
  for (const auto* points : {&edge.behind, &edge.before}) {
    auto reveal = find_reveal(*points, {edge.shape.length_m, setting.spacing_m, setting.sigma_m});
    if (!reveal) continue;
    extra_per_m += reveal->per_metre2 * setting.window_m;
    EdgeEvidence found{std::move(reveal->offsets), reveal->common_m2};
    found.summarise();
    if (std::fabs(found.mean_m) > kMostOffset * setting.spacing_m ||
        !(found.variance_m2 < best.variance_m2))
      continue;
    best = std::move(found);
  }
  return best;
}

// Where the two contradict each other one of them saw something else: reveals of many points are hard to mistake.
void settle_conflict(EdgeEvidence& density, EdgeEvidence& reveal, const MeasuredEdge& edge,
                     double spacing_m) {
  if (density.empty() || reveal.empty()) return;
  const double sigma = std::sqrt(density.variance_m2 + reveal.variance_m2);
  if (std::fabs(density.mean_m - reveal.mean_m) <= kConflict * sigma + spacing_m / 10) return;
  const double points = static_cast<double>(edge.behind.size() + edge.before.size());
  (points >= kManyPoints ? density : reveal) = {};
}

}  // namespace

EdgeInformation adjust_edge(const EdgeSetting& setting, const CountingVariance& variance,
                            MeasuredEdge& edge) {
  EdgeShape& shape = edge.shape;
  const double p = setting.spacing_m;
  double extra_per_m = 0;
  EdgeEvidence reveal = reveal_evidence(setting, edge, extra_per_m);
  EdgeEvidence density{density_offsets(edge, p, extra_per_m, variance), variance.common_m2};
  std::erase_if(density.offsets,
                [&](const EdgeOffset& o) { return std::fabs(o.offset_m) > kMostOffset * p; });
  drop_outliers(density, p);
  density.summarise();
  settle_conflict(density, reveal, edge, p);
  const Unknowns unknowns{shape};
  Information all = prior_of(unknowns, p);
  if (density.empty() && reveal.empty()) {
    shape.sigma_m = kContourSigma * p;
    all.matrix[4 * unknowns.common()] = 1 / (shape.sigma_m * shape.sigma_m);
    return all.matrix;
  }
  all += information_of(density, unknowns);
  all += information_of(reveal, unknowns);
  Cholesky<3> factor;
  if (!factor.factor(all.matrix)) {
    shape.sigma_m = kContourSigma * p;
    return all.matrix;
  }
  const auto row = unknowns.row(shape.length_m / 2);
  const auto sigma = [&] {
    const auto column = factor.solve(row);
    return std::sqrt(row[0] * column[0] + row[1] * column[1] + row[2] * column[2]);
  };
  shape.sigma_m = sigma();
  if (shape.sigma_m > kPoor * p) {
    all.add(row, unknowns.value(-edge.moved_m), 1 / (kPoor * p * kPoor * p));
    if (factor.factor(all.matrix)) shape.sigma_m = sigma();
  }
  shape.source =
      reveal.variance_m2 < density.variance_m2 ? EdgeSource::kReveal : EdgeSource::kDensity;
  const auto x = factor.solve(all.right);
  move(shape, x);
  edge.moved_m += shape.is_arc ? -shape.turn * (row[0] * x[0] + row[1] * x[1] + x[2]) : x[0];
  const double slope_sigma = std::sqrt(factor.solve({0, 1, 0})[1]);
  if (unknowns.is_turned() && !shape.is_arc)
    shape.snap(setting.snap_rad, kSnapSigmas * slope_sigma, p);
  return all.matrix;
}

void move_to_reveal(const EdgeSetting& setting, MeasuredEdge& edge) {
  // Before the plane lies what covers the wall: a surround's face, not the side of the opening.
  edge.before.clear();
  double extra_per_m = 0;
  const EdgeEvidence reveal = reveal_evidence(setting, edge, extra_per_m);
  if (reveal.empty()) return;
  edge.shape.shift(reveal.mean_m);
  edge.shape.set_ends(edge.shape.first, edge.shape.last);
  edge.shape.sigma_m = std::sqrt(reveal.variance_m2);
  edge.shape.source = EdgeSource::kReveal;
  edge.moved_m += reveal.mean_m;
}

}  // namespace jalon
