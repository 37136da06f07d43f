// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/edge_density.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modelling/edges/adjust/point_rows.h"

namespace jalon {

namespace {

// In spacings: a point counts in full to kFull inside the assumed edge and fades out over kFade; the density is that of
// the points that do not count, over kInner more and a second fade. Nothing ends abruptly where a row of a grid may be.
constexpr double kFull = 0.25, kFade = 2, kInner = 1.5;
constexpr double kDepth = kFull + 2 * kFade + kInner;
constexpr double kOutward =
    1.5;  // points so far outside still count: the assumed edge may lie inside
constexpr double kLeastInner = 0.35;                 // of these widths, where the solid is thin
constexpr double kFirstCut = 0.75, kCutStep = 0.25;  // trial cuts
// Integral of the squared fade 1 - u^2 (3 - 2 u) over 0 ... 1.
constexpr double kSquaredFade = 13.0 / 35;
// Variance of the weighted number of inner random points over its mean.
constexpr double kInnerShare = (kInner + 2 * kSquaredFade * kFade) / (kInner + kFade);

// Widths of a count, in metres.
struct Taper {
  double full_m, fade_m, inner_m;
  double end() const { return full_m + 2 * fade_m + inner_m; }
  double mass() const { return full_m + fade_m / 2; }     ///< integral of the weight
  double inner_mass() const { return inner_m + fade_m; }  ///< and of that of the density
  /// Variance of the offset by random points, times their density and the edge's length: the squared integral of weight
  /// - r x that of the density.
  double variance() const {
    const double r = mass() / inner_mass();
    return full_m + fade_m * ((1 + r) * (1 + r) * kSquaredFade - r) +
           r * r * (inner_m + kSquaredFade * fade_m);
  }
  double fade(double x) const {
    const double u = x / fade_m;
    return u <= 0 ? 1 : u < 1 ? 1 - u * u * (3 - 2 * u) : 0;
  }
};

Taper taper_for(double depth_m, double spacing_m) {
  const double scale = std::min(1.0, depth_m / (kDepth * spacing_m));
  return {kFull * spacing_m * scale, kFade * spacing_m * scale, kInner * spacing_m * scale};
}

struct Count {
  double faded = 0;    ///< weighted count from the edge inward
  double density = 0;  ///< points a metre of edge and of depth, times the block's length
};

// dispersion: variance of counts over that of random points; the mean of 1 / n is about 1 / (mean - dispersion).
Count count_at(const EdgeBlock& block, const Taper& taper, double edge_m, double outward_m,
               double dispersion) {
  Count out;
  double inner = 0;
  for (const StripPoint& p : block.points) {
    const double d = p.d_m - edge_m;
    if (d < -outward_m) continue;
    if (d >= taper.end()) break;
    const double counted = taper.fade(d - taper.full_m);
    out.faded += p.weight * counted;
    inner +=
        p.weight * (d < taper.end() - taper.fade_m ? 1 - counted
                                                   : taper.fade(d - (taper.end() - taper.fade_m)));
  }
  if (inner > 0) out.density = (inner + dispersion * kInnerShare) / taper.inner_mass();
  return out;
}

bool is_usable(const EdgeBlock& block, double spacing_m) {
  return block.depth_m >= kLeastInner * kDepth * spacing_m;
}

// Errors of trial cuts of one edge: rows by block, columns by depth.
struct Trials {
  size_t blocks = 0, cuts = 0;
  double block_m = 0, length_m = 0;
  std::vector<double> errors;
};

Trials trials_of(const MeasuredEdge& edge, double spacing_m) {
  const Taper taper = taper_for(INFINITY, spacing_m);
  const double first = kFirstCut * spacing_m, last = kStripInward * spacing_m - taper.end();
  Trials out;
  out.cuts = static_cast<size_t>((last - first) / (kCutStep * spacing_m)) + 1;
  for (const EdgeBlock& block : edge.blocks) {
    if (block.depth_m < kStripInward * spacing_m) continue;  // all depths must be solid
    std::vector<double> errors;
    for (size_t k = 0; k < out.cuts; ++k) {
      const Count count =
          count_at(block, taper, first + static_cast<double>(k) * kCutStep * spacing_m, 0, 0);
      if (count.density > 0) errors.push_back(taper.mass() - count.faded / count.density);
    }
    if (errors.size() < out.cuts) continue;
    out.errors.insert(out.errors.end(), errors.begin(), errors.end());
    out.block_m = block.length_m;
    out.length_m += block.length_m;
    ++out.blocks;
  }
  return out;
}

// Running sums of the two terms over all edges of a class.
struct VarianceSums {
  double along = 0, along_weight = 0, common = 0, common_weight = 0;
  std::vector<std::pair<double, double>>
      totals;  ///< (length, mean squared error of the whole edge)

