// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/pattern_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "geometry/adjustment.h"
#include "registration/targets/disc_outline.h"
#include "registration/targets/pattern_covariance.h"

namespace jalon {

namespace {

constexpr double kPhaseShare = 0.45;  // radius, of the inner edge: what the quadrants surely fill
// Ground that is looked at, beyond the half-edge or radius: this share of it, or so many spacings. A sheet has little
// of it around its pattern.
constexpr double kGroundShare = 0.15, kGroundSpacings = 1.5;
constexpr double kMostSigned = 1.5;  // a ground brighter than white counts no more than this
constexpr size_t kLeastExtentPoints = 24;
constexpr size_t kLeastGroundPoints = 8;    // around a disc; beyond quadrants of either kind
constexpr double kShell = 0.5;              // spacings: of those that a border is sought in
constexpr double kNearLine = 0.75;          // spacings: closer to a line a point sees both sides
constexpr double kMadToDeviation = 1.4826;  // median of |x| of the standard normal, inverted
constexpr double kUnevenQuadrants = 0.25;   // of the contrast: those of a print are alike
constexpr double kUnevenGround = 0.35;      // of the contrast, scatter of what is around a target
constexpr double kNextShare = 1.5;          // of the half-edge: so far a next tile is looked for
constexpr double kNextTile = 0.5;   // mean signed brightness: -1 of a next tile, 0 of a ground
constexpr double kLeastBeyond = 3;  // points of half a side
constexpr int kSectors = 8;         // around a disc; one may be hidden
constexpr double kNoiseCell = 2;    // spacings: cells of some four points
constexpr size_t kLeastDifferences = 8;
constexpr int kExtentSteps = 60;
constexpr double kSmallExtent = 1e-6;  // of what an edge notices

/// Bright and dark quadrants that end at a square in a uniform ground. Points are (distance from the
/// centre along the farther axis, quadrant +1 or -1, value).
struct BorderModel {
  using Point = BrightPoint;
  static constexpr size_t kUnknowns = 4;
  double half_m = 0, bright = 1, dark = 0, ground = 0, width_m = 0.001;

