// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/chain_parts.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/edges/find/part_costs.h"

namespace jalon {

namespace {

// Candidate corners: Douglas-Peucker with this tolerance in spacings, and no two further apart than so many points, for
// the smooth passage of a line into an arc is no corner.
constexpr double kCandidateTolerance = 0.8;
constexpr size_t kCandidateStep = 16;
constexpr size_t kBesideCorner = 3;
// What is not worth extending is looked at for some more candidates.
constexpr int kPatience = 4;
constexpr double kChainPartsLeastSine = 0.3;  // of the angle of a corner that is cut

// Where corners follow closely on each other every point may be one.
void add_corner_points(std::vector<size_t>& ends) {
  std::vector<size_t> out;
  for (size_t k = 0; k < ends.size(); ++k) {
    const size_t low = k == 0 ? 0 : ends[k - 1] + 1, gap = ends[k] + 1 - low;
    const size_t from = gap <= 2 * kBesideCorner ? low : ends[k] - kBesideCorner;
    for (size_t i = from; k > 0 && i < ends[k]; ++i) out.push_back(i);
    out.push_back(ends[k]);
    if (k + 1 == ends.size() || ends[k + 1] - ends[k] <= 2 * kBesideCorner) continue;
    for (size_t i = 1; i <= kBesideCorner; ++i) out.push_back(ends[k] + i);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  ends = std::move(out);
}

// Where parts may end, ascending, from 0 to the chain's size (its first point again).
std::vector<size_t> candidates(const PartCosts& s) {
  std::vector<size_t> out;
  for (const uint32_t i : simplified(s.chain, kCandidateTolerance * s.setting.spacing_m, true)) {
    if (!out.empty())
      for (size_t k = out.back() + kCandidateStep; k + kCandidateStep / 2 < i; k += kCandidateStep)
        out.push_back(k);
    out.push_back(i);
  }
  for (size_t k = out.back() + kCandidateStep; k + kCandidateStep / 2 < s.chain.size();
       k += kCandidateStep)
    out.push_back(k);
  out.push_back(s.chain.size());
  if (s.setting.guides != nullptr) add_corner_points(out);
  return out;
}

// Least total cost of the chain up to each candidate, and where its last part begins.
std::vector<size_t> cheapest_cuts(const PartCosts& s, const std::vector<size_t>& ends) {
  const size_t n = ends.size();
  std::vector<double> total(n, INFINITY);
  std::vector<size_t> from(n, 0);
  total[0] = 0;
  for (size_t i = 0; i + 1 < n; ++i) {
    int hopeless = 0;
    for (size_t j = i + 1; j < n && hopeless < kPatience; ++j) {
      const auto points = s.moments.stretch(ends[i], ends[j]);
      const double count = point_count(ends[i], ends[j]);
      // No part costs less than its points and a cut, and most are known by then to be a piece of a longer one.
      if (!(total[i] + (count + s.cut_cost) < total[j]) &&
          !is_hopeless(cost_of_misfit(s, points.squares(), count), count)) {
        hopeless = 0;
        continue;
      }
      const PartCost part = cost_of(s, points, ends[i], ends[j]);
      hopeless = part.is_hopeless ? hopeless + 1 : 0;
      if (!(total[i] + part.cost < total[j])) continue;
      total[j] = total[i] + part.cost;
      from[j] = i;
    }
  }
  std::vector<size_t> cuts;
  for (size_t j = n - 1; j > 0; j = from[j]) cuts.push_back(ends[j]);
  cuts.push_back(ends[0]);
  std::reverse(cuts.begin(), cuts.end());
  return cuts;
}

// Moves each inner cut to the point where its two parts cost least.
void settle(const PartCosts& s, std::vector<size_t>& cuts) {
  constexpr size_t kSteps[] = {8, 4, 2, 1};
  for (const size_t step : kSteps)
    for (size_t k = 1; k + 1 < cuts.size(); ++k) {
      const size_t low = cuts[k - 1] + 2, high = cuts[k + 1] - 2;
      size_t best = cuts[k];
      double least = cost_of(s, cuts[k - 1], best).cost + cost_of(s, best, cuts[k + 1]).cost;
      for (const size_t trial : {cuts[k] - std::min(step, cuts[k]), cuts[k] + step}) {
        if (trial < low || trial > high) continue;
        const double cost =
            cost_of(s, cuts[k - 1], trial).cost + cost_of(s, trial, cuts[k + 1]).cost;
        if (!(cost < least)) continue;
        least = cost;
        best = trial;
      }
      cuts[k] = best;
    }
}

// Removes cuts whose two parts cost less as one.
void join(const PartCosts& s, std::vector<size_t>& cuts) {
  for (size_t k = 1; k + 1 < cuts.size() && cuts.size() > 3;) {
    const double two =
        cost_of(s, cuts[k - 1], cuts[k]).cost + cost_of(s, cuts[k], cuts[k + 1]).cost;
    if (cost_of(s, cuts[k - 1], cuts[k + 1]).cost < two)
      cuts.erase(cuts.begin() + static_cast<ptrdiff_t>(k));
    else ++k;
  }
}

// The cut where the chain turns most is a corner whatever the start was.
size_t sharpest(const PartCosts& s, const std::vector<size_t>& cuts) {
  size_t best = 0;
  double most = -1;
  for (size_t k = 0; k + 1 < cuts.size(); ++k) {
    const size_t before = k == 0 ? cuts[cuts.size() - 2] : cuts[k - 1];
    const Vec2 in = s.at(cuts[k]) - s.at(before), out = s.at(cuts[k + 1]) - s.at(cuts[k]);
    const double turn = std::fabs(std::atan2(cross(in, out), dot(in, out)));
    if (turn <= most) continue;
    most = turn;
    best = cuts[k] % s.chain.size();
  }
  return best;
}

ChainPart make_part(const PartCosts& s, size_t first, size_t last) {
  const PartCost cost = cost_of(s, first, last);
  ChainPart part{first, last - first + 1, cost.is_arc, cost.is_guided, cost.guide, {}, 0};
  if (part.is_arc) {
    part.circle = s.moments.stretch(first, last).arc().circle;
    part.turn = swept(s, part.circle, first, last) > 0 ? 1 : -1;
  } else if (!part.is_guided) {
    part.line = s.moments.stretch(first, last).line().line;
    if (dot(part.line.direction, s.at(last) - s.at(first)) < 0)
      part.line.direction = part.line.direction * -1;
  }
  return part;
}

// Steps across corners give way to the corners, where the parts beside them meet near by.
void drop_bridges(const PartCosts& s, std::vector<ChainPart>& parts) {
  for (size_t i = 0; i < parts.size() && parts.size() > 3;) {
    const size_t n = parts.size(), first = parts[i].first, last = first + parts[i].count - 1;
    const ChainPart &a = parts[(i + n - 1) % n], &c = parts[(i + 1) % n];
    const auto corner = intersect(a.line, c.line, kChainPartsLeastSine);
    const bool is_cut = is_bridge(s, first, last) && !parts[i].is_guided && !a.is_arc &&
                        !c.is_arc && corner && norm(*corner - s.at(first)) <= s.setting.bridge_m &&
                        norm(*corner - s.at(last)) <= s.setting.bridge_m &&
                        dot(a.line.direction, *corner - s.at(a.first)) > 0 &&
                        dot(c.line.direction, s.at(c.first + c.count - 1) - *corner) > 0;
    if (is_cut) parts.erase(parts.begin() + static_cast<ptrdiff_t>(i));
    else ++i;
  }
}

std::vector<size_t> cut(const PartCosts& s) {
  std::vector<size_t> cuts = cheapest_cuts(s, candidates(s));
  settle(s, cuts);
  join(s, cuts);
  return cuts;
}

}  // namespace

std::vector<ChainPart> split_chain(std::span<const Vec2> chain, const PartsSetting& setting) {
  // 1. From any start, for a corner to start from.  2. From that corner.
  std::vector<Vec2> turned(chain.begin(), chain.end());
  const size_t start = [&] {
    const PartCosts first(chain, setting);
    return sharpest(first, cut(first));
  }();
  std::rotate(turned.begin(), turned.begin() + static_cast<ptrdiff_t>(start), turned.end());
  const PartCosts s(turned, setting);
  const auto cuts = cut(s);
  std::vector<ChainPart> parts;
  for (size_t k = 0; k + 1 < cuts.size(); ++k) parts.push_back(make_part(s, cuts[k], cuts[k + 1]));
  drop_bridges(s, parts);
  for (ChainPart& part : parts) part.first = (part.first + start) % chain.size();
  // 3. A ring that is one circle is two arcs: a ring has corners.
  if (parts.size() == 1 && parts[0].is_arc) {
    ChainPart half = parts[0];
    parts[0].count = chain.size() / 2 + 1;
    half.first = (half.first + chain.size() / 2) % chain.size();
    half.count = chain.size() - chain.size() / 2 + 1;
    parts.push_back(half);
  }
  return parts;
}

}  // namespace jalon
