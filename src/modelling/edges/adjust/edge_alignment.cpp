// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/edge_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace jalon {

namespace {

// Edges agree within so many standard deviations of their difference; those whose line was given by others too
// (EdgeShape::is_guided) a little further. Never further than so many spacings.
constexpr double kAgree = 2, kAgreeGuided = 4, kEdgeAlignmentMost = 1.5;
constexpr double kLeastSigma = 0.02;  // spacings: nothing is known better beside neighbours
constexpr std::array<Vec2, 4> kDirections{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};

struct Aligned {
  MeasuredEdge* edge;
  double place_m, sigma_m;
  bool is_taken = false;
};

double& coordinate(Vec2& p, const Vec2& direction) { return direction.u == 0 ? p.u : p.v; }

std::vector<Aligned> in_direction(std::span<MeasuredEdge* const> edges, const Vec2& direction,
                                  double spacing_m) {
  std::vector<Aligned> out;
  for (MeasuredEdge* edge : edges) {
    EdgeShape& s = edge->shape;
    if (s.is_arc || s.line.direction.u != direction.u || s.line.direction.v != direction.v)
      continue;
    if (!(s.sigma_m > 0)) continue;
    out.push_back(
        {edge, coordinate(s.line.point, direction), std::max(s.sigma_m, kLeastSigma * spacing_m)});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Aligned& a, const Aligned& b) { return a.sigma_m < b.sigma_m; });
  return out;
}

void align(std::vector<Aligned>& all, const Vec2& direction, double spacing_m) {
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i].is_taken) continue;
    // 1. What agrees with the best that is left, better ones first.
    std::vector<size_t> members;
    const double origin = all[i].place_m;
    double weight = 0, moment = 0;
    for (size_t k = i; k < all.size(); ++k) {
      if (all[k].is_taken) continue;
      const double mean = weight > 0 ? moment / weight : 0, variance = weight > 0 ? 1 / weight : 0;
      const double sigma = std::sqrt(variance + all[k].sigma_m * all[k].sigma_m),
                   own = all[k].place_m - origin;
      const double limit = all[k].edge->shape.is_guided ? kAgreeGuided : kAgree;
      if (std::fabs(own - mean) > std::min(limit * sigma, kEdgeAlignmentMost * spacing_m)) continue;
      members.push_back(k);
      weight += 1 / (all[k].sigma_m * all[k].sigma_m);
      moment += own / (all[k].sigma_m * all[k].sigma_m);
    }
    // 2. One line for all of them.
    for (const size_t k : members) {
      EdgeShape& s = all[k].edge->shape;
      all[k].is_taken = true;
      if (members.size() < 2) continue;
      coordinate(s.line.point, direction) = origin + moment / weight;
      s.sigma_m = 1 / std::sqrt(weight);
      s.set_ends(s.first, s.last);
    }
  }
}

}  // namespace

void align_edges(std::span<MeasuredEdge* const> edges, double spacing_m) {
  for (const Vec2& direction : kDirections) {
    std::vector<Aligned> all = in_direction(edges, direction, spacing_m);
    align(all, direction, spacing_m);
  }
}

}  // namespace jalon
