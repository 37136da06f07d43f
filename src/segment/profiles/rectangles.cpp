// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/profiles/rectangles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

#include "base/parallel.h"
#include "segment/surface/connectivity.h"

namespace jalon {

namespace {

constexpr double kSteepestOffset =
    1.19;                              // tangent of 50 degrees: flatter planes are for other axes
constexpr double kLeastOverlap = 0.5;  // of the shorter line
constexpr double kRectangleResidual = 0.5;  // rms of its points, in tolerances (as of seeds)
constexpr double kRectangleRefit = 1.1;     // growth after which the plane is solved anew
constexpr size_t kRectanglesPerCheckpoint = 1 << 12;  // some 100 ns each
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

// Rectangles of one plane after the other.
class RectangleGrowth {
 public:
  RectangleGrowth(std::span<const ProfileLine> lines, std::span<const ProfileRectangle> rectangles,
                  const RectangleRule& rule, Task& task)
      : lines_(lines),
        rectangles_(rectangles),
        rule_(rule),
        task_(task),
        cosine_(std::cos(rule.angle_rad)),
        at_line_(lines.size()),
        taken_(rectangles.size(), 0),
        last_set_(lines.size(), 0) {
    for (uint32_t r = 0; r < rectangles.size(); ++r) {
      at_line_[rectangles[r].low].push_back(r);
      at_line_[rectangles[r].high].push_back(r);
    }
  }

  // The set that grows from the rectangle; empty where another has it.
  ProfileSet from(uint32_t seed) {
    ProfileSet set;
    if (taken_[seed] != 0) return set;
    ++sets_;
    plane_ = rectangles_[seed].fit.plane;
    fitted_ = 0;
    members_.clear();
    take(seed, set);
    for (size_t at = 0; at < members_.size(); ++at)
      for (const uint32_t line : {rectangles_[members_[at]].low, rectangles_[members_[at]].high})
        for (const uint32_t r : at_line_[line])
          if (taken_[r] == 0 && fits(rectangles_[r])) take(r, set);
    std::ranges::sort(set.lines);
    return set;
  }

 private:
  void take(uint32_t r, ProfileSet& set) {
    taken_[r] = 1;
    if (++taken_count_ % kRectanglesPerCheckpoint == 0)
      task_.checkpoint(static_cast<double>(taken_count_) / static_cast<double>(taken_.size()));
    members_.push_back(r);
    for (const uint32_t line : {rectangles_[r].low, rectangles_[r].high}) {
      if (std::exchange(last_set_[line], sets_) == sets_) continue;
      set.lines.push_back(line);
      const Moments& own = lines_[line].moments;
      if (rms_about(own, plane_) > kRectangleResidual * rule_.tolerance_m) continue;
      if (set.moments.n == 0) set.moments = own;
      else set.moments += own;
    }
    if (static_cast<double>(set.moments.n) < kRectangleRefit * static_cast<double>(fitted_)) return;
    fitted_ = set.moments.n;
    PlaneFit fit;
    if (fit_plane(set.moments, fit)) plane_ = fit.plane;
  }

  bool fits(const ProfileRectangle& r) const {
    return std::fabs(dot(r.fit.plane.normal, plane_.normal)) >= cosine_ &&
           rms_about(lines_[r.low].moments, plane_) <= rule_.tolerance_m &&
           rms_about(lines_[r.high].moments, plane_) <= rule_.tolerance_m;
  }

  std::span<const ProfileLine> lines_;
  std::span<const ProfileRectangle> rectangles_;
  const RectangleRule& rule_;
  Task& task_;
  double cosine_;
  std::vector<std::vector<uint32_t>> at_line_;
  std::vector<uint8_t> taken_;
  size_t taken_count_ = 0;
  std::vector<uint32_t> last_set_;  ///< that the line came to; rectangles of two may share it
  uint32_t sets_ = 0;
  std::vector<uint32_t> members_;  ///< rectangles of the set that grows
  Plane plane_;
  uint64_t fitted_ = 0;  ///< points of that plane
};

// The largest first: their planes are the surest.
std::vector<uint32_t> by_points(std::span<const ProfileRectangle> rectangles) {
  std::vector<uint32_t> order(rectangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, std::greater{}, [&](uint32_t r) { return rectangles[r].fit.n; });
  return order;
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

std::vector<ProfileSet> join_rectangles(std::span<const ProfileLine> lines,
                                        std::span<const ProfileRectangle> rectangles,
                                        const RectangleRule& rule, Task& task) {
  RectangleGrowth growth(lines, rectangles, rule, task);
  std::vector<ProfileSet> sets;
  for (const uint32_t seed : by_points(rectangles)) {
    ProfileSet set = growth.from(seed);
    if (!set.lines.empty() && lines[set.lines.back()].slice >= lines[set.lines.front()].slice + 2)
      sets.push_back(std::move(set));
  }
  std::ranges::stable_sort(sets, {}, [](const ProfileSet& set) { return set.lines.front(); });
  return sets;
}

}  // namespace jalon
