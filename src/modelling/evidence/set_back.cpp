// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/set_back.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "modelling/evidence/cell_classes.h"
#include "modelling/evidence/cell_regions.h"

namespace jalon {

namespace {

constexpr double kHeightStep_m = 1e-9;     // of sums: below any noise, and 2^63 of them are enough
constexpr double kLeastStep_m = 0.01;      // roller blinds hang twice as far behind the wall
constexpr double kLeastStepSide_m = 0.25;  // half of a small window
constexpr uint32_t kLeastStepCells = 4;    // across: fewer say little of a rectangle
constexpr double kStepLineShare = 0.5;     // of the cells of a row or column at a patch's end
constexpr double kStepFill = 0.8;          // of the measured cells of a rectangle: behind the wall
constexpr uint32_t kAboutCells = 4;        // looked at about a rectangle
constexpr double kAboutShare = 0.3;        // of these, measured: three sides of a blind partly down
// Of the squares that a slanted wall leaves, those that the step leaves. Measured on the grammar: blinds 0.06 to 0.24,
// of some that lie in pieces 0.34 and 0.44; panes, plaster that bends and wrong points 0.47 to 1, one 0.38.
constexpr double kUnexplained = 0.4;
constexpr uint32_t kAlignedCells = 2;  // sides of like openings differ by
// Of a row below a blind: open. Of such rows: between jambs that go on.
constexpr double kContinuedShare = 0.6;
constexpr uint32_t kContinuedRows = 2;  // below a blind

// Two levels, and what they leave unexplained.
struct Levels {
  std::array<double, 2> count{}, sum{}, squares{};

  void add(bool is_second, double w) {
    ++count[is_second];
    sum[is_second] += w;
    squares[is_second] += w * w;
  }
  double step() const { return sum[0] / count[0] - sum[1] / count[1]; }
  double rest() const {
    return squares[0] - sum[0] * sum[0] / count[0] + squares[1] - sum[1] * sum[1] / count[1];
  }
};

// Squares that the best plane through these places leaves.
double slanted_rest(std::span<const Vec3> places) {
  Vec3 mean{};
  for (const Vec3& p : places) mean = mean + p * (1 / static_cast<double>(places.size()));
  double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0, ww = 0;
  for (const Vec3& p : places) {
    const Vec3 d = p - mean;
    uu += d.x * d.x, uv += d.x * d.y, vv += d.y * d.y;
    uw += d.x * d.z, vw += d.y * d.z, ww += d.z * d.z;
  }
  const double det = uu * vv - uv * uv;
  if (!(det > 0)) return ww;
  return ww - (uw * vv - vw * uv) / det * uw - (vw * uu - uw * uv) / det * vw;
}

bool is_near(uint32_t a, uint32_t b) { return (a > b ? a - b : b - a) <= kAlignedCells; }
bool is_in_column(const CellBox& a, const CellBox& b) {
  return is_near(a.c0, b.c0) && is_near(a.c1, b.c1);
}
bool is_alike(const CellBox& a, const CellBox& b) {
  const bool is_in_row = is_near(a.r0, b.r0) && is_near(a.r1, b.r1);
  return is_in_column(a, b) || (is_in_row && is_near(a.width(), b.width()));
}

// Rectangles of a wall's cells that stand back, as step 1 to 3 of the header tell.
class SetBack {
 public:
  SetBack(std::span<const float> means, const WallCells& cells, std::span<uint8_t> marks)
      : means_(means), cells_(cells), marks_(marks) {}

  std::vector<CellBox> run(Task& task) {
    const std::vector<CellBox> found = rectangles(task);
    std::vector<CellBox> out;
    if (found.empty()) return out;
    std::vector<CellBox> open = holes();
    std::vector<CellBox> closed;
    for (const CellBox& box : found)
      if (const auto whole = continued(box)) out.push_back(box), open.push_back(*whole);
      else closed.push_back(box);
    for (const CellBox& box : closed)
      if (std::any_of(open.begin(), open.end(), [&](const CellBox& o) { return is_alike(box, o); }))
        out.push_back(box);
    for (const CellBox& box : out) fill(box);
    return out;
  }

 private:
  size_t at(uint32_t c, uint32_t r) const { return static_cast<size_t>(r) * cells_.columns + c; }
  bool is_on(size_t k) const { return (marks_[k] & kMarkOn) != 0 && !std::isnan(means_[k]); }
  bool is_behind(size_t k) const { return is_on(k) && means_[k] < -kLeastStep_m; }

