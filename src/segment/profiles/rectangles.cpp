// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/profiles/rectangles.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.h"
#include "segment/surface/connectivity.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

constexpr double kSteepestOffset =
    1.19;                              // tangent of 50 degrees: flatter planes are for other axes
constexpr double kLeastOverlap = 0.5;  // of the shorter line
constexpr double kRectangleResidual = 0.5;  // rms of its points, in tolerances (as of seeds)
constexpr uint32_t kNoLine = 0xffffffffu;
constexpr uint32_t kLinesPerBlock = 16;  // of a few chains, and so near to one another
// Far above the rounding of a coordinate, far below any tolerance.
constexpr double kBlockSlack_m = 1e-6;

// What a line is asked again and again.
struct Run {
  Vec2 from, to, direction;
  double length_m;
};
Run run_of(const ProfileLine& line) {
  const Vec2 d = line.to - line.from;
  const double length = std::sqrt(d.u * d.u + d.v * d.v);
  return {line.from, line.to, d * (1 / length), length};
}

// Distance at which b runs beside a, at most `most`; infinite where it does not. What most lines fail is asked first.
double beside(const Run& a, const Run& b, double most, double sine) {
  const Vec2 &da = a.direction, &db = b.direction;
  const auto across = [&](const Vec2& p) {
    return (p.v - a.from.v) * da.u - (p.u - a.from.u) * da.v;
  };
  const double off = std::fabs(across(b.from) + across(b.to)) / 2;
  if (!(off <= most) || std::fabs(da.u * db.v - da.v * db.u) > sine) return INFINITY;
  const auto along = [&](const Vec2& p) {
    return (p.u - a.from.u) * da.u + (p.v - a.from.v) * da.v;
  };
  const double b0 = std::min(along(b.from), along(b.to)), b1 = std::max(along(b.from), along(b.to));
  const double from = std::max(0.0, b0), to = std::min(a.length_m, b1);
  return to - from < kLeastOverlap * std::min(a.length_m, b.length_m) ? INFINITY : off;
}

FlatBox box_of(const Run& run) {
  FlatBox box;
  box.add(run.from);
  box.add(run.to);
  return box;
}

// Lines that follow one another.
struct LineBlock {
  FlatBox box;
  double longest_m = 0;

  // May one of them run beside a line of that box, at most `most` off? Where its end is nearest, by sine of its length
  // more than its middle.
  bool may_run_beside(const FlatBox& line, double most, double sine) const {
    const double reach = most + longest_m / 2 * sine + kBlockSlack_m;
    return box.low.u <= line.high.u + reach && line.low.u <= box.high.u + reach &&
           box.low.v <= line.high.v + reach && line.low.v <= box.high.v + reach;
  }
};

struct LineRange {
  uint32_t begin, end;
};

class Neighbours {
 public:
  Neighbours(std::span<const ProfileLine> lines, const RectangleRule& rule)
      : most_(kSteepestOffset * rule.step_m),
        sine_(std::sin(rule.angle_rad)),
        blocks_(lines.size() / kLinesPerBlock + 1) {
    runs_.reserve(lines.size());
    for (const ProfileLine& line : lines) {
      LineBlock& block = blocks_[runs_.size() / kLinesPerBlock];
      runs_.push_back(run_of(line));
      block.box += box_of(runs_.back());
      block.longest_m = std::max(block.longest_m, runs_.back().length_m);
    }
  }

  uint32_t nearest_beside(uint32_t line, const LineRange& range) const {
    const FlatBox own = box_of(runs_[line]);
    uint32_t best = kNoLine;
    double least = most_;
    for (uint32_t begin = range.begin, end; begin < range.end; begin = end) {
      const uint32_t block = begin / kLinesPerBlock;
      end = std::min(range.end, (block + 1) * kLinesPerBlock);
      if (!blocks_[block].may_run_beside(own, least, sine_)) continue;
      for (uint32_t other = begin; other < end; ++other) {
        const double off = beside(runs_[line], runs_[other], least, sine_);
        if (off < least || (off == least && best == kNoLine)) {
          least = off;
          best = other;
        }
      }
    }
    return best;
  }

