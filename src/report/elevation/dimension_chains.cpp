// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/dimension_chains.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

using Interval = OpeningInterval;

// Intervals whose ends agree within the tolerance become one, at their mean; ascending.
std::vector<Interval> alike_joined(std::vector<Interval> intervals, double tolerance_m) {
  std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  std::vector<Interval> out;
  for (const Interval& i : intervals) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const Interval& o) {
      return std::fabs(o.from - i.from) <= tolerance_m && std::fabs(o.to - i.to) <= tolerance_m;
    });
    if (same == out.end()) {
      out.push_back(i);
      continue;
    }
    const auto n = static_cast<double>(++same->count);
    same->from += (i.from - same->from) / n;
    same->to += (i.to - same->to) / n;
  }
  return out;
}

// The most frequent intervals that stand clear of each other, ascending.
std::vector<Interval> clear_of_each_other(std::vector<Interval> intervals) {
  std::stable_sort(intervals.begin(), intervals.end(),
                   [](const Interval& a, const Interval& b) { return a.count > b.count; });
  std::vector<Interval> out;
  for (const Interval& i : intervals) {
    const bool is_clear = std::none_of(
        out.begin(), out.end(), [&](const Interval& o) { return i.from < o.to && o.from < i.to; });
    if (is_clear) out.push_back(i);
  }
  std::sort(out.begin(), out.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  return out;
}

// Ascending places without those that fall on their neighbour.
std::vector<double> between(double from, const std::vector<double>& inner, double to,
                            double tolerance_m) {
  std::vector<double> out{from};
  for (const double at : inner)
    if (at - out.back() > tolerance_m && to - at > tolerance_m) out.push_back(at);
  out.push_back(to);
  return out;
}

Interval across(const OpeningBox& box) { return {box.low.u, box.high.u}; }
Interval upright(const OpeningBox& box) { return {box.low.v, box.high.v}; }

// The lowest opening, and all that stand beside it rather than above it: their middles lie within its height.
std::vector<bool> lowest_row(std::span<const OpeningBox> openings) {
  const auto middle = [](const OpeningBox& b) { return (b.low.v + b.high.v) / 2; };
  const auto lowest = std::min_element(
      openings.begin(), openings.end(),
      [&](const OpeningBox& a, const OpeningBox& b) { return middle(a) < middle(b); });
  std::vector<bool> out;
  for (const OpeningBox& box : openings) out.push_back(middle(box) <= lowest->high.v);
  return out;
}

bool is_among(double at, const std::vector<double>& places, double tolerance_m) {
  return std::any_of(places.begin(), places.end(),
                     [&](double p) { return std::fabs(p - at) <= tolerance_m; });
}

// The ground, the top, cornices, then the rows by their number of openings.
std::vector<double> wanted_levels(const std::vector<Interval>& rows,
                                  std::span<const OpeningBox> long_boxes, const OpeningBox& facade,
                                  double ground_m, double tolerance_m) {
  std::vector<double> out;
  const auto add = [&](double at) {
    if (!is_among(at, out, tolerance_m)) out.push_back(at);
  };
  add(ground_m);
  add(facade.high.v);
  std::vector<Interval> by_count = rows;
  std::stable_sort(by_count.begin(), by_count.end(),
                   [](const Interval& a, const Interval& b) { return a.count > b.count; });
  for (const Interval& row : by_count) add(row.from), add(row.to);
  for (const OpeningBox& box : long_boxes) add(box.low.v), add(box.high.v);
  add(facade.low.v);
  return out;
}

}  // namespace

std::vector<double> OpeningChain::sides() const {
  std::vector<double> inner;
  for (const Interval& i : openings) inner.insert(inner.end(), {i.from, i.to});
  return openings.empty() ? inner : between(from, inner, to, tolerance_m);
}

std::vector<double> OpeningChain::axes() const {
  std::vector<double> inner;
  for (const Interval& i : openings) inner.push_back((i.from + i.to) / 2);
  return openings.empty() ? inner : between(from, inner, to, tolerance_m);
}

void OpeningChain::drop_narrowest() {
  openings.erase(std::min_element(
      openings.begin(), openings.end(),
      [](const Interval& a, const Interval& b) { return a.to - a.from < b.to - b.from; }));
}

Dimensions find_dimensions(std::span<const OpeningBox> openings,
                           std::span<const OpeningBox> long_boxes, const OpeningBox& facade,
                           double ground_m, double tolerance_m) {
  Dimensions out;
  std::vector<Interval> upper, lower, heights;
  if (!openings.empty()) {
    const auto is_low = lowest_row(openings);
    for (size_t i = 0; i < openings.size(); ++i) {
      (is_low[i] ? lower : upper).push_back(across(openings[i]));
      heights.push_back(upright(openings[i]));
    }
  }
  const auto chain = [&](const std::vector<Interval>& of, double from, double to) {
    return OpeningChain{clear_of_each_other(alike_joined(of, tolerance_m)), from, to, tolerance_m};
  };
  const bool is_one_row = upper.empty();
  out.columns = chain(is_one_row ? lower : upper, facade.low.u, facade.high.u);
  out.axes = out.columns.axes();
  out.rows = chain(heights, facade.low.v, facade.high.v);
  const OpeningChain ground_floor = chain(is_one_row ? upper : lower, facade.low.u, facade.high.u);
  const auto sides = ground_floor.sides(), known = out.columns.sides();
  if (std::any_of(sides.begin(), sides.end(),
                  [&](double at) { return !is_among(at, known, tolerance_m); }))
    out.ground_floor = ground_floor;
  out.levels =
      wanted_levels(alike_joined(heights, tolerance_m), long_boxes, facade, ground_m, tolerance_m);
  return out;
}

}  // namespace jalon
