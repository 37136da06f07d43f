// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace jalon {

namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
constexpr size_t kDepthStepsPerCheck = 1 << 18;
constexpr double kLoneStep_rad = 0.01;  // of a station with a single point: any will do

/// The field cut into at most 64 x 64 windows with 16 points on average.
class Windows {
 public:
  Windows(const AngularField& field, size_t points)
      : field_(field),
        side_(std::clamp<size_t>(static_cast<size_t>(std::sqrt(static_cast<double>(points) / 16)),
                                 1, 64)),
        per_horizontal_(per(field.horizontal_extent_rad)),
        per_vertical_(per(field.vertical_extent_rad)) {}
  size_t size() const { return side_ * side_; }
  double area() const {
    return field_.horizontal_extent_rad * field_.vertical_extent_rad / static_cast<double>(size());
  }
  size_t of(const Seen& p) const {
    double around = p.horizontal_rad - field_.horizontal_from_rad;
    if (around < 0) around += kTurn_rad;
    return part((p.vertical_rad - field_.vertical_from_rad) * per_vertical_) * side_ +
           part(around * per_horizontal_);
  }

 private:
  double per(double extent) const { return extent > 0 ? static_cast<double>(side_) / extent : 0; }
  size_t part(double k) const {
    return static_cast<size_t>(std::clamp(k, 0.0, static_cast<double>(side_ - 1)));
  }
  AngularField field_;
  size_t side_;
  double per_horizontal_, per_vertical_;  ///< windows a radian
};

template <class T>
T median_of(std::vector<T>& values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The points of windows of common density, evenly spread over the field.
std::vector<std::vector<Seen>> typical_windows(std::span<const Seen> points, const Windows& windows,
                                               const std::vector<uint32_t>& counts, uint32_t median,
                                               Task& task) {
  constexpr size_t kWindows = 48, kPoints = 4096;
  std::vector<size_t> common;
  for (size_t w = 0; w < counts.size(); ++w)
    if (2 * counts[w] >= median && counts[w] <= 2 * median) common.push_back(w);
  std::vector<uint32_t> slot(counts.size(), 0);  // 1 + number of the chosen window
  const size_t chosen = std::min(kWindows, common.size());
  for (size_t k = 0; k < chosen; ++k)
    slot[common[k * common.size() / chosen]] = static_cast<uint32_t>(k + 1);
  std::vector<std::vector<Seen>> out(chosen);
  for (size_t i = 0; i < points.size(); ++i) {
    if (i % kDepthStepsPerCheck == 0)
      task.checkpoint(0.5 + 0.4 * static_cast<double>(i) / static_cast<double>(points.size()));
    const uint32_t k = slot[windows.of(points[i])];
    if (k != 0 && out[k - 1].size() < kPoints) out[k - 1].push_back(points[i]);
  }
  return out;
}

/// Distances from some points of a window to the next one within 14 degrees of either axis.
void next_across(const std::vector<Seen>& window, std::vector<double>& horizontal,
                 std::vector<double>& vertical) {
  constexpr size_t kQueries = 64;
  constexpr double kSlope = 0.25;  // tan(14 degrees)
  const size_t stride = window.size() / kQueries + 1;
  for (size_t q = 0; q < window.size(); q += stride) {
    double h = kTurn_rad, v = kTurn_rad;
    for (size_t i = 0; i < window.size(); ++i) {
      const double du = std::abs(double{window[i].horizontal_rad} - window[q].horizontal_rad);
      const double dv = std::abs(double{window[i].vertical_rad} - window[q].vertical_rad);
      if (i == q || (du == 0 && dv == 0)) continue;
      if (dv <= kSlope * du) h = std::min(h, du);
      if (du <= kSlope * dv) v = std::min(v, dv);
    }
    if (h < kTurn_rad) horizontal.push_back(h);
    if (v < kTurn_rad) vertical.push_back(v);
  }
}

}  // namespace

