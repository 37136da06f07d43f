// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/part_costs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "modelling/edges/find/rough_angle.h"

namespace jalon {

namespace {

// Standard deviation of contour points about their line, in spacings: 0.29 on a grid, up to 0.5 measured on scattered
// points, which are not independent of their neighbours either.
constexpr double kChainPartsNoise = 0.5;
// A part costs as much as on a ring of so many points at most: what a window's corner is worth on a window.
constexpr size_t kMostRing = 100;
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
// A part whose middle or ends are further than this from a guide does not lie on it; a step longer than this cuts a
// corner. In spacings.
constexpr double kNearGuide = 1, kEndOff = 2, kBridge = 1.5;
// Slanted edges are rare on facades (Boulaassal 2010, 4.3.1): a short one costs so many cuts more.
// In spacings; a tangent.
constexpr double kOdd = 2, kChainPartsShort = 12, kSlanted = 0.25;
// Heads are round; sides are not, while a side seen in few rows has both its corners cut. An arc on an upright chord
// costs so many lines more, those at the corners: that it does without them speaks for no building. By the square of
// the chord's sine, which leaves the ends of nearly level ones where their points say.
constexpr double kLinesOfUpright = 2;

// From the chain's first point to each of its points, twice round.
std::vector<double> ways_along(std::span<const Vec2> chain) {
  const size_t n = chain.size();
  std::vector<double> out(2 * n + 1, 0);
  for (size_t i = 0; i < 2 * n; ++i) out[i + 1] = out[i] + norm(chain[(i + 1) % n] - chain[i % n]);
  return out;
}

constexpr size_t kSweptSteps = 8;

// Angle swept about the centre from the first over the middle to the last point; sign by sense.
template <class AngleOf>
double swept_by(const PartCosts& s, const Circle& circle, size_t first, size_t last,
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
// Whether the chain is shorter than so much from the first to the last point: by the ways from the chain's start, whose
// roundings are far below the slack, and step by step where these do not tell.
bool is_shorter(const PartCosts& s, size_t first, size_t last, double limit_m) {
  constexpr double kSlack = 1e-9;
  const double about = s.way_m[last] - s.way_m[first], slack = kSlack * s.way_m.back();
  if (std::fabs(about - limit_m) > slack) return about < limit_m;
  double length = 0;
  for (size_t i = first; i < last; ++i) length += norm(s.at(i + 1) - s.at(i));
  return length < limit_m;
}

// What is_arc() says, from a rough angle; nothing where that is too near a limit to tell. Nearly all tell.
std::optional<bool> is_arc_roughly(const PartCosts& s, const Circle& circle, size_t first,
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

bool is_arc(const PartCosts& s, const Circle& circle, size_t first, size_t last) {
  const double spacing = s.setting.spacing_m;
  if (circle.radius < kLeastRadius * spacing) return false;
  if (const auto told = is_arc_roughly(s, circle, first, last)) return *told;
  const double angle = std::fabs(swept(s, circle, first, last));
  if (angle < kLeastTurn || (angle > kMostTurn && angle < kWholeTurn)) return false;
  if (circle.radius * (1 - std::cos(angle / 2)) < kLeastSagitta * spacing) return false;
  // Points spread along the arc, none of it empty: its length is theirs.
  return is_shorter(s, first, last, kLengthAgreement * circle.radius * angle + 4 * spacing);
}

double cost_of_upright(const PartCosts& s, const Circle& circle, size_t first, size_t last) {
  const Vec2 chord = s.at(last) - s.at(first);
  if (std::fabs(swept(s, circle, first, last)) > kWholeTurn) return 0;  // a circle has no chord
  return kLinesOfUpright * s.line_cost * chord.v * chord.v / dot(chord, chord);
}

// A long part has so many points that a few of another part at its end would cost it nothing.
bool misses_ends(const PartCosts& s, const EdgeLine& line, size_t first, size_t last) {
  if (s.setting.guides == nullptr) return false;
  const double off =
      std::max(std::fabs(line.distance(s.at(first))), std::fabs(line.distance(s.at(last))));
  return off > kEndOff * s.setting.spacing_m;
}

// The guide that fits a straight part best, if any costs less than a line of its own.
void try_guides(const PartCosts& s, const ChainMoments::Stretch& points, size_t first, size_t last,
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

// A short part that is neither upright nor level where there are lines to follow.
bool is_odd(const PartCosts& s, size_t first, size_t last) {
  if (s.setting.guides == nullptr) return false;
  const Vec2 chord = s.at(last) - s.at(first);
  const double most = std::max(std::fabs(chord.u), std::fabs(chord.v));
  return most < kChainPartsShort * s.setting.spacing_m &&
         std::min(std::fabs(chord.u), std::fabs(chord.v)) > kSlanted * most;
}

}  // namespace

PartCosts::PartCosts(std::span<const Vec2> points, const PartsSetting& s)
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

double swept(const PartCosts& s, const Circle& circle, size_t first, size_t last) {
  return swept_by(s, circle, first, last, [](double y, double x) { return std::atan2(y, x); });
}

bool is_bridge(const PartCosts& s, size_t first, size_t last) {
  if (s.setting.guides == nullptr || last - first != 1) return false;
  const double step = norm(s.at(last) - s.at(first));
  return step > kBridge * s.setting.spacing_m && step <= s.setting.bridge_m;
}

double point_count(size_t first, size_t last) { return static_cast<double>(last - first + 1); }

double cost_of_misfit(const PartCosts& s, double squares, double n) {
  return std::max(n, squares / s.variance);
}

bool is_hopeless(double misfit, double n) { return misfit > kHopeless * n; }

PartCost cost_of(const PartCosts& s, const ChainMoments::Stretch& points, size_t first,
                 size_t last) {
  const double n = point_count(first, last);
  ChainMoments::LineFit fit;  // its angle is of use where there are guides alone
  if (s.setting.guides != nullptr) fit = points.line();
  else fit.squares = points.squares();
  const double line = cost_of_misfit(s, fit.squares, n);
  PartCost out{line + s.line_cost, false, is_hopeless(line, n), false, {}};
  if (misses_ends(s, fit.line, first, last)) out.cost = INFINITY;
  if (is_odd(s, first, last)) out.cost += kOdd * s.cut_cost;
  if (is_bridge(s, first, last)) out.cost = n + s.cut_cost;
  try_guides(s, points, first, last, out);
  if (!s.setting.arcs || last - first + 1 < kLeastArcPoints) return out;
  const auto curve = points.arc();
  const double arc = cost_of_misfit(s, curve.squares, n);
  out.is_hopeless = out.is_hopeless && is_hopeless(arc, n);
  if (!(arc + s.arc_cost < out.cost)) return out;
  const double whole = arc + s.arc_cost + cost_of_upright(s, curve.circle, first, last);
  if (whole < out.cost && is_arc(s, curve.circle, first, last))
    out = {whole, true, false, false, {}};
  return out;
}

PartCost cost_of(const PartCosts& s, size_t first, size_t last) {
  return cost_of(s, s.moments.stretch(first, last), first, last);
}

}  // namespace jalon