  std::vector<CellBox> rectangles(Task& task) const {
    std::vector<CellBox> out;
    CellRegions regions(cells_.columns, cells_.rows);
    for (std::vector<uint32_t>& region : regions.of(behind_or_beside())) {
      std::erase_if(region, [&](uint32_t k) { return !is_behind(k); });
      if (region.size() < kLeastStepCells * kLeastStepCells) continue;
      task.checkpoint(0);
      const CellBox box = step_box_of(region);
      const auto least = std::max(
          kLeastStepCells, static_cast<uint32_t>(std::ceil(kLeastStepSide_m / cells_.cell_m)));
      if (box.c0 >= box.c1 || box.r0 >= box.r1 || std::min(box.width(), box.height()) < least)
        continue;
      if (is_step(box)) out.push_back(box);
    }
    return out;
  }

  // Step 1: cells behind the wall, and those beside them without a point of it: blinds may have few.
  std::vector<uint32_t> behind_or_beside() const {
    std::vector<uint32_t> out;
    for (uint32_t r = 0; r < cells_.rows; ++r)
      for (uint32_t c = 0; c < cells_.columns; ++c) {
        const size_t k = at(c, r);
        const auto behind = [&](bool is_there, size_t other) {
          return is_there && is_behind(other);
        };
        if (is_behind(k) ||
            (!is_on(k) && (behind(c > 0, k - 1) || behind(c + 1 < cells_.columns, k + 1) ||
                           behind(r > 0, k - cells_.columns) ||
                           behind(r + 1 < cells_.rows, k + cells_.columns))))
          out.push_back(static_cast<uint32_t>(k));
      }
    return out;
  }

  // What a region reaches over, less the rows and columns at its ends that are mostly on the wall.
  CellBox step_box_of(const std::vector<uint32_t>& region) const {
    CellBox box = cell_box_of(region, cells_.columns);
    const auto is_wall_line = [&](const CellBox& line) {
      size_t on = 0, behind = 0;
      for (uint32_t r = line.r0; r < line.r1; ++r)
        for (uint32_t c = line.c0; c < line.c1; ++c) {
          on += is_on(at(c, r));
          behind += is_behind(at(c, r));
        }
      return static_cast<double>(behind) < kStepLineShare * static_cast<double>(on) || on == 0;
    };
    for (bool is_changed = true; is_changed && box.c0 < box.c1 && box.r0 < box.r1;) {
      if (is_wall_line({box.c0, box.r0, box.c0 + 1, box.r1})) ++box.c0;
      else if (is_wall_line({box.c1 - 1, box.r0, box.c1, box.r1})) --box.c1;
      else if (is_wall_line({box.c0, box.r0, box.c1, box.r0 + 1})) ++box.r0;
      else if (is_wall_line({box.c0, box.r1 - 1, box.c1, box.r1})) --box.r1;
      else is_changed = false;
    }
    return box;
  }

  // Of the rows and columns of which a region has half as many cells as of its broadest.
  CellBox box_of(const std::vector<uint32_t>& region) const {
    std::vector<uint32_t> rows(cells_.rows, 0), columns(cells_.columns, 0);
    for (const uint32_t k : region) ++rows[k / cells_.columns], ++columns[k % cells_.columns];
    const auto ends = [](const std::vector<uint32_t>& lines) {
      const double least =
          kStepLineShare * static_cast<double>(*std::max_element(lines.begin(), lines.end()));
      const auto holds = [&](uint32_t n) { return n >= least; };
      const auto first = std::find_if(lines.begin(), lines.end(), holds);
      const auto last = std::find_if(lines.rbegin(), lines.rend(), holds);
      return std::pair{static_cast<uint32_t>(first - lines.begin()),
                       static_cast<uint32_t>(lines.rend() - last)};
    };
    const auto [c0, c1] = ends(columns);
    const auto [r0, r1] = ends(rows);
    return {c0, r0, c1, r1};
  }

  // Step 2.
  bool is_step(const CellBox& box) const {
    const uint32_t c0 = box.c0 - std::min(box.c0, kAboutCells),
                   r0 = box.r0 - std::min(box.r0, kAboutCells),
                   c1 = std::min(cells_.columns, box.c1 + kAboutCells),
                   r1 = std::min(cells_.rows, box.r1 + kAboutCells);
    std::vector<Vec3> places;
    Levels levels;
    double behind = 0;
    for (uint32_t r = r0; r < r1; ++r)
      for (uint32_t c = c0; c < c1; ++c) {
        const size_t k = at(c, r);
        if (!is_on(k)) continue;
        const bool is_inside = c >= box.c0 && c < box.c1 && r >= box.r0 && r < box.r1;
        levels.add(is_inside, means_[k]);
        behind += is_inside && is_behind(k);
        places.push_back({static_cast<double>(c), static_cast<double>(r), means_[k]});
      }
    const uint32_t about = (c1 - c0) * (r1 - r0) - box.width() * box.height();
    if (!(levels.count[0] > 0) || levels.count[0] < kAboutShare * about) return false;
    return behind >= kStepFill * levels.count[1] && levels.step() >= kLeastStep_m &&
           levels.rest() <= kUnexplained * slanted_rest(places);
  }