AngularField angular_field(std::span<const Seen> points, Task& task) {
  // 1. Which tenths of a degree are looked at, and how high and low.
  constexpr size_t kParts = 3600;
  constexpr double kNarrow_rad = 0.05;
  std::array<bool, kParts> seen{};
  double low = kTurn_rad, high = -kTurn_rad;
  const auto part_of = [](double h) {
    return std::min(kParts - 1, static_cast<size_t>(std::max(0.0, (h / kTurn_rad + 0.5) * kParts)));
  };
  for (size_t i = 0; i < points.size(); ++i) {
    if (i % kDepthStepsPerCheck == 0)
      task.checkpoint(0.5 * static_cast<double>(i) / static_cast<double>(points.size()));
    seen[part_of(points[i].horizontal_rad)] = true;
    low = std::min(low, double{points[i].vertical_rad});
    high = std::max(high, double{points[i].vertical_rad});
  }
  // 2. The widest gap around the circle.
  size_t gap_end = 0, widest = 0, run = 0;
  for (size_t k = 0; k < 2 * kParts; ++k) {
    run = seen[k % kParts] ? 0 : std::min(run + 1, kParts);
    if (run > widest) widest = run, gap_end = (k + 1) % kParts;
  }
  AngularField field{-std::numbers::pi, kTurn_rad, low, high - low,
                     static_cast<double>(widest) / kParts * kTurn_rad < kNarrow_rad};
  if (field.is_closed) return field;
  // 3. What is left of the circle, to the points.
  double first = kTurn_rad, last = 0;
  const double after_gap = (static_cast<double>(gap_end) / kParts - 0.5) * kTurn_rad;
  for (size_t i = 0; i < points.size(); ++i) {
    if (i % kDepthStepsPerCheck == 0)
      task.checkpoint(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(points.size()));
    double around = points[i].horizontal_rad - after_gap;
    if (part_of(points[i].horizontal_rad) < gap_end) around += kTurn_rad;
    first = std::min(first, around);
    last = std::max(last, around);
  }
  field.horizontal_from_rad = after_gap + first;
  if (field.horizontal_from_rad >= std::numbers::pi) field.horizontal_from_rad -= kTurn_rad;
  field.horizontal_extent_rad = last - first;
  return field;
}

AngularSteps angular_steps(std::span<const Seen> points, const AngularField& field, Task& task) {
  // 1. Points of each window; the density of the median one.
  const Windows windows(field, points.size());
  std::vector<uint32_t> counts(windows.size(), 0);
  for (size_t i = 0; i < points.size(); ++i) {
    if (i % kDepthStepsPerCheck == 0)
      task.checkpoint(0.5 * static_cast<double>(i) / static_cast<double>(points.size()));
    ++counts[windows.of(points[i])];
  }
  std::vector<uint32_t> occupied;
  for (const uint32_t count : counts)
    if (count > 0) occupied.push_back(count);
  if (occupied.empty()) return {kLoneStep_rad, kLoneStep_rad};
  const uint32_t median = median_of(occupied);
  const double area = windows.area() / median;

  // 2. The next points across and along.
  std::vector<double> horizontal, vertical;
  for (const auto& window : typical_windows(points, windows, counts, median, task))
    next_across(window, horizontal, vertical);
  if (horizontal.empty() || vertical.empty()) {
    const double longest = std::max(field.horizontal_extent_rad, field.vertical_extent_rad);
    const double step = area > 0 ? std::sqrt(area) : longest / static_cast<double>(points.size());
    return step > 0 ? AngularSteps{step, step} : AngularSteps{kLoneStep_rad, kLoneStep_rad};
  }
  const double h = median_of(horizontal), v = median_of(vertical);

  // 3. A lattice has one point a cell of the two. Where that does not hold, only the density is known.
  constexpr double kAgree = 3;
  if (!(area > 0)) return {h, v};
  if (h * v > area * kAgree || h * v * kAgree < area) return {std::sqrt(area), std::sqrt(area)};
  return {h, v};
}

}  // namespace jalon