 private:
  double most_, sine_;
  std::vector<Run> runs_;
  std::vector<LineBlock> blocks_;
};

bool agree(const ProfileRectangle& a, const ProfileRectangle& b, const RectangleRule& rule) {
  return std::fabs(dot(a.fit.plane.normal, b.fit.plane.normal)) >= std::cos(rule.angle_rad) &&
         std::fabs(a.fit.plane.distance(b.fit.centroid)) <= rule.tolerance_m &&
         std::fabs(b.fit.plane.distance(a.fit.centroid)) <= rule.tolerance_m;
}

}  // namespace

std::vector<ProfileRectangle> match_lines(std::span<const ProfileLine> lines,
                                          const RectangleRule& rule, Task& task) {
  std::vector<uint32_t> first;  // of each slice that has lines
  for (uint32_t i = 0; i < lines.size(); ++i)
    if (i == 0 || lines[i].slice != lines[i - 1].slice) first.push_back(i);
  first.push_back(static_cast<uint32_t>(lines.size()));
  const Neighbours neighbours(lines, rule);
  std::vector<std::vector<ProfileRectangle>> found(first.size());
  parallel_for(task, first.size() < 3 ? 0 : first.size() - 2, 1, [&](size_t k, size_t) {
    const LineRange low{first[k], first[k + 1]}, high{first[k + 1], first[k + 2]};
    if (lines[high.begin].slice != lines[low.begin].slice + 1) return;
    std::set<std::pair<uint32_t, uint32_t>> pairs;
    for (uint32_t i = low.begin; i < low.end; ++i)
      if (const uint32_t j = neighbours.nearest_beside(i, high); j != kNoLine) pairs.insert({i, j});
    for (uint32_t j = high.begin; j < high.end; ++j)
      if (const uint32_t i = neighbours.nearest_beside(j, low); i != kNoLine) pairs.insert({i, j});
    for (const auto& [i, j] : pairs) {
      ProfileRectangle rectangle{i, j, {}};
      Moments both = lines[i].moments;
      both += lines[j].moments;
      if (fit_plane(both, rectangle.fit) &&
          rectangle.fit.sigma <= kRectangleResidual * rule.tolerance_m)
        found[k].push_back(rectangle);
    }
  });
  std::vector<ProfileRectangle> rectangles;
  for (const auto& part : found) rectangles.insert(rectangles.end(), part.begin(), part.end());
  return rectangles;
}

std::vector<std::vector<uint32_t>> join_rectangles(std::span<const ProfileLine> lines,
                                                   std::span<const ProfileRectangle> rectangles,
                                                   const RectangleRule& rule) {
  std::vector<std::vector<uint32_t>> at_line(lines.size());
  for (uint32_t r = 0; r < rectangles.size(); ++r) {
    at_line[rectangles[r].low].push_back(r);
    at_line[rectangles[r].high].push_back(r);
  }
  UnionFind sets(rectangles.size());
  for (const auto& around : at_line)
    for (size_t i = 0; i < around.size(); ++i)
      for (size_t j = i + 1; j < around.size(); ++j)
        if (agree(rectangles[around[i]], rectangles[around[j]], rule))
          sets.join(around[i], around[j]);
  std::vector<std::vector<uint32_t>> lines_of(rectangles.size());
  for (uint32_t r = 0; r < rectangles.size(); ++r) {
    const uint32_t root = sets.find(r);
    lines_of[root].push_back(rectangles[r].low);
    lines_of[root].push_back(rectangles[r].high);
  }
  std::vector<std::vector<uint32_t>> planes;
  for (uint32_t r = 0; r < rectangles.size(); ++r) {
    if (lines_of[r].empty()) continue;
    std::sort(lines_of[r].begin(), lines_of[r].end());
    if (lines[lines_of[r].back()].slice < lines[lines_of[r].front()].slice + 2) continue;
    lines_of[r].erase(std::unique(lines_of[r].begin(), lines_of[r].end()), lines_of[r].end());
    planes.push_back(std::move(lines_of[r]));
  }
  return planes;
}

}  // namespace jalon