  void add(const Trials& t) {
    double total = 0, within = 0;
    for (size_t k = 0; k < t.cuts; ++k) {
      double sum = 0;
      for (size_t b = 0; b < t.blocks; ++b) sum += t.errors[b * t.cuts + k];
      const double mean = sum / static_cast<double>(t.blocks);
      total += mean * mean;
      for (size_t b = 0; b < t.blocks; ++b) {
        const double d = t.errors[b * t.cuts + k] - mean;
        within += d * d;
      }
    }
    const double cuts = static_cast<double>(t.cuts);
    if (t.blocks > 1) {
      along += within / cuts * t.block_m;
      along_weight += static_cast<double>(t.blocks - 1);
    }
    totals.push_back({t.length_m, total / cuts});
  }
};

}  // namespace

std::vector<EdgeOffset> density_offsets(const MeasuredEdge& edge, double spacing_m,
                                        double extra_per_m, const CountingVariance& variance) {
  const Taper whole = taper_for(INFINITY, spacing_m);
  const double dispersion = variance.along_m3 / (whole.variance() * spacing_m * spacing_m);
  std::vector<EdgeOffset> out;
  for (const EdgeBlock& block : edge.blocks) {
    if (!is_usable(block, spacing_m)) continue;
    const Taper taper = taper_for(block.depth_m, spacing_m);
    const double outward = std::min(kOutward * spacing_m, block.outward_m);
    const Count count = count_at(block, taper, 0, outward, dispersion);
    if (!(count.density > 0)) continue;
    const double counted = count.faded - extra_per_m * block.length_m;
    const double variance_m2 =
        variance.along_m3 * taper.variance() / whole.variance() / block.length_m;
    out.push_back({block.t_m, taper.mass() - counted / count.density, 1 / variance_m2});
  }
  return out;
}

CountingVariance counting_variance(std::span<const MeasuredEdge* const> edges, double spacing_m,
                                   double sigma_m) {
  constexpr double kEnough =
      6;  // blocks beyond the first: below, the spread among them says little
  VarianceSums sums;
  for (const MeasuredEdge* edge : edges) {
    const Trials trials = trials_of(*edge, spacing_m);
    if (trials.blocks > 0) sums.add(trials);
  }
  const double poisson = taper_for(INFINITY, spacing_m).variance() * spacing_m * spacing_m;
  CountingVariance out{poisson, 0};
  if (sums.along_weight >= kEnough) out.along_m3 = sums.along / sums.along_weight;
  double common = 0, total = 0, weight = 0;
  for (const auto& [length, squared] : sums.totals) {
    common += length * squared - out.along_m3;
    total += length * squared * length;
    weight += length;
  }
  if (!(weight > 0)) return out;
  if (common <= 0) {
    // Blocks whose errors cancel, as those of a turned grid: what whole edges show counts.
    if (sums.along_weight >= kEnough) out.along_m3 = std::min(out.along_m3, total / weight);
    return out;
  }
  // Noise after the sampling blurs the rows of a grid for the trial cuts, but not for the true edge.
  const Rows rows = find_rows(edges, spacing_m);
  out.common_m2 = common / weight;
  if (rows.visibility > 0) {
    // Of the sawtooth that a row leaves, q^2 / 12, its first harmonic has 6 / pi^2; visibility blurs that.
    const double q2 = rows.distance_m * rows.distance_m;
    const double most_blur =
        std::exp(-2 * std::numbers::pi * std::numbers::pi * sigma_m * sigma_m / q2);
    const double visibility = std::clamp(rows.visibility, std::min(most_blur, 1.0), 1.0);
    const double sharp =
        out.common_m2 * std::numbers::pi * std::numbers::pi / 6 / (visibility * visibility);
    out.common_m2 = std::max(out.common_m2, std::min(sharp, q2 / 12));
  }
  return out;
}

}  // namespace jalon
