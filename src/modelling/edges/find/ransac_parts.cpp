// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/ransac_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/edges/find/chain_moments.h"

namespace jalon {

namespace {

constexpr uint64_t kStream = 0x6c696e65;                    // of the draws
constexpr double kDefaultTolerance = 0.5, kDefaultGap = 5;  // spacings
constexpr uint64_t kMostDraws = 5000;  // for one line: enough for a share of 3 % of the points
constexpr double kOther = 1e-3;        // weight of points within a stretch that are not on its line
constexpr size_t kLeastCurve = 5;      // points
constexpr size_t kLeastChords = 3;     // stretches that may be one arc
constexpr double kLeastCurveTurn_rad = 0.3, kMostCurveTurn_rad = 1.8 * std::numbers::pi;

// A straight part: points first ... last of the chain, some of them members of its line.
struct LineRun {
  size_t first = 0, last = 0;
};

struct DrawnLines {
  std::span<const Vec2> chain;
  RansacPartsSetting setting;
  std::vector<uint32_t> line_of;  ///< of each point, from 1; 0: of none

  bool is_on(const EdgeLine& line, size_t i) const {
    return std::fabs(line.distance(chain[i])) <= setting.tolerance_m;
  }
};

EdgeLine line_through(const Vec2& a, const Vec2& b) { return {a, (b - a) * (1 / norm(b - a))}; }

// Total least squares.
EdgeLine fitted_line(std::span<const Vec2> chain, const std::vector<size_t>& members) {
  std::vector<Vec2> points;
  for (const size_t i : members) points.push_back(chain[i]);
  const std::vector<double> weights(points.size(), 1);
  return ChainMoments(points, weights).stretch(0, points.size() - 1).line().line;
}

std::vector<size_t> members_of(const DrawnLines& lines, const EdgeLine& line,
                               const std::vector<size_t>& free) {
  std::vector<size_t> out;
  for (const size_t i : free)
    if (lines.is_on(line, i)) out.push_back(i);
  return out;
}

// Draws that miss a line of this share of the points with no more than the probability left (Fischler & Bolles 1981).
uint64_t draws_for(double share, double probability) {
  const double missed = std::log(1 - share * share);
  if (!(missed < 0)) return 1;
  return static_cast<uint64_t>(
      std::min(static_cast<double>(kMostDraws), std::ceil(std::log(1 - probability) / missed)));
}

// The members of the line that holds most of the free points, refitted and gathered once more.
std::vector<size_t> best_line(const DrawnLines& lines, const std::vector<size_t>& free,
                              RandomStream& random) {
  size_t most = 0;
  EdgeLine best;
  uint64_t draws = kMostDraws;
  for (uint64_t k = 0; k < draws; ++k) {
    const Vec2 &a = lines.chain[free[random.below(free.size())]],
               &b = lines.chain[free[random.below(free.size())]];
    if (!(norm(b - a) > lines.setting.tolerance_m)) continue;
    const EdgeLine line = line_through(a, b);
    const auto count = static_cast<size_t>(
        std::count_if(free.begin(), free.end(), [&](size_t i) { return lines.is_on(line, i); }));
    if (count <= most) continue;
    most = count, best = line;
    draws = draws_for(static_cast<double>(most) / static_cast<double>(free.size()),
                      lines.setting.probability);
  }
  if (most < 2) return {};
  return members_of(lines, fitted_line(lines.chain, members_of(lines, best, free)), free);
}

// Step 1: lines, one after the other (Boulaassal 2010, 4.3.1).
uint32_t draw_lines(DrawnLines& lines) {
  RandomStream random(lines.setting.seed, kStream);
  std::vector<size_t> free(lines.chain.size());
  for (size_t i = 0; i < free.size(); ++i) free[i] = i;
  uint32_t count = 0;
  while (free.size() >= lines.setting.min_points) {
    const auto members = best_line(lines, free, random);
    if (members.size() < lines.setting.min_points) break;
    ++count;
    for (const size_t i : members) lines.line_of[i] = count;
    std::erase_if(free, [&](size_t i) { return lines.line_of[i] != 0; });
  }
  return count;
}

// Step 2: each line cut at its gaps (4.3.3), the lines of most points first. A stretch once taken is not run through.
std::vector<LineRun> cut_at_gaps(DrawnLines& lines, uint32_t count) {
  std::vector<uint8_t> is_taken(lines.chain.size(), 0);
  std::vector<LineRun> out;
  for (uint32_t line = 1; line <= count; ++line) {
    LineRun run;
    size_t members = 0;
    const auto close = [&] {
      if (members >= lines.setting.min_points) {
        out.push_back(run);
        std::fill(is_taken.begin() + static_cast<ptrdiff_t>(run.first),
                  is_taken.begin() + static_cast<ptrdiff_t>(run.last) + 1, uint8_t{1});
      }
      members = 0;
    };
    for (size_t i = 0; i < lines.chain.size(); ++i) {
      if (is_taken[i] != 0) close();
      if (is_taken[i] != 0 || lines.line_of[i] != line) continue;
      if (members > 0 && norm(lines.chain[i] - lines.chain[run.last]) > lines.setting.gap_m)
        close();
      if (members++ == 0) run.first = i;
      run.last = i;
    }
    close();
  }
  std::sort(out.begin(), out.end(),
            [](const LineRun& a, const LineRun& b) { return a.first < b.first; });
  return out;
}

// Angle from the first to the last point about the centre, walked by the points between.
double swept_by(std::span<const Vec2> chain, const Circle& circle, size_t first, size_t last) {
  double angle = 0;
  for (size_t i = first; i < last; ++i) {
    const Vec2 a = chain[i % chain.size()] - circle.centre,
               b = chain[(i + 1) % chain.size()] - circle.centre;
    angle += std::atan2(cross(a, b), dot(a, b));
  }
  return angle;
}

// Of the points of a stretch about its circle.
double rms_of(const ChainMoments& moments, const LineRun& stretch) {
  const double n = static_cast<double>(stretch.last - stretch.first + 1);
  return std::sqrt(moments.stretch(stretch.first, stretch.last).arc().squares / n);
}

// Whether a circle explains a stretch, and that.
bool is_curve(const ChainMoments& moments, std::span<const Vec2> chain, const LineRun& stretch,
              double tolerance_m, ChainPart& out) {
  const auto [first, last] = stretch;
  if (last - first + 1 < kLeastCurve) return false;
  if (!(rms_of(moments, stretch) <= tolerance_m)) return false;
  const Circle circle = moments.stretch(first, last).arc().circle;
  const double turn = swept_by(chain, circle, first, last);
  if (std::fabs(turn) < kLeastCurveTurn_rad || std::fabs(turn) > kMostCurveTurn_rad) return false;
  out = {first, last - first + 1, true, false, {}, circle, turn > 0 ? 1.0 : -1.0};
  return true;
}

// Lines cut chords out of a flat arc: three stretches or more that one circle explains are none.
void drop_chords(std::span<const Vec2> chain, const ChainMoments& moments, double tolerance_m,
                 std::vector<LineRun>& runs) {
  if (runs.size() >= kLeastChords && rms_of(moments, {0, chain.size() - 1}) <= tolerance_m) {
    runs.clear();  // a whole circle
    return;
  }
  for (size_t k = 0; k + kLeastChords <= runs.size(); ++k)
    for (size_t end = runs.size(); end >= k + kLeastChords; --end) {
      ChainPart curve;
      if (!is_curve(moments, chain, {runs[k].first, runs[end - 1].last}, tolerance_m, curve))
        continue;
      runs.erase(runs.begin() + static_cast<ptrdiff_t>(k),
                 runs.begin() + static_cast<ptrdiff_t>(end));
      break;
    }
}

ChainPart straight_part(const ChainMoments& moments, std::span<const Vec2> chain, size_t first,
                        size_t last, const LineRun& members) {
  ChainPart part{first, last - first + 1, false, false, {}, {}, 0};
  part.line = moments.stretch(members.first, members.last).line().line;
  const Vec2 along = chain[members.last % chain.size()] - chain[members.first % chain.size()];
  if (dot(part.line.direction, along) < 0) part.line.direction = part.line.direction * -1;
  return part;
}

// Without any line: a circle is two arcs, all else the sides of a polygon.
std::vector<ChainPart> parts_without_lines(std::span<const Vec2> chain, const ChainMoments& moments,
                                           const RansacPartsSetting& setting) {
  const size_t n = chain.size(), half = n / 2;
  std::vector<ChainPart> out(2);
  if (setting.arcs && is_curve(moments, chain, {0, half}, setting.tolerance_m, out[0]) &&
      is_curve(moments, chain, {half, n}, setting.tolerance_m, out[1]))
    return out;
  out.clear();
  std::vector<uint32_t> corners = simplified(chain, setting.tolerance_m, true);
  corners.push_back(static_cast<uint32_t>(n));
  for (size_t k = 0; k + 1 < corners.size(); ++k)
    out.push_back(
        straight_part(moments, chain, corners[k], corners[k + 1], {corners[k], corners[k + 1]}));
  return out;
}

// Step 3: what no line took is a curve where a circle explains it (4.3.1).
std::vector<ChainPart> parts_of_runs(const DrawnLines& lines, std::vector<LineRun> runs) {
  const size_t n = lines.chain.size();
  const std::vector<double> ones(n, 1);
  const ChainMoments all(lines.chain, ones);
  if (lines.setting.arcs) drop_chords(lines.chain, all, lines.setting.tolerance_m, runs);
  if (runs.empty()) return parts_without_lines(lines.chain, all, lines.setting);
  std::vector<double> weights(n, kOther);
  for (const LineRun& run : runs)
    for (size_t i = run.first; i <= run.last; ++i)
      if (lines.line_of[i] == lines.line_of[run.first]) weights[i] = 1;
  const ChainMoments straight(lines.chain, weights);
  std::vector<ChainPart> out;
  for (size_t k = 0; k < runs.size(); ++k) {
    const LineRun& run = runs[k];
    const size_t next = k + 1 < runs.size() ? runs[k + 1].first : n + runs[0].first;
    ChainPart between;
    bool has_between = lines.setting.arcs && is_curve(all, lines.chain, {run.last, next},
                                                      lines.setting.tolerance_m, between);
    if (!has_between && next - run.last + 1 >= kLeastCurve) {
      between = straight_part(all, lines.chain, run.last, next, {run.last, next});
      has_between = true;
    }
    out.push_back(
        straight_part(straight, lines.chain, run.first, has_between ? run.last : next, run));
    if (has_between) out.push_back(between);
  }
  return out;
}

}  // namespace

std::vector<ChainPart> ransac_parts(std::span<const Vec2> chain,
                                    const RansacPartsSetting& setting) {
  RansacPartsSetting chosen = setting;
  if (chosen.tolerance_m == 0) chosen.tolerance_m = kDefaultTolerance * setting.spacing_m;
  if (chosen.gap_m == 0) chosen.gap_m = kDefaultGap * setting.spacing_m;
  // 1. Lines.
  DrawnLines lines{chain, chosen, std::vector<uint32_t>(chain.size(), 0)};
  const uint32_t count = draw_lines(lines);
  // The walk starts where a stretch of the first line does, so that no stretch runs over its end.
  size_t start = 0;
  while (start < chain.size() && !(lines.line_of[start] == 1 &&
                                   lines.line_of[(start + chain.size() - 1) % chain.size()] != 1))
    ++start;
  start %= chain.size();
  std::vector<Vec2> turned(chain.begin(), chain.end());
  std::rotate(turned.begin(), turned.begin() + static_cast<ptrdiff_t>(start), turned.end());
  std::rotate(lines.line_of.begin(), lines.line_of.begin() + static_cast<ptrdiff_t>(start),
              lines.line_of.end());
  lines.chain = turned;
  // 2. Their stretches.  3. What lies between.
  std::vector<ChainPart> parts = parts_of_runs(lines, cut_at_gaps(lines, count));
  for (ChainPart& part : parts) part.first = (part.first + start) % chain.size();
  return parts;
}

}  // namespace jalon
