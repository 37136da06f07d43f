// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/found_stations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/random.h"
#include "compare/detection/sweep_height.h"

namespace jalon {

namespace {

constexpr size_t kMostLines = 6000;  // of a cloud: a hundred a station for sixty stations
// Points of a sweep so many apart give its direction: next to each other noise would.
constexpr size_t kAlongSweep = 12;
constexpr double kLeastStep_m = 0.15;  // in plan, between them; on walls there is none
constexpr double kLineNear_m = 0.05;   // of a line, at the place where it passes the scanner
constexpr double kOfDistance = 0.004;  // and more with the way: points 12 sweeps apart at 1:250
constexpr int kDraws = 400;
constexpr double kNeighbourhood = 0.02;  // of the lines, beside the first one drawn: one scanner's
constexpr double kLeastAngle = 0.2;      // between two lines that are to tell a place, sine
constexpr double kInliers = 0.7;         // of a station's lines pass it
constexpr size_t kLeastLines = 40;
constexpr size_t kMostStations = 64;
constexpr double kCovered = 0.97;  // of the lines belong to stations, or the order tells nothing

struct PlanLine {
  size_t at;  ///< index of its first point
  double x, y, nx, ny, length;
  double offset(double px, double py) const { return std::abs((px - x) * nx + (py - y) * ny); }
  bool passes(const Vec3& p) const {
    const double way = std::hypot(p.x - x, p.y - y);
    return offset(p.x, p.y) <= kLineNear_m + kOfDistance * way;
  }
};

std::vector<PlanLine> lines_of(const Cloud& cloud) {
  std::vector<PlanLine> out;
  const size_t n = cloud.size();
  if (n < 2 * kAlongSweep) return out;
  const Vec3 origin = cloud.point(0);
  const size_t step = std::max<size_t>(1, (n - kAlongSweep) / kMostLines / 4);
  for (size_t i = 0; i + kAlongSweep < n; i += step) {
    const Vec3 a = cloud.point(i) - origin, b = cloud.point(i + kAlongSweep) - origin;
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    if (length < kLeastStep_m) continue;
    out.push_back({i, a.x, a.y, -dy / length, dx / length, length});
  }
  if (out.size() <= kMostLines) return out;
  const double every = static_cast<double>(out.size()) / kMostLines;
  for (size_t k = 0; k < kMostLines; ++k)
    out[k] = out[static_cast<size_t>(every * static_cast<double>(k))];
  out.resize(kMostLines);
  return out;
}

bool crossing(const PlanLine& a, const PlanLine& b, Vec3& out) {
  const double sine = a.nx * b.ny - a.ny * b.nx;
  if (std::abs(sine) < kLeastAngle) return false;
  const double p = a.nx * a.x + a.ny * a.y, q = b.nx * b.x + b.ny * b.y;
  out = {(p * b.ny - q * a.ny) / sine, (a.nx * q - b.nx * p) / sine, 0};
  return true;
}

// Least squares through the lines that pass near.
void refine(std::span<const PlanLine> lines, Vec3& place) {
  for (int pass = 0; pass < 3; ++pass) {
    double xx = 0, xy = 0, yy = 0, gx = 0, gy = 0;
    for (const PlanLine& l : lines) {
      if (!l.passes(place)) continue;
      const double c = l.nx * l.x + l.ny * l.y;
      xx += l.nx * l.nx, xy += l.nx * l.ny, yy += l.ny * l.ny;
      gx += l.nx * c, gy += l.ny * c;
    }
    const double det = xx * yy - xy * xy;
    if (!(det > 1e-9 * (xx + yy) * (xx + yy))) return;
    place.x = (yy * gx - xy * gy) / det;
    place.y = (xx * gy - xy * gx) / det;
  }
}

size_t passing(std::span<const PlanLine> lines, const Vec3& place) {
  return static_cast<size_t>(std::count_if(lines.begin(), lines.end(),
                                           [&](const PlanLine& l) { return l.passes(place); }));
}

// At the beginning of these lines, of so many of the cloud.
size_t neighbourhood(size_t lines, size_t all) {
  return std::min(lines,
                  std::max<size_t>(kLeastLines,
                                   static_cast<size_t>(kNeighbourhood * static_cast<double>(all))));
}

// The place that most of the lines at the beginning pass: where the scanner of the first points stood.
std::optional<Vec3> first_place(std::span<const PlanLine> lines, size_t all, Task& task) {
  const size_t about = neighbourhood(lines.size(), all);
  RandomStream random(0, all);
  size_t most = 0;
  Vec3 best;
  for (int draw = 0; draw < kDraws; ++draw) {
    if (draw % 50 == 0) task.checkpoint(0);
    // One among the first, the other within ever wider reach: sweeps side by side are nearly parallel.
    const size_t reach = std::min(lines.size(), about << (draw % 8));
    const size_t second = random.below(reach), first = random.below(about);
    Vec3 place;
    if (!crossing(lines[first], lines[second], place)) continue;
    const size_t n = passing(lines.first(about), place);
    // Parallel sweeps alone tell no place: lines further on must agree.
    const size_t wide = passing(lines.first(reach), place);
    if (n * 4 < about * 3 || wide <= most) continue;
    most = wide;
    best = place;
  }
  if (most < kLeastLines) return std::nullopt;
  return best;
}

struct NextPlace {
  Vec3 place;
  size_t from = 0;  ///< lines before it are still the last one's
};

// The place of the next station. Of the last one, lines over edges may be left that pass nothing: they end where most
// of both pass their own.
std::optional<NextPlace> next_place(std::span<const PlanLine> lines, size_t all, const Vec3* last,
                                    Task& task) {
  const size_t step = std::max<size_t>(1, neighbourhood(lines.size(), all) / 2);
  const size_t most = last != nullptr ? 2 * step : 0;
  for (size_t left = 0; left <= most && left < lines.size(); left += step) {
    const std::optional<Vec3> place = first_place(lines.subspan(left), all, task);
    if (!place) continue;
    NextPlace out{*place, 0};
    int64_t sum = 0, best = 0;
    for (size_t k = 0; k < left; ++k) {
      sum += (lines[k].passes(*last) ? 1 : 0) - (lines[k].passes(*place) ? 1 : 0);
      if (sum >= best) best = sum, out.from = k + 1;
    }
    return out;
  }
  return std::nullopt;
}

// How many lines from the beginning belong to the place: up to where those that do not pass it prevail. Where a coarse
// scan has much in front of something else, four lines in ten reach over edges and pass nothing.
size_t lines_until(std::span<const PlanLine> lines, const Vec3& place) {
  int64_t sum = 0, best = 0;
  size_t end = 0;
  for (size_t k = 0; k < lines.size(); ++k) {
    sum += lines[k].passes(place) ? 1 : -1;
    if (sum > best) best = sum, end = k + 1;
  }
  return end;
}

Station station_at(const Vec3& place, uint64_t first, uint64_t count, size_t number) {
  Station out;
  out.name = "found " + std::to_string(number);
  out.has_pose = true;
  out.pose.m[3] = place.x;
  out.pose.m[7] = place.y;
  out.pose.m[11] = place.z;
  out.first = first;
  out.count = count;
  return out;
}

}  // namespace

bool has_all_stations(const Cloud& cloud) {
  uint64_t placed = 0;
  for (const Station& s : cloud.stations) placed += s.has_pose ? s.count : 0;
  return cloud.size() > 0 && placed == cloud.size();
}

std::vector<Station> find_stations(const Cloud& cloud, Task& task) {
  // 1. Lines in plan; 2. where they meet, scanner after scanner; 3. from when on the next one's begin; 4. the heights.
  const std::vector<PlanLine> lines = lines_of(cloud);
  std::vector<Station> out;
  size_t from = 0, passed = 0;
  uint64_t first = 0;
  Vec3 last;  // in plan
  while (lines.size() - from >= kLeastLines && out.size() < kMostStations) {
    std::span<const PlanLine> rest(lines.data() + from, lines.size() - from);
    const auto next = next_place(rest, lines.size(), out.empty() ? nullptr : &last, task);
    if (!next) break;
    if (next->from > 0) {
      passed += passing(rest.first(next->from), last);
      from += next->from;
      rest = rest.subspan(next->from);
      first = lines[from].at;
      out.back().count = first - out.back().first;
    }
    Vec3 place = next->place;
    refine(rest, place);
    const size_t n = lines_until(rest, place);
    if (n < kLeastLines) break;
    refine(rest.first(n), place);
    passed += passing(rest.first(n), place);
    from += n;
    const bool is_last = lines.size() - from < kLeastLines;
    const uint64_t end = is_last ? cloud.size() : lines[from].at;
    const std::optional<double> height =
        sweep_height(cloud, first, end, cloud.point(0) + place, task);
    if (!height) return {};
    out.push_back(station_at({cloud.point(0).x + place.x, cloud.point(0).y + place.y, *height},
                             first, end - first, out.size() + 1));
    first = end;
    last = place;
  }
  const auto all = static_cast<double>(lines.size());
  if (!out.empty() && static_cast<double>(from) >= kCovered * all) {
    out.back().count = cloud.size() - out.back().first;  // with what passes nothing at its end
    first = cloud.size();
  }
  const bool is_covered = first == cloud.size() && static_cast<double>(from) >= kCovered * all &&
                          static_cast<double>(passed) >= kInliers * all;
  return is_covered && !out.empty() ? out : std::vector<Station>{};
}

CloudPtr with_found_stations(const CloudPtr& cloud, Task& task) {
  if (has_all_stations(*cloud)) return cloud;
  std::vector<Station> found = find_stations(*cloud, task);
  if (found.empty()) return cloud;
  auto out = std::make_shared<Cloud>(*cloud);
  out->stations = std::move(found);
  return out;
}

}  // namespace jalon
