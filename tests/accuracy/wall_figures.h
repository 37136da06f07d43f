// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// How a model's walls agree with the true ones: openings, areas, vertices, arcs.
#pragma once

#include <array>
#include <limits>
#include <sstream>

#include "wall_truth.h"

namespace jalon::test {

constexpr double kFoundIou = 0.5;  // of a true opening and the best of the model's
constexpr double kOpeningRow_m = 0.001, kWallRow_m = 0.002;

/// Sum, sum of squares and worst of signed deviations.
struct Deviations {
  double n = 0, sum = 0, squares = 0, worst = 0;
  void add(double d) {
    n += 1, sum += d, squares += d * d;
    worst = std::max(worst, std::fabs(d));
  }
  double bias() const { return n > 0 ? sum / n : 0; }
  double rms() const { return n > 0 ? std::sqrt(squares / n) : 0; }
  Deviations& operator+=(const Deviations& o) {
    n += o.n, sum += o.sum, squares += o.squares;
    worst = std::max(worst, o.worst);
    return *this;
  }
};

enum Axis { kAlong, kUp, kOut, kWider, kTaller, kAxes };
constexpr const char* kAxisNames[kAxes] = {"along", "up", "out", "wider", "taller"};

using AxisDeviations = std::array<Deviations, kAxes>;
inline void add(AxisDeviations& sum, const AxisDeviations& more) {
  for (size_t a = 0; a < kAxes; ++a) sum[a] += more[a];
}

struct WallFigures {
  size_t openings = 0, found = 0, invented = 0, copied = 0;
  Areas walls, fillings;  ///< a: the model's, b: the truth's
  size_t corners = 0, paired = 0;
  /// Model - truth of the corners of openings and of the walls' outlines; wider, taller: away from the ring's middle.
  AxisDeviations openings_m, outlines_m;
  AxisDeviations vertices_m() const {
    AxisDeviations all = openings_m;
    add(all, outlines_m);
    return all;
  }
  size_t heads = 0, arcs = 0;
  Deviations centre_m, radius_m;
  std::string notes;  ///< openings missed and invented

  /// Walls with their openings, weighted by area.
  double completeness() const {
    return (walls.both_m2 + fillings.both_m2) / (walls.b_m2 + fillings.b_m2);
  }
  double correctness() const {
    const double all = walls.a_m2 + fillings.a_m2;
    return all > 0 ? (walls.both_m2 + fillings.both_m2) / all : 0;
  }
  double found_share() const {
    return openings > 0 ? static_cast<double>(found) / static_cast<double>(openings) : 1;
  }

  WallFigures& operator+=(const WallFigures& o) {
    openings += o.openings, found += o.found, invented += o.invented, copied += o.copied;
    walls += o.walls, fillings += o.fillings;
    corners += o.corners, paired += o.paired;
    add(openings_m, o.openings_m);
    add(outlines_m, o.outlines_m);
    heads += o.heads, arcs += o.arcs;
    centre_m += o.centre_m, radius_m += o.radius_m;
    notes += o.notes;
    return *this;
  }
};

inline std::string text_of_extent(const Region& region) {
  const Extent2 e = extent_of(region);
  std::ostringstream out;
  out.precision(3);
  out << std::fixed << "u " << e.low.u << ".." << e.high.u << ", v " << e.low.v << ".." << e.high.v;
  return out.str();
}

/// Corners one to one, the nearest pairs first, at most this far apart.
inline void compare_corners(const std::vector<const Drawn*>& found, const Drawn& truth,
                            double reach_m, AxisDeviations& deviations_m, WallFigures& out) {
  struct Candidate {
    double distance_m;
    size_t mine, ring, corner;
  };
  std::vector<Candidate> pairs;
  for (size_t i = 0; i < truth.corners.size(); ++i)
    for (size_t r = 0; r < found.size(); ++r)
      for (size_t k = 0; k < found[r]->corners.size(); ++k) {
        const Vec2 d = found[r]->corners[k] - truth.corners[i];
        if (std::hypot(d.u, d.v) <= reach_m) pairs.push_back({std::hypot(d.u, d.v), i, r, k});
      }
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& a, const auto& b) { return a.distance_m < b.distance_m; });
  std::vector<bool> taken(truth.corners.size(), false);
  std::vector<std::vector<bool>> used;
  for (const Drawn* ring : found) used.emplace_back(ring->corners.size(), false);
  const Extent2 box = extent_of(truth.region);
  out.corners += truth.corners.size();
  for (const Candidate& c : pairs) {
    if (taken[c.mine] || used[c.ring][c.corner]) continue;
    taken[c.mine] = used[c.ring][c.corner] = true;
    ++out.paired;
    const Vec2 t = truth.corners[c.mine], d = found[c.ring]->corners[c.corner] - t;
    deviations_m[kAlong].add(d.u);
    deviations_m[kUp].add(d.v);
    deviations_m[kOut].add(found[c.ring]->heights_m[c.corner]);
    deviations_m[kWider].add(t.u > (box.low.u + box.high.u) / 2 ? d.u : -d.u);
    deviations_m[kTaller].add(t.v > (box.low.v + box.high.v) / 2 ? d.v : -d.v);
  }
}

