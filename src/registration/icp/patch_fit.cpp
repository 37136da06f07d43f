// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/patch_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace jalon {

namespace {

constexpr size_t kPlane = 3, kParaboloid = 6;  // coefficients
constexpr size_t kPatchFitLeastPoints = 10;    // of both clouds
constexpr size_t kLeastOfEach = 3;             // of either cloud
constexpr size_t kLeastBent = 30;              // for a paraboloid
constexpr int kFits = 2;                       // with weights of the one before
constexpr double kMisfit = 3;            // standard deviations of a variance of so many points
constexpr double kDoubted = 0.3;         // weight of a point that does not lie on the surface
constexpr double kMostDoubted = 0.05;    // share of them; more are a bend
constexpr double kMostNoises = 2;        // scatter of the points about their surface
constexpr double kMostTaken = 0.8;       // leverage of a cloud's points, in the mean
constexpr double kLeastSlope = 2.0 / 3;  // of psi, against the weights: as between pairs
constexpr double kLeastLength_m = 1e-9;

using Coordinates = Coefficients<kParaboloid>;

/// Heights over a base plane, as functions of two coordinates of order 1.
struct PatchSurface {
  Vec3 u, v, n, centre;
  double length_m = 1;
  size_t unknowns = kPlane;
  Coefficients<kParaboloid> of{};
  std::vector<Coordinates> terms;
  std::vector<double> heights, weights;

  double residual(size_t i) const {
    double r = heights[i];
    for (size_t k = 0; k < unknowns; ++k) r -= of[k] * terms[i][k];
    return r;
  }
};

// Step 1: the base.
void set_base(const std::vector<PatchPoint>& points, const Vec3& normal, PatchSurface& out) {
  Vec3 sum;
  for (const PatchPoint& p : points) sum += p.place;
  const auto count = static_cast<double>(points.size());
  out.centre = sum / count;
  const Vec3 other = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  out.n = normal;
  out.u = normalized(cross(normal, other));
  out.v = cross(normal, out.u);
  double squares = 0;
  for (const PatchPoint& p : points) squares += squared_norm(p.place - out.centre);
  out.length_m = std::sqrt(squares / count) + kLeastLength_m;
  out.terms.resize(points.size());
  out.heights.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 d = points[i].place - out.centre;
    const double x = dot(out.u, d) / out.length_m, y = dot(out.v, d) / out.length_m;
    out.terms[i] = {1, x, y, x * x, x * y, y * y};
    out.heights[i] = dot(out.n, d);
  }
}

// Step 2: least squares with weights. The variance (m2) of the heights about the surface; none
// where the points do not fix it.
std::optional<double> fit(const RobustKernel& kernel, PatchSurface& s) {
  double variance_m2 = 0;
  const size_t count = s.heights.size(), m = s.unknowns;
  s.weights.assign(count, 1);
  for (int pass = 0; pass < kFits; ++pass) {
    Square<kParaboloid> normal{};
    Coefficients<kParaboloid> right{};
    for (size_t i = 0; i < count; ++i)
      for (size_t r = 0; r < m; ++r) {
        const double wq = s.weights[i] * s.terms[i][r];
        right[r] += wq * s.heights[i];
        for (size_t c = 0; c <= r; ++c) normal[kParaboloid * r + c] += wq * s.terms[i][c];
      }
    for (size_t r = m; r < kParaboloid; ++r)
      normal[(kParaboloid + 1) * r] = 1;  // those left out stay 0
    Cholesky<kParaboloid> factor;
    if (!factor.factor(normal)) return std::nullopt;
    s.of = factor.solve(right);
    double squares = 0, weights = 0;
    for (size_t i = 0; i < count; ++i) {
      const double r = s.residual(i);
      s.weights[i] = kernel.weight(r);
      squares += s.weights[i] * r * r;
      weights += s.weights[i];
    }
    if (weights < static_cast<double>(kPatchFitLeastPoints)) return std::nullopt;
    variance_m2 = squares / (weights - static_cast<double>(m));
  }
  return variance_m2;
}

