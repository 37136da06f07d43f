// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/wall_claims.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "registration/joint/point_cells.h"
#include "registration/joint/strip_extents.h"
#include "spatial/quantile.h"

namespace jalon {

namespace {

constexpr double kOnFacade = 3;      // standard deviations, of points that stand on a facade
constexpr double kSurface_m = 0.15;  // and as far at least: joinery, see strip_surfaces.cpp
// A facade that is so far off, or so turned, is no rival.
constexpr double kMostChiSquare = kMostDeviations * kMostDeviations;
// What a beam through a facade counts against one that ends on it, as for blocks (block_search.cpp).
constexpr double kBeamThrough = 0.5;

// Where the loop has the points now.
std::vector<Vec3> moved_points(const LoopState& state) {
  std::vector<Vec3> made;
  for (size_t i = 0; i < state.points.size(); ++i) {
    const TimePlace& at = state.points.places[i];
    const Vec2 by = state.places.trajectory[at.epoch] * (1 - at.share) +
                    state.places.trajectory[at.epoch + 1] * at.share;
    made.push_back(state.points.at[i] + Vec3{by.u, by.v, 0});
  }
  return made;
}

// How points scatter about the strips that they are on, as the last pass has them: relief, and planes that are turned.
double scatter_m(const LoopState& state, const JointSettings& settings) {
  constexpr double kMedianToSigma = 1.4826,
                   kLeast_m = 1e-6;  // exact points: rounding does not decide
  std::vector<double> off;
  for (size_t i = 0; i < state.matches.size(); ++i)
    if (state.weights[i] > 0) off.push_back(std::fabs(state.matches[i].distance_m));
  const double scatter = off.empty() ? 0 : kMedianToSigma * quantile_of(off, 0.5);
  return std::max({kLeast_m, settings.sigma_point_m, scatter});
}

std::vector<Vec3> moved_middles(const StripScene& scene, const std::vector<StripExtent>& extents,
                                const std::vector<Vec2>& blocks) {
  std::vector<Vec3> made = strip_middles(scene, extents);
  for (size_t s = 0; s < made.size(); ++s) {
    const Vec2& by = blocks[scene.strips[s].block];
    made[s] += Vec3{by.u, by.v, 0};
  }
  return made;
}

class WallClaims {
 public:
  WallClaims(const LoopState& state, const JointSettings& settings)
      : state_(state),
        settings_(settings),
        at_(moved_points(state)),
        point_cells_(at_),
        extents_(strip_extents(state.scene)),
        middles_(moved_middles(state.scene, extents_, state.places.model.blocks)),
        middle_cells_(middles_),
        strips_of_(state.scene.facades),
        points_of_(state.scene.facades),
        facade_of_(at_.size(), kNoStrip),
        reach_m_(kMostDeviations * settings.sigma_facade_m),
        accepted_m_(greatest_deviation(settings) * settings.sigma_facade_m),
        scatter_m_(scatter_m(state, settings)),
        strip_reach_m_(
            std::max(kSurface_m, kOnFacade * std::hypot(scatter_m_, settings.sigma_strip_m))),
        least_alignment_(std::cos(settings.greatest_turn_rad)) {
    for (uint32_t s = 0; s < extents_.size(); ++s)
      if (!extents_[s].is_empty()) {
        strips_of_[state.scene.strips[s].facade].push_back(s);
        widest_m_ = std::max(widest_m_, extents_[s].to - extents_[s].from);
      }
    for (uint32_t i = 0; i < at_.size(); ++i) {
      const PointMatch& match = state.matches[i];
      if (match.strip == kNoStrip || !(std::fabs(match.distance_m) < strip_reach_m_)) continue;
      facade_of_[i] = state.scene.strips[match.strip].facade;
      if (state.weights[i] > 0) points_of_[facade_of_[i]].push_back(i);
    }
    share_out_the_rest();
  }

  /// Those of the wall that the facade stands on, its own first.
  std::vector<FacadeClaim> of_wall(uint32_t wall) const {
    std::vector<FacadeClaim> made;
    if (points_of_[wall].empty()) return made;
    for (const uint32_t facade : candidates(wall))
      if (const auto stand = stand_of(facade, wall))
        made.push_back({facade, wall, stand->offset_m, stands_at(facade, stand->offset_m),
                        worth_of(facade, wall, *stand), std::fabs(stand->offset_m) < accepted_m_});
    return made;
  }