/// The model's arc of most sagitta against the true head.
inline void compare_head(const Drawn& found, const Drawn& truth, WallFigures& out) {
  for (const Curve& head : truth.arcs) {
    ++out.heads;
    const Curve* best = nullptr;
    for (const Curve& arc : found.arcs)
      if (best == nullptr || arc.sagitta_m > best->sagitta_m) best = &arc;
    if (best == nullptr) continue;
    ++out.arcs;
    out.centre_m.add(std::hypot(best->centre.u - head.centre.u, best->centre.v - head.centre.v));
    out.radius_m.add(best->radius_m - head.radius_m);
  }
}

/// `also_true`: openings that need not be found but may be.
inline WallFigures compare_wall(const Wall& found, const Wall& truth, const Region& also_true,
                                double reach_m) {
  WallFigures out;
  out.walls = areas(found.region, truth.region, kWallRow_m);
  std::vector<bool> is_true(found.openings.size(), false);
  std::vector<const Drawn*> outlines;
  for (const Drawn& o : found.outlines) outlines.push_back(&o);
  for (const Drawn& o : truth.outlines) compare_corners(outlines, o, reach_m, out.outlines_m, out);
  for (const Drawn& opening : truth.openings) {
    const Extent2 place = extent_of(opening.region);
    Areas best{};
    size_t which = 0;
    for (size_t i = 0; i < found.openings.size(); ++i) {
      if (!place.meets(extent_of(found.openings[i].region))) continue;
      const Areas a = areas(found.openings[i].region, opening.region, kOpeningRow_m);
      if (a.iou() > best.iou()) best = a, which = i;
    }
    ++out.openings;
    out.fillings.b_m2 += areas(opening.region, opening.region, kOpeningRow_m).a_m2;
    if (best.iou() < kFoundIou) {
      out.notes +=
          "\n  missed " + text_of_extent(opening.region) + ", IoU " + std::to_string(best.iou());
      compare_corners({}, opening, reach_m, out.openings_m, out);
      out.heads += opening.arcs.size();
      continue;
    }
    ++out.found;
    is_true[which] = true;
    out.copied += found.openings[which].evidence == Evidence::kCopied;
    out.fillings.both_m2 += best.both_m2;
    compare_corners({&found.openings[which]}, opening, reach_m, out.openings_m, out);
    compare_head(found.openings[which], opening, out);
  }
  for (size_t i = 0; i < found.openings.size(); ++i) {
    double best = 0;
    for (const Shape& shape : also_true)
      best = std::max(best, areas(found.openings[i].region, {shape}, kOpeningRow_m).iou());
    if (!is_true[i] && best >= kFoundIou) continue;
    out.fillings.a_m2 +=
        areas(found.openings[i].region, found.openings[i].region, kOpeningRow_m).a_m2;
    if (is_true[i]) continue;
    ++out.invented;
    out.notes += "\n  invented " + text_of_extent(found.openings[i].region);
  }
  return out;
}

inline std::string text_of(const WallFigures& f, double spacing_m) {
  std::ostringstream out;
  out.precision(4);
  out << f.found << " of " << f.openings << " openings (" << f.copied << " copied), " << f.invented
      << " invented; completeness " << f.completeness() << ", correctness " << f.correctness()
      << "; " << f.paired << " of " << f.corners << " vertices, in spacings of " << 1000 * spacing_m
      << " mm:";
  const auto tell = [&](const char* what, const AxisDeviations& d) {
    out << what;
    for (size_t a = 0; a < kAxes; ++a)
      out << " " << kAxisNames[a] << " RMS " << d[a].rms() / spacing_m << " bias "
          << d[a].bias() / spacing_m << (a + 1 < kAxes ? "," : ";");
  };
  tell(" all", f.vertices_m());
  tell(" openings alone", f.openings_m);
  out << " " << f.arcs << " of " << f.heads << " heads as arcs, centre RMS "
      << f.centre_m.rms() / spacing_m << " worst " << f.centre_m.worst / spacing_m
      << ", radius RMS " << f.radius_m.rms() / spacing_m << " worst "
      << f.radius_m.worst / spacing_m << f.notes;
  return out.str();
}

}  // namespace jalon::test
