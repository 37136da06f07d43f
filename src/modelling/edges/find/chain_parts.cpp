// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/chain_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/polygon2.h"
#include "modelling/edges/find/chain_moments.h"
#include "modelling/edges/find/rough_angle.h"

namespace jalon {

namespace {

// Standard deviation of contour points about their line, in spacings: 0.29 on a grid, up to 0.5 measured on scattered
// points, which are not independent of their neighbours either.
constexpr double kChainPartsNoise = 0.5;
// A part costs as much as on a ring of so many points at most: what a window's corner is worth on a window.
constexpr size_t kMostRing = 100;
// Candidate corners: Douglas-Peucker with this tolerance in spacings, and no two further apart than so many points, for
// the smooth passage of a line into an arc is no corner.
constexpr double kCandidateTolerance = 0.8;
constexpr size_t kCandidateStep = 16;
constexpr size_t kBesideCorner = 3;
constexpr size_t kLeastArcPoints = 8;
// Spacings. The triangulation bridges up to four of them, so that a corner it cuts looks like an arc of that size; one
// twice as large is a curve that was built.
constexpr double kLeastSagitta = 4, kLeastRadius = 8;
// Round heads turn by half a circle at most (a little more for noise); what turns by more is a whole circle.
constexpr double kLeastTurn = 0.3, kMostTurn = 1.15 * std::numbers::pi,
                 kWholeTurn = 1.8 * std::numbers::pi;
constexpr double kLengthAgreement =
    1.5;  // a chain zigzags: it is longer than its arc by up to this factor
// A part that misses its points by so many sigma on average is not worth extending; looked at for some more candidates.
constexpr double kHopeless = 36;
constexpr int kPatience = 4;
// A part whose middle or ends are further than this from a guide does not lie on it; a step longer than this cuts a
// corner. In spacings.
constexpr double kNearGuide = 1, kEndOff = 2, kBridge = 1.5;
// Slanted edges are rare on facades (Boulaassal 2010, 4.3.1): a short one costs so many cuts more.
// In spacings; a tangent.
constexpr double kOdd = 2, kChainPartsShort = 12, kSlanted = 0.25;
constexpr double kChainPartsLeastSine = 0.3;  // of the angle of a corner that is cut
// Heads are round; sides are not, while a side seen in few rows has both its corners cut. An arc on an upright chord
// costs so many lines more, those at the corners: that it does without them speaks for no building.
constexpr double kLinesOfUpright = 2;

// From the chain's first point to each of its points, twice round.
std::vector<double> ways_along(std::span<const Vec2> chain) {
  const size_t n = chain.size();
  std::vector<double> out(2 * n + 1, 0);
  for (size_t i = 0; i < 2 * n; ++i) out[i + 1] = out[i] + norm(chain[(i + 1) % n] - chain[i % n]);
  return out;
}

struct Splitter {
  std::span<const Vec2> chain;
  const PartsSetting& setting;
  ChainMoments moments;
  std::vector<double> way_m;
  double variance, line_cost, arc_cost, cut_cost;

