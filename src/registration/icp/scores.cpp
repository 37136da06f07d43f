// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>

#include "registration/icp/influence.h"

namespace jalon {

namespace {

// Edge of a group, in radii of the planes: a point and the planes through it are within one or two.
constexpr double kGroupRadii = 8;

using Groups = std::map<std::array<int64_t, 3>, Coefficients<6>>;

void add_scores(const IcpPair& pair, IcpMetric metric, const IcpFrame& frame, double edge_m,
                Groups& groups) {
  const Vec3 at = pair.place / edge_m;
  Coefficients<6>& sum =
      groups[{static_cast<int64_t>(std::floor(at.x)), static_cast<int64_t>(std::floor(at.y)),
              static_cast<int64_t>(std::floor(at.z))}];
  PairTerm terms[3];
  for (size_t k = 0; k < pair_terms(pair, metric, terms); ++k) {
    const Vec3 turn = cross((pair.place - frame.centre) / frame.extent_m, terms[k].normal);
    const double score = terms[k].weight * terms[k].residual_m;
    const double j[6] = {turn.x,           turn.y, turn.z, terms[k].normal.x, terms[k].normal.y,
                         terms[k].normal.z};
    for (size_t i = 0; i < 6; ++i) sum[i] += score * j[i];
  }
}

}  // namespace

Square<6> icp_scores(const IcpPairing& at, const IcpFrame& frame) {
  Groups groups;
  const IcpClouds& clouds = at.clouds;
  const double edge_m =
      kGroupRadii * std::max({clouds.reference.radius_m, clouds.moving.radius_m, 1e-9});
  IcpPair pair;
  const Buffer<uint32_t>&forth = at.neighbours.of_moving, &back = at.neighbours.of_reference;
  for (size_t i = 0; i < forth.size(); ++i)
    if (const uint32_t r = forth[i];
        r != kNoPoint && pair_of(at, static_cast<uint32_t>(i), r, PairWay::kForth, pair))
      add_scores(pair, at.rule.metric, frame, edge_m, groups);
  for (size_t i = 0; i < back.size(); ++i)
    if (const uint32_t m = back[i];
        m != kNoPoint && pair_of(at, m, static_cast<uint32_t>(i), PairWay::kBack, pair))
      add_scores(pair, at.rule.metric, frame, edge_m, groups);
  Square<6> out{};
  for (const auto& [cell, sum] : groups)
    for (size_t r = 0; r < 6; ++r)
      for (size_t c = 0; c < 6; ++c) out[6 * r + c] += sum[r] * sum[c];
  // Groups share the unknowns: the small-sample factor of the sandwich.
  const auto n = static_cast<double>(groups.size());
  for (double& v : out) v *= n > 6 ? n / (n - 6) : 1;
  return out;
}

}  // namespace jalon
