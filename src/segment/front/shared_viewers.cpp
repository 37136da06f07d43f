// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/shared_viewers.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "segment/front/side.h"
#include "segment/front/storeys.h"

namespace jalon {

namespace {

constexpr double kEyeHeight_m = 1.7;
constexpr double kViewer_m = 2;  // before the wall: nearer than what stands across a lane
// Where scanners stand. In view from near and from far: a back wall in a passage or a room is not, whose near viewer
// would see the facade from within.
constexpr double kViewerDistances_m[] = {2, 5, 10};
constexpr double kTripods_m[] = {3, 6, 12, 24, 48};  // as in free_space.cpp
constexpr size_t kProbes = 200;                      // of a wall, to see how much of it is in view
constexpr double kInView = 0.5;                      // of them
// A voter's area over that of the wall in its viewer's sight: what is seen of a room through windows is small, and
// says nothing of the facade.
constexpr double kLeastVoter = 0.5;
// Log odds that a wall in view of a viewer was scanned from there: 19 of 20 were.
constexpr double kMostShared = 2.94;
// Of storeys of one front: 399 of 400 look the same way.
constexpr double kMostOfStoreys = 5.99;

std::vector<Vec3> probes_of(const WallSheet& sheet) {
  std::vector<Vec3> all, out;
  for (size_t cell = 0; cell < sheet.cells(); ++cell)
    if (sheet.is_solid(cell)) all.push_back(sheet.point_of(sheet.middle_of(cell)));
  const size_t stride = all.size() / kProbes + 1;
  for (size_t i = 0; i < all.size(); i += stride) out.push_back(all[i]);
  return out;
}

double measured_m2(const WallSheet& sheet) {
  size_t cells = 0;
  for (size_t cell = 0; cell < sheet.cells(); ++cell) cells += sheet.is_solid(cell);
  return static_cast<double>(cells) * sheet.cell_m() * sheet.cell_m();
}

bool hides(const WallSheet& sheet, const Vec3& eye, const Vec3& place) {
  const WallPlace a = sheet.place_of(eye), b = sheet.place_of(place);
  if ((a.d > 0) == (b.d > 0)) return false;
  const double t = a.d / (a.d - b.d);
  const size_t cell = sheet.cell_of(a.u + t * (b.u - a.u), a.v + t * (b.v - a.v));
  return cell < sheet.cells() && sheet.is_solid(cell);
}

double share_in_view(const std::vector<WallSheet>& sheets, size_t wall,
                     const std::vector<Vec3>& probes, const Vec3& eye) {
  size_t seen = 0;
  for (const Vec3& probe : probes) {
    bool is_hidden = false;
    for (size_t k = 0; k < sheets.size() && !is_hidden; ++k)
      is_hidden = k != wall && hides(sheets[k], eye, probe);
    seen += !is_hidden;
  }
  return probes.empty() ? 0 : static_cast<double>(seen) / static_cast<double>(probes.size());
}

Vec3 eye_before(const WallSheet& sheet, double side, double distance_m) {
  return sheet.point_of(
      {0.5 * (sheet.left() + sheet.right()), sheet.foot() + kEyeHeight_m, side * distance_m});
}

// From which side the viewers of a wall see another: 1, -1, or 0 where they do not all.
double side_seen(const std::vector<WallSheet>& sheets, size_t from, double side, size_t wall,
                 const std::vector<Vec3>& probes) {
  double out = 0;
  for (const double distance_m : kViewerDistances_m) {
    const Vec3 eye = eye_before(sheets[from], side, distance_m);
    const double seen = sheets[wall].place_of(eye).d >= 0 ? 1 : -1;
    if (seen == -out || share_in_view(sheets, wall, probes, eye) <= kInView) return 0;
    out = seen;
  }
  return out;
}

// What is known of a wall's viewers, as log odds of a parallel one: they stood on one of the tripods before it, any of
// those that see both. The back wall of an arcade is seen past the piers from all but the nearest, a storey that stands
// out over another one from all.
double parallel_vote(const std::vector<WallSheet>& sheets,
                     const std::vector<std::vector<Vec3>>& probes, size_t from, double side,
                     double sure, size_t wall) {
  if (std::fabs(dot(sheets[from].normal(), sheets[wall].normal())) < kSameDirection) return 0;
  double told = 0;
  for (const double distance_m : kTripods_m) {
    const Vec3 eye = eye_before(sheets[from], side, distance_m);
    const double seen = sheets[wall].place_of(eye).d >= 0 ? 1 : -1;
    const double both = share_in_view(sheets, from, probes[from], eye) *
                        share_in_view(sheets, wall, probes[wall], eye);
    told += both * (probability_of(seen * sure) - 0.5);
  }
  const double before = 0.5 + told / static_cast<double>(std::size(kTripods_m));
  return std::log(before / (1 - before));
}

}  // namespace

Vec3 viewer_before(const WallSheet& sheet, double side) {
  return eye_before(sheet, side, kViewer_m);
}

void share_viewers(const std::vector<WallSheet>& sheets, std::vector<double>& log_odds) {
  const size_t n = sheets.size();
  std::vector<std::vector<Vec3>> probes;
  std::vector<double> area_m2;
  for (const WallSheet& sheet : sheets) {
    probes.push_back(probes_of(sheet));
    area_m2.push_back(measured_m2(sheet));
  }
  std::vector<double> shared(n, 0);  // what the surest of the viewers says
  std::vector<uint8_t> is_settled(n, 0);
  const auto odds = [&](size_t g) { return log_odds[g] + shared[g]; };
  // What a settled wall says of another.
  const auto vote_of = [&](size_t from, double side, double own, size_t g) {
    if (are_storeys({sheets[from], probes[from]}, {sheets[g], probes[g]})) {
      const double same = dot(sheets[from].normal(), sheets[g].normal()) > 0 ? 1 : -1;
      return same * side * std::min(own, kMostOfStoreys);
    }
    const double sure = std::min(own, kMostShared);
    const double seen =
        area_m2[from] < kLeastVoter * area_m2[g] ? 0 : side_seen(sheets, from, side, g, probes[g]);
    return seen != 0 ? seen * sure : parallel_vote(sheets, probes, from, side, sure, g);
  };
  for (size_t round = 0; round < n; ++round) {
    size_t surest = n;
    for (size_t g = 0; g < n; ++g)
      if (is_settled[g] == 0 && (surest == n || std::fabs(odds(g)) > std::fabs(odds(surest))))
        surest = g;
    is_settled[surest] = 1;
    const double own = std::fabs(odds(surest)), side = odds(surest) >= 0 ? 1 : -1;
    for (size_t g = 0; g < n; ++g) {
      if (is_settled[g] != 0) continue;
      const double vote = vote_of(surest, side, own, g);
      if (std::fabs(vote) > std::fabs(shared[g])) shared[g] = vote;
    }
  }
  for (size_t g = 0; g < n; ++g) log_odds[g] += shared[g];
}

}  // namespace jalon