  // Step 3: of a blind that is partly down, with the opening below it.
  std::optional<CellBox> continued(const CellBox& box) const {
    const auto is_open = [&](uint32_t r) {
      uint32_t open = 0;
      for (uint32_t c = box.c0; c < box.c1; ++c) open += !is_on(at(c, r));
      return open >= kContinuedShare * box.width();
    };
    uint32_t r = box.r0;
    for (uint32_t skip = 0; skip < kAlignedCells && r > 0 && !is_open(r - 1); ++skip) --r;
    const uint32_t top = r;
    while (r > 0 && is_open(r - 1)) --r;
    if (top - r < kContinuedRows) return {};
    // Its jambs are those of the blind.
    uint32_t jambs = 0;
    for (uint32_t k = r; k < top; ++k) {
      const auto has = [&](uint32_t from, uint32_t to) {
        for (uint32_t c = from; c < to; ++c)
          if (c < cells_.columns && is_on(at(c, k))) return true;
        return false;
      };
      jambs += has(box.c0 - std::min(box.c0, 2 * kAlignedCells), box.c0 + 1) &&
               has(box.c1, box.c1 + 2 * kAlignedCells);
    }
    if (jambs < kContinuedShare * (top - r)) return {};
    return CellBox{box.c0, r, box.c1, box.r1};
  }

  // What was seen through, by places without a point of the wall.
  std::vector<CellBox> holes() const {
    std::vector<uint32_t> open;
    for (size_t k = 0; k < marks_.size(); ++k)
      if (!is_on(k) && (marks_[k] & kMarkBehind) != 0) open.push_back(static_cast<uint32_t>(k));
    CellRegions regions(cells_.columns, cells_.rows);
    std::vector<CellBox> out;
    for (const std::vector<uint32_t>& region : regions.of(open))
      if (region.size() >= kLeastStepCells * kLeastStepCells) out.push_back(box_of(region));
    return out;
  }

  void fill(const CellBox& box) {
    for (uint32_t r = box.r0; r < box.r1; ++r)
      for (uint32_t c = box.c0; c < box.c1; ++c) {
        uint8_t& mark = marks_[at(c, r)];
        if ((mark & kMarkOn) != 0) mark = static_cast<uint8_t>((mark & ~kMarkOn) | kMarkBehind);
      }
  }

  std::span<const float> means_;
  const WallCells& cells_;
  std::span<uint8_t> marks_;
};

}  // namespace

void HeightSums::add(size_t cell, double height_m) {
  std::atomic_ref<int64_t>(steps_[cell])
      .fetch_add(std::llround(height_m / kHeightStep_m), std::memory_order_relaxed);
  std::atomic_ref<uint32_t>(counts_[cell]).fetch_add(1, std::memory_order_relaxed);
}

std::vector<float> HeightSums::means_m() const {
  std::vector<float> out(steps_.size(), std::numeric_limits<float>::quiet_NaN());
  std::vector<float> sorted;
  for (size_t k = 0; k < out.size(); ++k) {
    if (counts_[k] == 0) continue;
    out[k] = static_cast<float>(kHeightStep_m * static_cast<double>(steps_[k]) / counts_[k]);
    sorted.push_back(out[k]);
  }
  if (sorted.empty()) return out;
  const auto middle = sorted.begin() + static_cast<ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (float& mean : out) mean -= *middle;
  return out;
}

std::vector<RingBox> mark_set_back(const HeightSums& heights, const WallCells& cells,
                                   std::span<uint8_t> marks, Task& task) {
  std::vector<RingBox> out;
  if (marks.empty()) return out;
  task.checkpoint(0);
  const std::vector<float> means = heights.means_m();
  for (const CellBox& box : SetBack(means, cells, marks).run(task))
    out.push_back({cells.origin + Vec2{static_cast<double>(box.c0), static_cast<double>(box.r0)} *
                                      cells.cell_m,
                   cells.origin + Vec2{static_cast<double>(box.c1), static_cast<double>(box.r1)} *
                                      cells.cell_m});
  return out;
}

bool has_set_back(const WallCells& cells, const OpeningShape& opening) {
  return std::any_of(cells.set_back.begin(), cells.set_back.end(),
                     [&](const RingBox& box) { return opening.holds(box.middle()); });
}

}  // namespace jalon