 private:
  // Points on a facade whose beams end on no facade are of the first that they lie on: two on one wall do not both
  // explain them.
  void share_out_the_rest() {
    for (uint32_t facade = 0; facade < points_of_.size(); ++facade) {
      const auto stand = stand_of(facade, facade);
      if (!stand) continue;
      for (const uint32_t s : strips_of_[facade])
        each_met(s, *stand, [&](uint32_t i, bool is_on) {
          if (is_on && facade_of_[i] == kNoStrip) facade_of_[i] = facade;
        });
    }
  }

  // Itself, then the parallel ones about it, ascending.
  std::vector<uint32_t> candidates(uint32_t wall) const {
    Box3 box;
    for (const uint32_t i : points_of_[wall]) box.add(at_[i]);
    const double about = reach_m_ + widest_m_;
    const Vec2& normal = state_.scene.strips[strips_of_[wall].front()].normal;
    std::vector<uint32_t> made;
    middle_cells_.each({box.min.x - about, box.min.y - about},
                       {box.max.x + about, box.max.y + about}, [&](uint32_t s) {
                         const GivenStrip& strip = state_.scene.strips[s];
                         if (strip.facade != wall && dot(strip.normal, normal) > kParallel)
                           made.push_back(strip.facade);
                       });
    std::sort(made.begin(), made.end());
    made.erase(std::unique(made.begin(), made.end()), made.end());
    made.insert(made.begin(), wall);
    return made;
  }

  bool stands_at(uint32_t facade, double offset_m) const {
    return !points_of_[facade].empty() &&
           std::fabs(state_.places.model.facades[facade] - offset_m) < strip_reach_m_;
  }

  // In the frame of the strip's block, where the strip is given.
  Vec3 in_block(uint32_t point, const GivenStrip& strip) const {
    const Vec2& by = state_.places.model.blocks[strip.block];
    return at_[point] - Vec3{by.u, by.v, 0};
  }

  // How the points of a wall lie before a facade where it is given: at "middle" by offset_m, and turned from it.
  struct Stand {
    double offset_m = 0, middle_m = 0, turn = 0, chi_square = 0;
    double offset_at(double place_m) const { return offset_m + turn * (place_m - middle_m); }
  };

  // None where few of the points lie before or behind the facade, or where it is not on them now and they are farther
  // off than its sigma allows.
  std::optional<Stand> stand_of(uint32_t facade, uint32_t wall) const {
    double n = 0, x = 0, xx = 0, d = 0, xd = 0, strips = 0;
    for (const uint32_t s : strips_of_[facade]) {
      const GivenStrip& strip = state_.scene.strips[s];
      const double before = n;
      for (const uint32_t i : points_of_[wall]) {
        const Vec3 p = in_block(i, strip);
        const double place = dot(along(strip), {p.x, p.y});
        if (!extents_[s].contains(place, p.z)) continue;
        const double at = place - extents_[strips_of_[facade].front()].from,
                     off = dot(strip.normal, {p.x, p.y}) - strip.offset_m;
        n += 1, x += at, xx += at * at, d += off, xd += at * off;
      }
      if (n > before) strips += 1;
    }
    if (n < std::max(2.0, static_cast<double>(settings_.least_points))) return {};
    Stand made;
    made.offset_m = d / n, made.middle_m = x / n;
    const double spread2 = xx / n - made.middle_m * made.middle_m;
    if (spread2 > 0) made.turn = (xd / n - made.middle_m * made.offset_m) / spread2;
    made.middle_m += extents_[strips_of_[facade].front()].from;
    // The facade's own error, and a turn that its strips, each off by itself, would show by chance.
    const double of_turn =
        made.turn * made.turn * spread2 * strips /
        (settings_.sigma_strip_m * settings_.sigma_strip_m + scatter_m_ * scatter_m_ * strips / n);
    const double deviations = made.offset_m / settings_.sigma_facade_m;
    made.chi_square = deviations * deviations + of_turn;
    const bool is_possible =
        std::fabs(made.offset_m) < reach_m_ && made.chi_square < kMostChiSquare;
    if (facade != wall && !is_possible) return {};
    return made;
  }

