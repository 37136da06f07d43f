// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/error.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr double kOnePlace_m = 1e-4;  // a tenth of a millimetre: duplicates of Boulaassal 2010, 3.3
constexpr double kAsymmetry = 1e-9;   // of a covariance, relative to its variances
constexpr double kNegative =
    -1e-12;  // smallest eigenvalue against the largest: rounding of a rank-deficient one

std::string named(const Target& target, size_t i) {
  return target.name.empty() ? std::to_string(i) : "\"" + target.name.substr(0, 100) + "\"";
}

void require_names_differ(std::span<const Target> targets, const char* side) {
  std::map<std::string, size_t> seen;
  for (size_t i = 0; i < targets.size(); ++i) {
    if (targets[i].name.empty()) continue;
    const auto [at, fresh] = seen.emplace(targets[i].name, i);
    if (!fresh)
      fail(Status::kInvalidArgument, "%s targets %zu and %zu are both named \"%.100s\"", side,
           at->second, i, targets[i].name.c_str());
  }
}

void require_places_differ(std::span<const Target> targets, const char* side) {
  std::vector<size_t> order(targets.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return targets[a].xyz.x != targets[b].xyz.x ? targets[a].xyz.x < targets[b].xyz.x : a < b;
  });
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1; j < order.size(); ++j) {
      const Vec3 apart = targets[order[j]].xyz - targets[order[i]].xyz;
      if (apart.x > kOnePlace_m) break;
      if (norm(apart) > kOnePlace_m) continue;
      const size_t first = std::min(order[i], order[j]), second = std::max(order[i], order[j]);
      fail(Status::kInvalidArgument, "%s targets %s and %s lie at one place", side,
           named(targets[first], first).c_str(), named(targets[second], second).c_str());
    }
}

void require_covariance(const Target& target, size_t i, const char* side) {
  const auto& c = target.covariance;
  double largest = 0;
  for (const double v : c) largest = std::max(largest, std::fabs(v));
  for (size_t r = 0; r < 3; ++r)
    for (size_t k = 0; k < r; ++k)
      if (!(std::fabs(c[3 * r + k] - c[3 * k + r]) <= kAsymmetry * largest))
        fail(Status::kInvalidArgument, "the covariance of %s target %s is not symmetric", side,
             named(target, i).c_str());
  const Eigen3 eigen = symmetric_eigen({c[0], c[1], c[2], c[4], c[5], c[8]});
  if (!(eigen.values[0] >= kNegative * largest))
    fail(Status::kInvalidArgument, "the covariance of %s target %s has a negative variance", side,
         named(target, i).c_str());
}

}  // namespace

void require_distinct(std::span<const Target> targets, const char* side) {
  for (size_t i = 0; i < targets.size(); ++i) {
    if (!is_finite(targets[i].xyz))
      fail(Status::kInvalidArgument, "%s target %s has a coordinate that is not finite", side,
           named(targets[i], i).c_str());
    require_covariance(targets[i], i, side);
  }
  require_names_differ(targets, side);
  require_places_differ(targets, side);
}

std::vector<IndexPair> pairs_by_name(std::span<const Target> reference,
                                     std::span<const Target> moving) {
  std::map<std::string, size_t> at;
  for (size_t i = 0; i < reference.size(); ++i)
    if (!reference[i].name.empty()) at.emplace(reference[i].name, i);
  std::vector<IndexPair> pairs;
  for (size_t i = 0; i < moving.size(); ++i)
    if (const auto found = at.find(moving[i].name); found != at.end())
      pairs.push_back({found->second, i});
  return pairs;
}

Vec3 origin_of(std::span<const Target> targets) {
  if (targets.empty()) return {};
  const Vec3& first = targets[0].xyz;
  return {std::floor(first.x), std::floor(first.y), std::floor(first.z)};
}

Square<3> covariance_of(const Target& target, double sigma_m) {
  const bool given = std::any_of(target.covariance.begin(), target.covariance.end(),
                                 [](double c) { return c != 0; });
  if (given) return target.covariance;
  const double v = sigma_m * sigma_m;
  return {v, 0, 0, 0, v, 0, 0, 0, v};
}

std::vector<TargetPair> measured_pairs(std::span<const Target> reference,
                                       std::span<const Target> moving,
                                       std::span<const IndexPair> pairs,
                                       const Vec3& reference_origin, const Vec3& moving_origin,
                                       double sigma_m) {
  std::vector<TargetPair> out;
  for (const IndexPair& pair : pairs) {
    const Target &r = reference[pair.reference], &m = moving[pair.moving];
    out.push_back({r.xyz - reference_origin, m.xyz - moving_origin, covariance_of(r, sigma_m),
                   covariance_of(m, sigma_m)});
  }
  return out;
}

}  // namespace jalon
