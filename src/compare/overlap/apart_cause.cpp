// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/overlap/apart_cause.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kMet = 0.5;   // of the moved cells meet the other's: no chance
constexpr double kBetter = 2;  // times as many as where they are: of clouds that share a place
constexpr size_t kMostTried = 1000;  // cells of each candidate
constexpr double kEdgeShare = 0.02;  // of the reference's diagonal: a candidate need not be exact
constexpr double kAlike = 0.05;      // of the diagonal: extents of one place, seen from elsewhere
// Metres in international and US survey feet, inches, centimetres, millimetres and kilometres.
constexpr double kUnits[] = {0.3048, 1200.0 / 3937, 0.0254, 0.01, 0.001, 1000};
// Extents of one place as two stations see it, and of what is no longer taken for that; between them no claim.
constexpr double kSameExtent = 0.9, kOtherExtent = 0.8;
constexpr double kMostDegrees = 180, kDegreesExtent = 2, kLeastGrid = 1000;

// Coordinates of the compared cloud as a candidate reads them.
class Candidates {
 public:
  Candidates(const ApartSides& sides, double edge)
      : reference_(sides.reference_points, edge), compared_(sides.compared_points, edge) {}
  // As many of the one as of the other must meet: a small thing lies in much that is large.
  template <class F, class G>
  double share(F&& to_reference, G&& to_compared) const {
    return std::min(compared_.share_of_moved(kMostTried, reference_, to_reference),
                    reference_.share_of_moved(kMostTried, compared_, to_compared));
  }

 private:
  OccupiedCells reference_, compared_;
};

using Axes = std::array<int8_t, 3>;

Vec3 with_axes(const Vec3& p, const Axes& axes) {
  const auto of = [&](int8_t a) { return a > 0 ? p[a - 1] : -p[-a - 1]; };
  return {of(axes[0]), of(axes[1]), of(axes[2])};
}

Axes inverse_of(const Axes& axes) {
  Axes out{};
  for (int8_t k = 0; k < 3; ++k) {
    const int8_t a = axes[static_cast<size_t>(k)];
    out[static_cast<size_t>(std::abs(a) - 1)] = static_cast<int8_t>(a > 0 ? k + 1 : -k - 1);
  }
  return out;
}

// The 48 ways, those without signs first: of equally good ones the plainer.
std::vector<Axes> all_axes() {
  constexpr Axes kOrders[] = {{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}};
  std::vector<Axes> out;
  for (int signs = 0; signs < 8; ++signs)
    for (Axes axes : kOrders) {
      for (size_t k = 0; k < 3; ++k)
        if ((signs >> k & 1) != 0) axes[k] = static_cast<int8_t>(-axes[k]);
      out.push_back(axes);
    }
  return out;
}

Vec3 size_with_axes(const Vec3& size, const Axes& axes) {
  const Vec3 out = with_axes(size, axes);
  return {std::abs(out.x), std::abs(out.y), std::abs(out.z)};
}

// What a cause must bring: so many of both clouds' cells that meet and, of clouds that share a place as they are, boxes
// of one size. (Halves of a hall meet better when one is turned round: their size tells that this is no cause.)
struct Asked {
  Vec3 size{};
  double met = kMet, extent = 0;
  bool fits(const Vec3& other) const;
};

// 1 for boxes of one size, less the more their sides differ.
double likeness(const Vec3& a, const Vec3& b) {
  return 1 - norm(a - b) / std::max({norm(a), norm(b), 1e-300});
}

bool Asked::fits(const Vec3& other) const { return likeness(size, other) >= extent; }

bool find_axes(const Candidates& candidates, const Asked& asked, const Vec3& other, Task& task,
               CloudsOverlap& overlap) {
  double best = asked.met;
  for (const Axes& axes : all_axes()) {
    task.checkpoint(0);
    if (!asked.fits(size_with_axes(other, axes))) continue;
    const Axes back = inverse_of(axes);
    const double share = candidates.share([&](const Vec3& p) { return with_axes(p, axes); },
                                          [&](const Vec3& p) { return with_axes(p, back); });
    if (!(share > best)) continue;
    best = share;
    overlap.axes = axes;
    overlap.cause = ApartCause::kAxes;
  }
  return overlap.cause == ApartCause::kAxes;
}

template <class F>
bool find_factor(double least, F&& worth, CloudsOverlap& overlap) {
  double best = least;
  for (const double unit : kUnits)
    for (const double factor : {unit, 1 / unit}) {
      const double share = worth(factor);
      if (!(share > best)) continue;
      best = share;
      overlap.factor = factor;
      overlap.cause = ApartCause::kUnit;
    }
  return overlap.cause == ApartCause::kUnit;
}

// Cells of the one unit are not those of the other: the points are read anew.
bool find_unit(const ApartSides& sides, double edge, const Asked& asked, Task& task,
               CloudsOverlap& overlap) {
  const OccupiedCells reference(sides.reference_points, edge);
  const Vec3 other = sides.compared.max - sides.compared.min;
  return find_factor(
      asked.met,
      [&](double factor) {
        task.checkpoint(0);
        if (!asked.fits(other * factor)) return 0.0;
        std::vector<Vec3> scaled = sides.compared_points;
        for (Vec3& p : scaled) p = p * factor;
        const OccupiedCells compared(scaled, edge);
        return std::min(compared.share_in(reference), reference.share_in(compared));
      },
      overlap);
}

bool is_in_degrees(const Box3& box, const Box3& other) {
  const Vec3 size = box.max - box.min;
  const bool fits = std::abs(box.min.x) <= kMostDegrees && std::abs(box.max.x) <= kMostDegrees &&
                    std::abs(box.min.y) <= kMostDegrees / 2 &&
                    std::abs(box.max.y) <= kMostDegrees / 2;
  return fits && std::max(size.x, size.y) < kDegreesExtent &&
         std::max(size.x, size.y) < 0.1 * size.z && std::abs(other.max.x) > kLeastGrid &&
         std::abs(other.max.y) > kLeastGrid;
}

}  // namespace

void find_cause(const ApartSides& sides, Task& task, CloudsOverlap& overlap) {
  if (overlap.is_apart && (is_in_degrees(sides.reference, sides.compared) ||
                           is_in_degrees(sides.compared, sides.reference))) {
    overlap.cause = ApartCause::kDegrees;
    return;
  }
  const Vec3 size = sides.reference.max - sides.reference.min,
             other = sides.compared.max - sides.compared.min;
  const double edge = kEdgeShare * norm(size);
  if (!(edge > 0) || !(norm(other) > 0)) return;
  if (!overlap.is_apart && likeness(size, other) > kOtherExtent) return;
  const Candidates candidates(sides, edge);
  Asked asked{size};
  if (!overlap.is_apart) {
    const auto as_it_is = [](const Vec3& p) { return p; };
    asked.met = std::max(kMet, kBetter * candidates.share(as_it_is, as_it_is));
    asked.extent = kSameExtent;
  }
  if (find_axes(candidates, asked, other, task, overlap)) return;
  if (find_unit(sides, edge, asked, task, overlap) || !overlap.is_apart) return;
  if (likeness(size, other) >= 1 - kAlike) {
    overlap.cause = ApartCause::kOrigin;
    overlap.shift =
        (sides.reference.min + sides.reference.max - sides.compared.min - sides.compared.max) * 0.5;
    return;
  }
  find_factor(
      1 - kAlike, [&](double factor) { return likeness(size, other * factor); }, overlap);
}

}  // namespace jalon