  double worth_of(uint32_t facade, uint32_t wall, const Stand& stand) const {
    double sum = -stand.chi_square / 2;
    for (const uint32_t s : strips_of_[facade]) sum += worth_of_strip(s, facade, wall, stand);
    return sum;
  }

  double worth_of_strip(uint32_t s, uint32_t facade, uint32_t wall, const Stand& stand) const {
    double on = 0, through = 0;
    each_met(s, stand, [&](uint32_t i, bool is_on) {
      if (!is_on) through += 1;
      else if (is_of_either(i, facade, wall) && is_aligned(i, state_.scene.strips[s].normal))
        on += 1;
    });
    return on - kBeamThrough * through;
  }

  // The points on a strip, and those whose beams go through it.
  template <class F>
  void each_met(uint32_t s, const Stand& stand, F&& f) const {
    const GivenStrip& strip = state_.scene.strips[s];
    const StripExtent& extent = extents_[s];
    const Vec2 n = strip.normal, h = along(strip), &block = state_.places.model.blocks[strip.block];
    const double plane = strip.offset_m + stand.offset_at((extent.from + extent.to) / 2);
    Box3 box;
    for (const double by : {strip_reach_m_, -strip_reach_m_ - kBehind_m})
      for (const double to : {extent.from, extent.to}) {
        const Vec2 corner = n * (plane + by) + h * to + block;
        box.add({corner.u, corner.v, 0});
      }
    point_cells_.each({box.min.x, box.min.y}, {box.max.x, box.max.y}, [&](uint32_t i) {
      const Vec3 p = in_block(i, strip), &way = state_.points.direction[i];
      const double off = dot(n, {p.x, p.y}) - plane, level = dot(n, {way.x, way.y});
      if (!(level < 0) || off > strip_reach_m_ || off < -strip_reach_m_ - kBehind_m) return;
      const bool is_on = off > -strip_reach_m_;
      const double back = is_on ? 0 : off / level;
      if (extent.contains(dot(h, {p.x - back * way.x, p.y - back * way.y}), p.z - back * way.z))
        f(i, is_on);
    });
  }

  bool is_of_either(uint32_t point, uint32_t facade, uint32_t wall) const {
    const uint32_t of = facade_of_[point];
    return of == kNoStrip || of == facade || of == wall;
  }
  bool is_aligned(uint32_t point, const Vec2& normal) const {
    const std::vector<Vec2>& normals = state_.points.normal;
    return normals.empty() || std::fabs(dot(normals[point], normal)) >= least_alignment_;
  }

  const LoopState& state_;
  const JointSettings& settings_;
  std::vector<Vec3> at_;
  PointCells point_cells_;
  std::vector<StripExtent> extents_;
  std::vector<Vec3> middles_;
  PointCells middle_cells_;
  std::vector<std::vector<uint32_t>> strips_of_, points_of_;  ///< of each facade
  std::vector<uint32_t> facade_of_;  ///< that a point's beam ends on; kNoStrip: on none
  double reach_m_, accepted_m_, scatter_m_, strip_reach_m_, least_alignment_, widest_m_ = 0;
};

}  // namespace

bool is_facade_exchange_wanted(const JointSettings& settings) {
  constexpr double kBridged_m = 0.5;  // as far as the loop mends by itself
  return greatest_deviation(settings) * settings.sigma_facade_m > kBridged_m;
}

std::vector<FacadeClaim> wall_claims(const LoopState& state, const JointSettings& settings,
                                     Task& task) {
  const WallClaims claims(state, settings);
  const size_t n = state.scene.facades;
  std::vector<std::vector<FacadeClaim>> of_wall(n);
  constexpr size_t kWallsGrain = 16;
  parallel_for(task, n, kWallsGrain, [&](size_t begin, size_t end) {
    for (size_t w = begin; w < end; ++w) of_wall[w] = claims.of_wall(static_cast<uint32_t>(w));
  });
  std::vector<FacadeClaim> made;
  for (const auto& some : of_wall) made.insert(made.end(), some.begin(), some.end());
  return made;
}

}  // namespace jalon
