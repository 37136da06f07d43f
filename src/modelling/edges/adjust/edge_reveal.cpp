// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/edge_reveal.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace jalon {

namespace {

constexpr size_t kLeastPoints = 8, kMostSampled = 400;
constexpr int kDraws =
    64;  // half of the points on the surface: a clean pair is among 64 with 1 - 1e-8
constexpr double kMostSlope = 0.6;     // 31 degrees: splayed embrasures
constexpr double kLeastBase_m = 0.01;  // between the heights of a pair
// Heights of the middle four fifths of a surface's points: those of a plane parallel to this one differ by 2.6 sigma.
constexpr double kLeastSpan_m = 0.012, kLeastSpanSigmas = 6;
// What fills an opening ends at its reveals: points in the opening, further from the edge than this many spacings or
// reaches, tell how far behind, the nearest tenth of them left out as mixed pixels.
constexpr double kFilling = 0.4, kFillingReaches = 2, kMixedShare = 0.1;
constexpr size_t kLeastFilling = 6;
constexpr double kAstray[] = {
    0.6, 1.1};  // spacings: half of one and noise, and where no point shows the edge
constexpr double kBeforeFilling_m = 0.006, kBeforeFillingSigmas = 3;
// Noise of points across a surface seen nearly along it: millimetres, whatever the spacing.
constexpr double kReach_m = 0.004, kReachOfSpacing = 0.12;
constexpr double kEdgeRevealOutlier = 3, kLeastSigma_m = 0.0003;
// Walls and reveals are square within a degree or two; what the points say of the slope is weighed with that.
constexpr double kEdgeRevealSlopeSigma = 0.03;
// Steeper than walls and reveals are out of square: an embrasure, which has as many points between its ends as
// anywhere, or a line through one column of points on a reveal and one on the frame behind it, which has none there.
constexpr double kOutOfSquare = 3 * kEdgeRevealSlopeSigma, kLeastBetween = 0.1;
constexpr double kBins = 8, kLeastBinsHit = 3;
constexpr double kTimesBackground = 2.5;

struct CrossLine {
  double offset_m = 0, slope = 0;
  double residual(const RevealPoint& p) const { return p.d_m - offset_m - slope * p.height_m; }
};

double quantile(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Step 1: without the pane or leaf that ends at the reveal, whose points would bend the line. assumed_m: where the
// reveal may lie, into the solid.
std::vector<RevealPoint> before_filling(std::span<const RevealPoint> points, double assumed_m,
                                        double reach_m, const RevealSetting& s) {
  std::vector<double> filling;
  const double outside = std::max(kFilling * s.spacing_m, kFillingReaches * reach_m);
  for (const RevealPoint& p : points)
    if (p.d_m < assumed_m - outside) filling.push_back(std::fabs(p.height_m));
  double limit = INFINITY;
  if (filling.size() >= kLeastFilling)
    limit = quantile(filling, kMixedShare) -
            std::max(kBeforeFilling_m, kBeforeFillingSigmas * s.sigma_m);
  std::vector<RevealPoint> out;
  for (const RevealPoint& p : points)
    if (std::fabs(p.height_m) < limit) out.push_back(p);
  return out;
}

// Step 2: the line with most points near it.
std::optional<CrossLine> draw_line(std::span<const RevealPoint> points, double reach_m) {
  std::optional<CrossLine> best;
  const size_t step = points.size() / kMostSampled + 1, count = (points.size() + step - 1) / step;
  double best_score = 0;
  for (int k = 0; k < kDraws; ++k) {
    RandomStream random(1, static_cast<uint64_t>(k));
    const RevealPoint &a = points[random.below(points.size())],
                      &b = points[random.below(points.size())];
    const double base = b.height_m - a.height_m;
    if (std::fabs(base) < kLeastBase_m) continue;
    CrossLine line;
    line.slope = (b.d_m - a.d_m) / base;
    if (std::fabs(line.slope) > kMostSlope) continue;
    line.offset_m = a.d_m - line.slope * a.height_m;
    double score = 0;
    for (size_t i = 0; i < count; ++i) {
      const double r = line.residual(points[i * step]) / reach_m;
      score += std::max(0.0, 1 - r * r);
    }
    if (score <= best_score) continue;
    best_score = score;
    best = line;
  }
  return best;
}

// Sums of a line fit, and its covariance.
struct LineSums {
  double n = 0, h = 0, hh = 0, d = 0, dh = 0;
  void add(const RevealPoint& p) {
    n += 1;
    h += p.height_m;
    hh += p.height_m * p.height_m;
    d += p.d_m;
    dh += p.d_m * p.height_m;
  }
  // Least squares with the slope's prior; prior: variance of a point over that of the slope.
  CrossLine solve(double prior) const {
    const double a = hh + prior, determinant = n * a - h * h;
    return {(a * d - h * dh) / determinant, (n * dh - h * d) / determinant};
  }
  double offset_variance(double sigma2, double prior) const {
    return sigma2 * (hh + prior) / (n * (hh + prior) - h * h);
  }
};

struct SettledLine {
  CrossLine line;
  double sigma_m = 0;
  std::vector<RevealPoint> inliers;
  LineSums sums;
};

// Step 3: least squares on the points near it, their own spread deciding which.
std::optional<SettledLine> settled_line(std::span<const RevealPoint> points, double reach_m,
                                        const CrossLine& drawn) {
  SettledLine out{drawn, reach_m / kEdgeRevealOutlier * 1.5, {}, {}};
  auto& [line, sigma_m, inliers, sums] = out;
  for (int round = 0; round < 6; ++round) {
    inliers.clear();
    sums = {};
    double squares = 0;
    for (const RevealPoint& p : points) {
      const double r = line.residual(p);
      if (std::fabs(r) > kEdgeRevealOutlier * sigma_m) continue;
      inliers.push_back(p);
      sums.add(p);
      squares += r * r;
    }
    if (inliers.size() < kLeastPoints) return std::nullopt;
    const double n = static_cast<double>(inliers.size());
    sigma_m =
        std::clamp(std::sqrt(squares / (n - 2)), kLeastSigma_m, reach_m / kEdgeRevealOutlier * 1.5);
    line = sums.solve(sigma_m * sigma_m / (kEdgeRevealSlopeSigma * kEdgeRevealSlopeSigma));
  }
  if (!(std::fabs(line.slope) <= kMostSlope)) return std::nullopt;
  return out;
}

// Step 4: more points than the clutter beside the edge explains, along most of the edge, and as far as it goes back.
bool is_surface(std::span<const RevealPoint> points, const SettledLine& settled,
                const RevealSetting& setting) {
  const auto& [line, sigma_m, inliers, sums] = settled;
  std::vector<double> heights;
  for (const RevealPoint& p : inliers) heights.push_back(p.height_m);
  const double first = quantile(heights, 0.1), span = quantile(heights, 0.9) - first;
  if (span < std::max(kLeastSpan_m, kLeastSpanSigmas * setting.sigma_m)) return false;
  const auto between = std::count_if(heights.begin(), heights.end(), [&](double h) {
    return h > first + span / 4 && h < first + 3 * span / 4;
  });
  if (std::fabs(line.slope) > kOutOfSquare &&
      static_cast<double>(between) < kLeastBetween * static_cast<double>(heights.size()))
    return false;
  double low = INFINITY, high = -INFINITY;
  for (const RevealPoint& p : points) {
    low = std::min(low, p.d_m);
    high = std::max(high, p.d_m);
  }
  const double inside = 2 * kEdgeRevealOutlier * sigma_m,
               rest = std::max(high - low - inside, inside);
  const double n = static_cast<double>(inliers.size());
  const double clutter = (static_cast<double>(points.size()) - n) * inside / rest;
  if (n < kTimesBackground * clutter + 3 * std::sqrt(clutter)) return false;
  std::vector<uint8_t> hit(static_cast<size_t>(kBins), 0);
  for (const RevealPoint& p : inliers)
    hit[static_cast<size_t>(std::clamp(p.t_m / setting.length_m, 0.0, 0.999) * kBins)] = 1;
  return std::count(hit.begin(), hit.end(), 1) >= static_cast<ptrdiff_t>(kLeastBinsHit);
}

// Step 5: the offset in bins along the edge.
std::vector<EdgeOffset> binned(std::span<const RevealPoint> inliers, const CrossLine& line,
                               double sigma_m, double length_m) {
  struct Bin {
    double n = 0, t = 0, d = 0;
  };
  std::vector<Bin> bins(static_cast<size_t>(kBins));
  for (const RevealPoint& p : inliers) {
    Bin& bin = bins[static_cast<size_t>(std::clamp(p.t_m / length_m, 0.0, 0.999) * kBins)];
    bin.n += 1;
    bin.t += p.t_m;
    bin.d += p.d_m - line.slope * p.height_m;
  }
  std::vector<EdgeOffset> out;
  for (const Bin& bin : bins)
    if (bin.n > 0) out.push_back({bin.t / bin.n, bin.d / bin.n, bin.n / (sigma_m * sigma_m)});
  return out;
}

// Steps 1 to 5.
std::optional<Reveal> find_about(std::span<const RevealPoint> points, double assumed_m,
                                 const RevealSetting& setting) {
  const double reach_m = std::max(kReach_m, kReachOfSpacing * setting.spacing_m);
  const auto used = before_filling(points, assumed_m, reach_m, setting);
  if (used.size() < kLeastPoints) return std::nullopt;
  const std::optional<CrossLine> drawn = draw_line(used, reach_m);
  if (!drawn) return std::nullopt;
  const std::optional<SettledLine> settled = settled_line(used, reach_m, *drawn);
  if (!settled) return std::nullopt;
  const auto& [line, sigma, inliers, sums] = *settled;
  if (!is_surface(used, *settled, setting)) return std::nullopt;
  double nearest = INFINITY, farthest = 0;
  for (const RevealPoint& p : inliers) {
    nearest = std::min(nearest, std::fabs(p.height_m));
    farthest = std::max(farthest, std::fabs(p.height_m));
  }
  const double prior = sigma * sigma / (kEdgeRevealSlopeSigma * kEdgeRevealSlopeSigma),
               variance = sigma * sigma;
  Reveal out;
  out.offset_m = line.offset_m;
  out.slope = line.slope;
  out.common_m2 = std::max(0.0, sums.offset_variance(variance, prior) - variance / sums.n);
  out.per_metre2 = sums.n / (setting.length_m * (farthest - nearest));
  out.offsets = binned(inliers, line, sigma, setting.length_m);
  return out;
}

}  // namespace

std::optional<Reveal> find_reveal(std::span<const RevealPoint> points,
                                  const RevealSetting& setting) {
  if (auto found = find_about(points, 0, setting)) return found;
  // An edge between two columns of points may be assumed so far in the solid that the reveal itself looks like what
  // fills the opening. Once it is found, it tells what does.
  for (const double astray : kAstray)
    if (auto found = find_about(points, -astray * setting.spacing_m, setting)) {
      auto again = find_about(points, found->offset_m, setting);
      return again ? again : found;
    }
  return std::nullopt;
}

}  // namespace jalon