  double residual(const BrightPoint& p, Coefficients<4>& j) const {
    const double t = std::tanh((half_m - p.u) / width_m), inside = (1 + t) / 2;
    const double level = p.v > 0 ? bright : dark;
    j = {(level - ground) * tanh_slope(t) / (2 * width_m), p.v > 0 ? inside : 0,
         p.v > 0 ? 0 : inside, 1 - inside};
    return ground + (level - ground) * inside - p.value;
  }
  void move(const Coefficients<4>& x) {
    half_m += x[0], bright += x[1], dark += x[2], ground += x[3];
  }
  Coefficients<4> units(double) const {
    const double contrast = std::fabs(bright - dark);
    return {width_m, contrast, contrast, contrast};
  }
};

// How the quadrants lie: bright where cos(2 (angle - turn)) > 0 before the eighth of a turn.
struct Quadrants {
  double turn_rad = 0, level = 0, contrast = 0;  ///< value = level +- contrast
};

// The second harmonic of the brightness around the centre is that of a checker, whatever else there is.
std::optional<Quadrants> quadrants_of(std::span<const BrightPoint> points, double inner_m) {
  double n = 0, mean = 0;
  const auto within = [&](const BrightPoint& p) {
    return std::hypot(p.u, p.v) < kPhaseShare * inner_m;
  };
  for (const BrightPoint& p : points)
    if (within(p)) ++n, mean += p.value;
  if (n < kLeastExtentPoints) return std::nullopt;
  mean /= n;
  std::complex<double> sum = 0;
  for (const BrightPoint& p : points)
    if (within(p)) sum += (p.value - mean) * std::polar(1.0, 2 * std::atan2(p.v, p.u));
  Quadrants out;
  // Bright along the diagonal at this angle: the lines lie an eighth of a turn off.
  out.turn_rad = std::arg(sum) / 2 - std::numbers::pi / 4;
  double sums[4] = {}, counts[4] = {};  // of quadrants; 0 and 3 are the bright ones
  const double c = std::cos(out.turn_rad), s = std::sin(out.turn_rad);
  for (const BrightPoint& p : points) {
    if (!within(p)) continue;
    const double x = c * p.u + s * p.v, y = c * p.v - s * p.u;
    const size_t quadrant = (x > 0 ? 2 : 0) + (y > 0 ? 1 : 0);
    sums[quadrant] += p.value, ++counts[quadrant];
  }
  for (size_t k = 0; k < 4; ++k) {
    if (counts[k] < kLeastBeyond) return std::nullopt;
    sums[k] /= counts[k];
  }
  const double bright = (sums[0] + sums[3]) / 2, dark = (sums[1] + sums[2]) / 2;
  out.level = (bright + dark) / 2, out.contrast = (bright - dark) / 2;
  if (!(out.contrast > 0)) return std::nullopt;
  const double uneven = std::max(std::fabs(sums[0] - sums[3]), std::fabs(sums[1] - sums[2]));
  if (uneven > kUnevenQuadrants * (bright - dark)) return std::nullopt;
  return out;
}

double spacing_of(std::span<const BrightPoint> points, double inner_m) {
  double n = 0;
  for (const BrightPoint& p : points) n += std::hypot(p.u, p.v) < kPhaseShare * inner_m;
  const double radius = kPhaseShare * inner_m;
  return std::sqrt(std::numbers::pi * radius * radius / std::max(n, 1.0));
}

// Distance along the farther axis, quadrant and brightness, nearest first; without what lies on the lines.
std::vector<BrightPoint> folded(std::span<const BrightPoint> points, const Quadrants& q,
                                double spacing_m) {
  const double c = std::cos(q.turn_rad), s = std::sin(q.turn_rad);
  std::vector<BrightPoint> out;
  for (const BrightPoint& p : points) {
    const double x = c * p.u + s * p.v, y = c * p.v - s * p.u;
    if (std::min(std::fabs(x), std::fabs(y)) < kNearLine * spacing_m) continue;
    out.push_back({std::max(std::fabs(x), std::fabs(y)), x * y > 0 ? 1.0 : -1.0, p.value});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const BrightPoint& a, const BrightPoint& b) { return a.u < b.u; });
  return out;
}

// Where the signed brightness goes from one to nothing: the likeliest change (Page 1955). In any uniform ground bright
// and dark quadrants cancel each other, as long as both have points: shells count by those of the fewer, else a dark
// ground of which the dark quadrants see more would be taken for theirs.
double border_of(const std::vector<BrightPoint>& list, const Quadrants& q, double spacing_m,
                 double most_m) {
  double sum = 0, best = 0, at = 0;
  for (size_t first = 0, end = 0; first < list.size() && list[first].u <= most_m; first = end) {
    double n[2] = {}, of[2] = {};  // of dark and bright quadrants
    for (; end < list.size() && list[end].u < list[first].u + kShell * spacing_m; ++end) {
      const BrightPoint& p = list[end];
      const double w = p.v * (p.value - q.level) / q.contrast;
      ++n[p.v > 0], of[p.v > 0] += std::clamp(w, -kMostSigned, kMostSigned);
    }
    const double fewer = std::min(n[0], n[1]);
    if (fewer > 0) sum += fewer * (of[0] / n[0] + of[1] / n[1] - 1);
    if (sum > best) best = sum, at = list[end - 1].u;
  }
  return at;
}

double reach_of(double half_m, double spacing_m) {
  return half_m + std::max(kGroundShare * half_m, kGroundSpacings * spacing_m);
}

// Of the brightness, from differences of points that share a cell: most cells hold no edge.
double noise_of(std::span<const BrightPoint> points, double spacing_m) {
  struct Placed {
    double row, column, value;
  };
  const double cell = kNoiseCell * spacing_m;
  std::vector<Placed> list;
  for (const BrightPoint& p : points)
    list.push_back({std::floor(p.u / cell), std::floor(p.v / cell), p.value});
  std::stable_sort(list.begin(), list.end(), [](const Placed& a, const Placed& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
  std::vector<double> sizes;
  for (size_t i = 1; i < list.size(); ++i)
    if (list[i].row == list[i - 1].row && list[i].column == list[i - 1].column)
      sizes.push_back(std::fabs(list[i].value - list[i - 1].value));
  if (sizes.size() < kLeastDifferences) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kMadToDeviation * *middle / std::numbers::sqrt2;
}

// What is left of the brightness beyond noise.
double misfit_of(const std::vector<double>& residuals, double noise, double variance) {
  double squares = 0;
  for (const double r : residuals) squares += r * r;
  const double mean = squares / std::max(1.0, static_cast<double>(residuals.size()));
  return residuals.empty() || !(variance > 0) ? 1 : std::max(0.0, mean - noise * noise) / variance;
}

double variance_of(std::span<const BrightPoint> points) {
  const auto n = static_cast<double>(points.size());
  double mean = 0, sum = 0;
  for (const BrightPoint& p : points) mean += p.value / n;
  for (const BrightPoint& p : points) sum += (p.value - mean) * (p.value - mean) / n;
  return sum;
}

// A part of a larger pattern: beyond a side dark follows bright and bright dark, or both go on. What a
// target sticks on is about the same beyond all halves of its sides.
bool goes_on(std::span<const BrightPoint> points, const Quadrants& q, double half_m,
             double spacing_m) {
  struct Half {
    double n = 0, sum = 0;
  } halves[4][2];
  const double c = std::cos(q.turn_rad), s = std::sin(q.turn_rad);
  for (const BrightPoint& p : points) {
    const double x = c * p.u + s * p.v, y = c * p.v - s * p.u;
    const double far = std::max(std::fabs(x), std::fabs(y)),
                 near = std::min(std::fabs(x), std::fabs(y));
    if (far < half_m + spacing_m || far > kNextShare * half_m || near > half_m) continue;
    const bool is_x = std::fabs(x) > std::fabs(y);
    const size_t side = is_x ? (x > 0 ? 0 : 1) : (y > 0 ? 2 : 3);
    Half& half = halves[side][x * y > 0 ? 0 : 1];
    const double w = (x * y > 0 ? 1 : -1) * (p.value - q.level) / q.contrast;
    ++half.n, half.sum += std::clamp(w, -kMostSigned, kMostSigned);
  }
  double n = 0, sum = 0, squares = 0;  // of the halves' brightness, over half the contrast
  for (const auto& side : halves) {
    for (size_t k = 0; k < 2; ++k) {
      if (side[k].n < kLeastBeyond) continue;
      const double level = (k == 0 ? 1 : -1) * side[k].sum / side[k].n;
      ++n, sum += level, squares += level * level;
    }
    if (side[0].n < kLeastBeyond || side[1].n < kLeastBeyond) continue;
    const double signed_mean = (side[0].sum / side[0].n + side[1].sum / side[1].n) / 2;
    if (std::fabs(signed_mean) > kNextTile) return true;
  }
  if (n < 2) return false;
  const double variance = (squares - sum * sum / n) / n;
  return std::sqrt(std::max(0.0, variance)) > 2 * kUnevenGround;
}

// Of a sheet with nothing around it, from its extents along both axes: scan lines along a side end up to a
// spacing short of it, others hardly.
double half_of_sheet(std::span<const BrightPoint> points, const Quadrants& q, double last_m,
                     double spacing_m) {
  const double c = std::cos(q.turn_rad), s = std::sin(q.turn_rad);
  double low[2] = {0, 0}, high[2] = {0, 0};
  for (const BrightPoint& p : points) {
    const double at[2] = {c * p.u + s * p.v, c * p.v - s * p.u};
    if (std::max(std::fabs(at[0]), std::fabs(at[1])) > last_m) continue;
    for (size_t k = 0; k < 2; ++k)
      low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
  }
  return (high[0] - low[0] + high[1] - low[1] + spacing_m) / 4;
}

// Beyond bright quadrants and beyond dark ones: on a dark ground only the former end in sight, and a ground that is
// seen beside the others alone leaves the border anywhere.
bool is_ground_seen(const std::vector<BrightPoint>& list, double from, double to) {
  size_t n[2] = {};
  for (const BrightPoint& p : list)
    if (p.u > from && p.u <= to) ++n[p.v > 0];
  return std::min(n[0], n[1]) >= kLeastGroundPoints;
}

std::vector<BrightPoint> nearer_than(const std::vector<BrightPoint>& list, double most) {
  std::vector<BrightPoint> out;
  for (const BrightPoint& p : list)
    if (p.u <= most) out.push_back(p);
  return out;
}

// A disc has its ground all around it; half of one may be anything that ends in a bow.
bool is_surrounded(const std::vector<BrightPoint>& points, double radius_m) {
  std::array<bool, kSectors> has_ground{};
  for (const BrightPoint& p : points) {
    if (std::hypot(p.u, p.v) <= radius_m) continue;
    const double turn = std::atan2(p.v, p.u) / (2 * std::numbers::pi) + 0.5;
    has_ground[std::min<size_t>(static_cast<size_t>(turn * kSectors), kSectors - 1)] = true;
  }
  return std::count(has_ground.begin(), has_ground.end(), true) >= kSectors - 1;
}

}  // namespace

std::optional<PatternExtent> checker_extent(std::span<const BrightPoint> points, double inner_m,
                                            double most_m, Task& task) {
  const auto quadrants = quadrants_of(points, inner_m);
  if (!quadrants) return std::nullopt;
  const double spacing = spacing_of(points, inner_m);
  const auto list = folded(points, *quadrants, spacing);
  BorderModel model;
  model.half_m = border_of(list, *quadrants, spacing, most_m / 2);
  if (!(model.half_m > spacing) || model.half_m > most_m / 2 - spacing) return std::nullopt;
  if (goes_on(points, *quadrants, model.half_m, spacing)) return std::nullopt;
  model.width_m = spacing;
  model.bright = quadrants->level + quadrants->contrast;
  model.dark = quadrants->level - quadrants->contrast;
  model.ground = quadrants->level;
  const double last = model.half_m, reach = reach_of(model.half_m, spacing);
  const bool has_ground = is_ground_seen(list, model.half_m, reach);
  const auto near = nearer_than(list, reach);
  if (near.size() < kLeastExtentPoints) return std::nullopt;
  PatternExtent out;
  // Where nothing is around it: two axes, each short of up to a spacing.
  out.sigma_m = spacing / std::sqrt(6.0);
  if (has_ground) {
    constexpr adjustment::Weighting kAll{INFINITY, INFINITY};
    auto small = model.units(0);
    for (double& s : small) s *= kSmallExtent;
    const std::span<const BrightPoint> all(near);
    if (!adjustment::descend(all, kAll, kExtentSteps, small, task, model)) return std::nullopt;
    const auto covariance = PatternCovariance<BorderModel>::estimate(all, model, model.half_m);
    if (!covariance || !(model.half_m > 0)) return std::nullopt;
    out.sigma_m = 2 * std::sqrt((*covariance)[0]);
    // Between the last of its points and a ground further off the border may be anywhere: near the former.
    model.half_m = std::min(model.half_m, last + spacing / 2);
  } else {
    model.half_m = half_of_sheet(points, *quadrants, last, spacing);
  }
  out.size_m = 2 * model.half_m;
  std::vector<double> residuals;
  Coefficients<4> unused;
  for (const BrightPoint& p : near)
    if (std::fabs(p.u - model.half_m) > spacing) residuals.push_back(model.residual(p, unused));
  const double noise = noise_of(points, spacing);
  out.misfit = misfit_of(residuals, noise, variance_of(near));
  out.contrast_to_noise = std::fabs(model.bright - model.dark) / noise;
  out.points = near.size();
  return out;
}

std::optional<PatternExtent> disc_extent(std::span<const BrightPoint> points, double diameter_m,
                                         double sigma_m) {
  const double radius = diameter_m / 2;
  const double width = spacing_of(points, diameter_m), reach = reach_of(radius, width);
  std::vector<BrightPoint> near;
  for (const BrightPoint& p : points)
    if (std::hypot(p.u, p.v) <= reach) near.push_back(p);
  if (near.size() < kLeastExtentPoints) return std::nullopt;
  // value = a + b t, t of the disc's edge: a regression.
  double n = 0, t = 0, v = 0, tt = 0, tv = 0, ground = 0;
  std::vector<double> shape;
  std::vector<size_t> clear;  // of the border
  for (const BrightPoint& p : near) {
    const double r = std::hypot(p.u, p.v), s = std::tanh((radius - r) / width);
    if (std::fabs(r - radius) > width) clear.push_back(shape.size());
    shape.push_back(s);
    ++n, t += s, v += p.value, tt += s * s, tv += s * p.value, ground += r > radius;
  }
  const double spread = tt - t * t / n;
  if (!is_surrounded(near, radius) || !(spread > 0) || ground < kLeastGroundPoints)
    return std::nullopt;
  const double b = (tv - t * v / n) / spread, a = (v - b * t) / n;
  std::vector<double> residuals, all;
  for (const size_t i : clear) residuals.push_back(a + b * shape[i] - near[i].value);
  for (const BrightPoint& p : points)
    all.push_back(a + b * std::tanh((radius - std::hypot(p.u, p.v)) / width) - p.value);
  const double noise = noise_of(points, width);
  return PatternExtent{diameter_m,
                       sigma_m,
                       misfit_of(residuals, noise, variance_of(near)),
                       2 * std::fabs(b) / noise,
                       near.size(),
                       chance_of_disc(points, all, radius, b)};
}

}  // namespace jalon