  Splitter(std::span<const Vec2> points, const PartsSetting& s)
      : chain(points),
        setting(s),
        moments(points, weights_by_steps(points, s.spacing_m)),
        way_m(ways_along(points)) {
    variance = kChainPartsNoise * kChainPartsNoise * s.spacing_m * s.spacing_m;
    // Schwarz: parameters x ln(n); a cut is one more.
    const double log_n =
        std::log(static_cast<double>(std::clamp<size_t>(points.size(), 8, kMostRing)));
    cut_cost = log_n;
    line_cost = 3 * log_n;
    arc_cost = 4 * log_n;
  }
  // A division costs more than what is done with the point.
  const Vec2& at(size_t i) const { return i < chain.size() ? chain[i] : chain[i % chain.size()]; }
};

constexpr size_t kSweptSteps = 8;

// Angle swept about the centre from the first over the middle to the last point; sign by sense.
template <class AngleOf>
double swept_by(const Splitter& s, const Circle& circle, size_t first, size_t last,
                AngleOf&& angle_of) {
  double angle = 0;
  Vec2 a = s.at(first) - circle.centre;
  for (size_t k = 1; k <= kSweptSteps; ++k) {
    const Vec2 b = s.at(first + (last - first) * k / kSweptSteps) - circle.centre;
    angle += angle_of(cross(a, b), dot(a, b));
    a = b;
  }
  return angle;
}
double swept(const Splitter& s, const Circle& circle, size_t first, size_t last) {
  return swept_by(s, circle, first, last, [](double y, double x) { return std::atan2(y, x); });
}

// Whether the chain is shorter than so much from the first to the last point: by the ways from the chain's start, whose
// roundings are far below the slack, and step by step where these do not tell.
bool is_shorter(const Splitter& s, size_t first, size_t last, double limit_m) {
  constexpr double kSlack = 1e-9;
  const double about = s.way_m[last] - s.way_m[first], slack = kSlack * s.way_m.back();
  if (std::fabs(about - limit_m) > slack) return about < limit_m;
  double length = 0;
  for (size_t i = first; i < last; ++i) length += norm(s.at(i + 1) - s.at(i));
  return length < limit_m;
}

// What is_arc() says, from a rough angle; nothing where that is too near a limit to tell. Nearly all tell.
std::optional<bool> is_arc_roughly(const Splitter& s, const Circle& circle, size_t first,
                                   size_t last) {
  constexpr double kError = kSweptSteps * kRoughAngleError_rad, kSlack = 1e-9;
  const double spacing = s.setting.spacing_m;
  const double angle = std::fabs(swept_by(s, circle, first, last, rough_angle));
  const double low = angle - kError, high = angle + kError;
  if (high < kLeastTurn || (low > kMostTurn && high < kWholeTurn)) return false;
  if (!(low > kLeastTurn && (high < kMostTurn || low > kWholeTurn))) return std::nullopt;
  const double sagitta = circle.radius * (1 - std::cos(angle / 2));
  const double beyond = sagitta - kLeastSagitta * spacing, error_m = circle.radius * kError;
  if (beyond < -error_m) return false;
  if (!(beyond > error_m)) return std::nullopt;
  const double limit = kLengthAgreement * circle.radius * angle + 4 * spacing;
  const double over = s.way_m[last] - s.way_m[first] - limit,
               slack = kLengthAgreement * error_m + kSlack * s.way_m.back();
  return std::fabs(over) > slack ? std::optional(over < 0) : std::nullopt;
}

bool is_arc(const Splitter& s, const Circle& circle, size_t first, size_t last) {
  const double spacing = s.setting.spacing_m;
  if (circle.radius < kLeastRadius * spacing) return false;
  if (const auto told = is_arc_roughly(s, circle, first, last)) return *told;
  const double angle = std::fabs(swept(s, circle, first, last));
  if (angle < kLeastTurn || (angle > kMostTurn && angle < kWholeTurn)) return false;
  if (circle.radius * (1 - std::cos(angle / 2)) < kLeastSagitta * spacing) return false;
  // Points spread along the arc, none of it empty: its length is theirs.
  return is_shorter(s, first, last, kLengthAgreement * circle.radius * angle + 4 * spacing);
}

double cost_of_upright(const Splitter& s, const Circle& circle, size_t first, size_t last) {
  const Vec2 chord = s.at(last) - s.at(first);
  if (std::fabs(swept(s, circle, first, last)) > kWholeTurn) return 0;  // a circle has no chord
  return kLinesOfUpright * s.line_cost * std::fabs(chord.v) / norm(chord);
}

struct PartCost {
  double cost = INFINITY;
  bool is_arc = false;
  bool is_hopeless = false;
  bool is_guided = false;
  EdgeLine guide;  ///< moved in to the contour points
};

// A long part has so many points that a few of another part at its end would cost it nothing.
bool misses_ends(const Splitter& s, const EdgeLine& line, size_t first, size_t last) {
  if (s.setting.guides == nullptr) return false;
  const double off =
      std::max(std::fabs(line.distance(s.at(first))), std::fabs(line.distance(s.at(last))));
  return off > kEndOff * s.setting.spacing_m;
}

// The guide that fits a straight part best, if any costs less than a line of its own.
void try_guides(const Splitter& s, const ChainMoments::Stretch& points, size_t first, size_t last,
                PartCost& out) {
  if (s.setting.guides == nullptr) return;
  const double n = static_cast<double>(last - first + 1);
  const Vec2 chord = s.at(last) - s.at(first), mean = points.mean();
  s.setting.guides->visit(
      mean, kNearGuide * s.setting.spacing_m + s.setting.set_back_m, [&](EdgeLine line) {
        if (!(dot(line.direction, chord) > 0)) return;
        line.point = line.point + Vec2{-line.direction.v, line.direction.u} * s.setting.set_back_m;
        if (misses_ends(s, line, first, last)) return;
        const double cost = std::max(n, points.squares_about(line) / s.variance) + s.cut_cost;
        if (cost < out.cost) out = {cost, false, false, true, line};
      });
}

// A single long step between two parts: the triangulation's way across a corner.
bool is_bridge(const Splitter& s, size_t first, size_t last) {
  if (s.setting.guides == nullptr || last - first != 1) return false;
  const double step = norm(s.at(last) - s.at(first));
  return step > kBridge * s.setting.spacing_m && step <= s.setting.bridge_m;
}

// A short part that is neither upright nor level where there are lines to follow.
bool is_odd(const Splitter& s, size_t first, size_t last) {
  if (s.setting.guides == nullptr) return false;
  const Vec2 chord = s.at(last) - s.at(first);
  const double most = std::max(std::fabs(chord.u), std::fabs(chord.v));
  return most < kChainPartsShort * s.setting.spacing_m &&
         std::min(std::fabs(chord.u), std::fabs(chord.v)) > kSlanted * most;
}

double point_count(size_t first, size_t last) { return static_cast<double>(last - first + 1); }

// Contour points stray together, as where a row of a grid ends beside an edge: nothing is gained by following them more
// closely than their standard deviation.
double cost_of_misfit(const Splitter& s, double squares, double n) {
  return std::max(n, squares / s.variance);
}

PartCost cost_of(const Splitter& s, const ChainMoments::Stretch& points, size_t first,
                 size_t last) {
  const double n = point_count(first, last);
  ChainMoments::LineFit fit;  // its angle is of use where there are guides alone
  if (s.setting.guides != nullptr) fit = points.line();
  else fit.squares = points.squares();
  const double line = cost_of_misfit(s, fit.squares, n);
  PartCost out{line + s.line_cost, false, line > kHopeless * n, false, {}};
  if (misses_ends(s, fit.line, first, last)) out.cost = INFINITY;
  if (is_odd(s, first, last)) out.cost += kOdd * s.cut_cost;
  if (is_bridge(s, first, last)) out.cost = n + s.cut_cost;
  try_guides(s, points, first, last, out);
  if (!s.setting.arcs || last - first + 1 < kLeastArcPoints) return out;
  const auto curve = points.arc();
  const double arc = cost_of_misfit(s, curve.squares, n);
  out.is_hopeless = out.is_hopeless && !(arc < kHopeless * n);
  if (!(arc + s.arc_cost < out.cost)) return out;
  const double whole = arc + s.arc_cost + cost_of_upright(s, curve.circle, first, last);
  if (whole < out.cost && is_arc(s, curve.circle, first, last))
    out = {whole, true, false, false, {}};
  return out;
}

PartCost cost_of(const Splitter& s, size_t first, size_t last) {
  return cost_of(s, s.moments.stretch(first, last), first, last);
}

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
std::vector<size_t> candidates(const Splitter& s) {
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
std::vector<size_t> cheapest_cuts(const Splitter& s, const std::vector<size_t>& ends) {
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
          cost_of_misfit(s, points.squares(), count) <= kHopeless * count) {
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
void settle(const Splitter& s, std::vector<size_t>& cuts) {
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
void join(const Splitter& s, std::vector<size_t>& cuts) {
  for (size_t k = 1; k + 1 < cuts.size() && cuts.size() > 3;) {
    const double two =
        cost_of(s, cuts[k - 1], cuts[k]).cost + cost_of(s, cuts[k], cuts[k + 1]).cost;
    if (cost_of(s, cuts[k - 1], cuts[k + 1]).cost < two)
      cuts.erase(cuts.begin() + static_cast<ptrdiff_t>(k));
    else ++k;
  }
}

// The cut where the chain turns most is a corner whatever the start was.
size_t sharpest(const Splitter& s, const std::vector<size_t>& cuts) {
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

ChainPart make_part(const Splitter& s, size_t first, size_t last) {
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
void drop_bridges(const Splitter& s, std::vector<ChainPart>& parts) {
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

std::vector<size_t> cut(const Splitter& s) {
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
    const Splitter first(chain, setting);
    return sharpest(first, cut(first));
  }();
  std::rotate(turned.begin(), turned.begin() + static_cast<ptrdiff_t>(start), turned.end());
  const Splitter s(turned, setting);
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