// Step 3: a plane, or a paraboloid where the points scatter about the plane more than their noise
// does. False where neither does.
bool fit_surface(double noise_m, const RobustKernel& kernel, PatchSurface& s) {
  std::optional<double> variance_m2 = fit(kernel, s);
  if (!variance_m2) return false;
  const auto count = static_cast<double>(s.heights.size());
  const auto doubted = static_cast<double>(
      std::count_if(s.weights.begin(), s.weights.end(), [](double w) { return w <= kDoubted; }));
  const bool bent = *variance_m2 > noise_m * noise_m * (1 + kMisfit * std::sqrt(2 / count)) ||
                    doubted > kMostDoubted * count;
  if (bent && s.heights.size() >= kLeastBent) {
    s.unknowns = kParaboloid;
    variance_m2 = fit(kernel, s);
    if (!variance_m2) return false;
  }
  return *variance_m2 <= kMostNoises * kMostNoises * noise_m * noise_m;
}

/// Sums of one cloud's points on a patch.
struct Side {
  Square<kParaboloid> terms{};
  double squares = 0, weights = 0, count = 0;
};

/// Equations of one patch before its surface is eliminated.
struct PatchEquations {
  Side reference, moving;
  Square<6> pose{};                    ///< sum of w j j^T, of the moving points
  Square<6> mixed{};                   ///< sum of - w j q^T
  Coefficients<6> right{}, surface{};  ///< sums of - w r j and of w r q
};

// Step 4: residual r + j x - q ds of each point, along the normal of the surface where it lies.
void add_points(const std::vector<PatchPoint>& points, const PatchSurface& s,
                const RobustKernel& kernel, const IcpFrame& frame, PatchEquations& e,
                PatchSums& sums) {
  const size_t m = s.unknowns;
  for (size_t i = 0; i < points.size(); ++i) {
    const double x = s.terms[i][1], y = s.terms[i][2];
    double du = s.of[1], dv = s.of[2];
    if (m == kParaboloid) {
      du += 2 * s.of[3] * x + s.of[4] * y;
      dv += s.of[4] * x + 2 * s.of[5] * y;
    }
    du /= s.length_m;
    dv /= s.length_m;
    const double shorter = 1 / std::sqrt(1 + du * du + dv * dv), r = s.residual(i) * shorter,
                 w = kernel.weight(r);
    if (w == 0) continue;
    Side& side = points[i].moving ? e.moving : e.reference;
    Coefficients<kParaboloid> q{};
    for (size_t k = 0; k < m; ++k) q[k] = s.terms[i][k] * shorter;
    for (size_t a = 0; a < m; ++a) {
      e.surface[a] += w * r * q[a];
      for (size_t b = 0; b <= a; ++b) side.terms[kParaboloid * a + b] += w * q[a] * q[b];
    }
    side.squares += w * w * r * r;
    side.weights += w;
    side.count += 1;
    sums.squares += w * r * r;
    sums.weights += w;
    sums.slopes += kernel.slope(r);
    if (!points[i].moving) continue;
    const Vec3 normal = (s.n - s.u * du - s.v * dv) * shorter;
    const Vec3 turn = cross((points[i].place - frame.centre) / frame.extent_m, normal);
    const double j[6] = {turn.x, turn.y, turn.z, normal.x, normal.y, normal.z};
    for (size_t a = 0; a < 6; ++a) {
      const double wj = w * j[a];
      e.right[a] -= wj * r;
      for (size_t b = 0; b <= a; ++b) e.pose[6 * a + b] += wj * j[b];
      for (size_t b = 0; b < m; ++b) e.mixed[kParaboloid * a + b] -= wj * q[b];
    }
  }
}

void mirror_of_patch_fit(Square<6>& m) {
  for (size_t r = 0; r < 6; ++r)
    for (size_t c = r + 1; c < 6; ++c) m[6 * r + c] = m[6 * c + r];
}

// Mean psi^2 of a cloud's points by their weight. A surface through few points fits them better than the true one: of n
// points it takes up the trace of their share in the equations (the sum of their leverages).
double squared_psi(const Side& side, const Cholesky<kParaboloid>& both) {
  double taken = 0;
  for (size_t c = 0; c < kParaboloid; ++c) {
    Coefficients<kParaboloid> column;
    for (size_t r = 0; r < kParaboloid; ++r) column[r] = side.terms[kParaboloid * r + c];
    taken += both.solve(column)[c];
  }
  return side.squares / side.weights / (1 - std::min(taken / side.count, kMostTaken));
}

// Step 5: the surface is eliminated (Schur complement). A moving point acts on the pose by g = j - K q, one of the
// reference by -K q, with K = mixed surface^-1 of both clouds, and each by the noise of its own cloud here.
bool add_reduced(PatchEquations& e, size_t unknowns, PatchSums& sums) {
  mirror_of_patch_fit(e.pose);
  mirror_of_patch_fit(e.reference.terms);
  mirror_of_patch_fit(e.moving.terms);
  Square<6> both{};
  for (size_t i = 0; i < 36; ++i) both[i] = e.reference.terms[i] + e.moving.terms[i];
  for (size_t r = unknowns; r < 6; ++r) both[7 * r] = 1;
  Cholesky<6> factor;
  if (!factor.factor(both)) return false;
  Square<6> k{};  // of K the rows
  for (size_t r = 0; r < 6; ++r) {
    Coefficients<6> row;
    std::copy_n(e.mixed.begin() + static_cast<ptrdiff_t>(6 * r), 6, row.begin());
    row = factor.solve(row);
    std::copy(row.begin(), row.end(), k.begin() + static_cast<ptrdiff_t>(6 * r));
  }
  const double of_reference = squared_psi(e.reference, factor),
               of_moving = squared_psi(e.moving, factor);
  // Weights pull less than their slope would, and the less the more the points scatter.
  const double slope = std::clamp(sums.slopes / sums.weights, kLeastSlope, 1.0);
  const Square<6> by_reference = propagated<6, 6>(k, e.reference.terms);
  const Square<6> by_moving = propagated<6, 6>(k, e.moving.terms);
  for (size_t r = 0; r < 6; ++r) {
    sums.right[r] += e.right[r];
    for (size_t a = 0; a < unknowns; ++a) sums.right[r] -= k[6 * r + a] * e.surface[a];
    for (size_t c = 0; c < 6; ++c) {
      double mixed = 0;  // mixed K^T
      double turned = 0;
      for (size_t a = 0; a < unknowns; ++a) {
        mixed += e.mixed[6 * r + a] * k[6 * c + a];
        turned += k[6 * r + a] * e.mixed[6 * c + a];
      }
      sums.normal[6 * r + c] += slope * (e.pose[6 * r + c] - mixed);
      sums.scatter[6 * r + c] +=
          of_reference * by_reference[6 * r + c] +
          of_moving * (e.pose[6 * r + c] - mixed - turned + by_moving[6 * r + c]);
    }
  }
  return true;
}

}  // namespace

PatchSums& PatchSums::operator+=(const PatchSums& b) {
  for (size_t i = 0; i < 36; ++i) {
    normal[i] += b.normal[i];
    scatter[i] += b.scatter[i];
  }
  for (size_t i = 0; i < 6; ++i) right[i] += b.right[i];
  squares += b.squares;
  weights += b.weights;
  slopes += b.slopes;
  points += b.points;
  of_moving += b.of_moving;
  patches += b.patches;
  return *this;
}

void add_patch(const std::vector<PatchPoint>& points, const Vec3& normal, double noise_m,
               const RobustKernel& kernel, const IcpFrame& frame, PatchSums& sums) {
  const auto moving = static_cast<size_t>(
      std::count_if(points.begin(), points.end(), [](const PatchPoint& p) { return p.moving; }));
  if (points.size() < kPatchFitLeastPoints ||
      std::min(moving, points.size() - moving) < kLeastOfEach)
    return;
  PatchSurface surface;
  set_base(points, normal, surface);
  if (!fit_surface(noise_m, kernel, surface)) return;
  PatchEquations equations;
  PatchSums part;
  add_points(points, surface, kernel, frame, equations, part);
  const double all = equations.reference.count + equations.moving.count;
  if (std::min(equations.reference.count, equations.moving.count) <
          static_cast<double>(kLeastOfEach) ||
      all < static_cast<double>(kPatchFitLeastPoints) ||
      !add_reduced(equations, surface.unknowns, part))
    return;
  part.points = static_cast<uint64_t>(all);
  part.of_moving = static_cast<uint64_t>(equations.moving.count);
  part.patches = 1;
  sums += part;
}

}  // namespace jalon
