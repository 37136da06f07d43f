// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What the stations see of walls and openings: beams towards places of the walls' planes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "geometry/polygon2.h"
#include "scan/builder/contour.h"
#include "scan/grammar/truth.h"
#include "spatial/triangles/tree.h"

namespace jalon::grammar {

namespace {

constexpr double kOutlineStep_m = 0.05, kBesideOutline_m = 0.01;
constexpr int kAreaSamples = 12;  // along each side of an opening

Outline outline_of(const TruthContour& contour) {
  Contour out;
  for (const TruthCorner& c : contour) out.push_back({c.at, c.sagitta_m});
  return chords_of(out);
}

/// The triangles that stop beams: all but glass.
std::vector<std::array<uint32_t, 3>> opaque_triangles(const Model& model) {
  std::unordered_set<uint32_t> glass;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == "glass") glass.insert(face.id);
  std::vector<std::array<uint32_t, 3>> out;
  for (size_t t = 0; t < model.triangles.size(); ++t)
    if (!glass.contains(model.triangle_faces[t])) out.push_back(model.triangles[t]);
  return out;
}

class Eyes {
 public:
  Eyes(const Model& model, const SceneSurvey& survey, Task& task)
      : survey_(survey),
        tree_(TriangleTree::build(model.vertices, opaque_triangles(model), task)) {}

  struct View {
    Sight state = Sight::kNever;
    double points_per_m2 = 0;
  };
  /// Of a place of the wall's plane by all stations.
  View of(const TruthWall& wall, const Vec2& place) const {
    View out;
    const Vec3 p =
        wall.origin + wall.along * place.u + wall.up * place.v + wall.normal * kAttached_m;
    for (const ScanStation& station : survey_.stations) {
      const Vec3 eye = station.pose.translation(), way = p - eye;
      const double range = norm(way), cosine = -dot(way, wall.normal) / range;
      if (!(cosine > 0) || !has_beam(station, way)) continue;
      if (tree_->occluded({eye, way, 0, 1})) {
        if (out.state == Sight::kNever) out.state = Sight::kHidden;
        continue;
      }
      out.state = Sight::kSeen;
      const double level = std::sqrt(way.x * way.x + way.y * way.y) / range;
      out.points_per_m2 += cosine / (range * range * level * survey_.scanner.horizontal_step_rad *
                                     survey_.scanner.vertical_step_rad);
    }
    return out;
  }

 private:
  bool has_beam(const ScanStation& station, const Vec3& way) const {
    const StaticSettings& s = survey_.scanner;
    const double range = norm(way);
    if (!(range >= s.min_range_m && range <= s.max_range_m)) return false;
    const Vec3 d = inverse(station.pose).direction(way);
    const double up = std::asin(std::clamp(d.z / range, -1.0, 1.0));
    double turn = std::atan2(d.x, d.y);
    if (turn < s.horizontal_from_rad) turn += 2 * std::numbers::pi;
    return turn <= s.horizontal_to_rad && up >= s.vertical_from_rad && up <= s.vertical_to_rad;
  }

  const SceneSurvey& survey_;
  std::shared_ptr<const TriangleTree> tree_;
};

struct Ground {
  Outline outline;
  std::vector<Outline> holes;
  bool has(const Vec2& p) const {
    return contains(outline, p) &&
           std::none_of(holes.begin(), holes.end(), [&](const auto& h) { return contains(h, p); });
  }
};

/// The raster of one wall and its shares.
void look_at_wall(const Eyes& eyes, const std::vector<Outline>& openings, TruthWall& wall,
                  Task& task) {
  // 1. Its cells.
  const Ground own{outline_of(wall.outline), openings};
  std::vector<Ground> covers;
  for (const TruthWall::Cover& cover : wall.covers) {
    covers.push_back({outline_of(cover.outline), {}});
    for (const TruthContour& hole : cover.holes) covers.back().holes.push_back(outline_of(hole));
  }
  SightRaster& raster = wall.raster;
  Vec2 low = own.outline[0], high = low;
  for (const Vec2& p : own.outline) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  raster.low = low;
  raster.columns = static_cast<uint32_t>(std::ceil((high.u - low.u) / raster.cell_m));
  raster.rows = static_cast<uint32_t>(std::ceil((high.v - low.v) / raster.cell_m));
  // 2. What is seen of each cell's middle.
  double count[3] = {0, 0, 0};
  for (uint32_t j = 0; j < raster.rows; ++j) {
    task.checkpoint(static_cast<double>(j) / raster.rows);
    for (uint32_t i = 0; i < raster.columns; ++i) {
      const Vec2 p = low + Vec2{(i + 0.5) * raster.cell_m, (j + 0.5) * raster.cell_m};
      const auto is_in = [&](const auto& ground) { return ground.has(p); };
      Sight state = Sight::kOutside;
      if (std::any_of(openings.begin(), openings.end(),
                      [&](const Outline& o) { return contains(o, p); }))
        state = Sight::kOpening;
      else if (!own.has(p)) state = Sight::kOutside;
      else if (std::any_of(covers.begin(), covers.end(), is_in)) state = Sight::kCovered;
      else state = eyes.of(wall, p).state;
      raster.cells.push_back(state);
      count[0] += state == Sight::kSeen;
      count[1] += state == Sight::kHidden;
      count[2] += state == Sight::kNever;
    }
  }
  const double all = count[0] + count[1] + count[2];
  if (!(all > 0)) return;
  wall.seen_share = count[0] / all;
  wall.hidden_share = count[1] / all;
  wall.never_share = count[2] / all;
}

void look_at_opening(const Eyes& eyes, const TruthWall& wall, const Outline& outline,
                     TruthOpening& opening) {
  // 1. Along the contour, a little outside; its foot on the ground is no edge.
  double seen = 0, all = 0;
  for (size_t k = 0; k < outline.size(); ++k) {
    const Vec2 a = outline[k], b = outline[(k + 1) % outline.size()], d = b - a;
    const double length = norm(d);
    if (opening.touches_ground && a.v == 0 && b.v == 0) continue;
    const int pieces = std::max(1, static_cast<int>(length / kOutlineStep_m));
    const Vec2 right = Vec2{d.v, -d.u} * (kBesideOutline_m / length);
    for (int i = 0; i < pieces; ++i) {
      const bool is_seen =
          eyes.of(wall, a + d * ((i + 0.5) / pieces) + right).state == Sight::kSeen;
      all += length / pieces;
      seen += is_seen ? length / pieces : 0;
    }
  }
  opening.outline_seen_share = all > 0 ? seen / all : 0;
  // 2. Its area, and the points there.
  Vec2 low = outline[0], high = low;
  for (const Vec2& p : outline) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  double inside = 0, passed = 0, density = 0;
  for (int j = 0; j < kAreaSamples; ++j)
    for (int i = 0; i < kAreaSamples; ++i) {
      const Vec2 p = low + Vec2{(high.u - low.u) * (i + 0.5) / kAreaSamples,
                                (high.v - low.v) * (j + 0.5) / kAreaSamples};
      if (!contains(outline, p)) continue;
      const Eyes::View view = eyes.of(wall, p);
      inside += 1;
      passed += view.state == Sight::kSeen;
      density += view.points_per_m2;
    }
  if (inside > 0) opening.area_seen_share = passed / inside;
  if (!(density > 0)) return;
  opening.spacing_m = std::sqrt(passed / density);
  opening.width_spacings = std::min(high.u - low.u, high.v - low.v) / opening.spacing_m;
}

}  // namespace

void look(const Model& model, const SceneSurvey& survey, FacadeTruth& truth, Task& task) {
  const Eyes eyes(model, survey, task);
  std::vector<std::vector<Outline>> openings(truth.walls.size());
  for (TruthOpening& o : truth.openings) {
    const Outline outline = outline_of(o.contour);
    task.checkpoint(0);
    look_at_opening(eyes, truth.walls[o.wall], outline, o);
    openings[o.wall].push_back(outline);
  }
  for (size_t w = 0; w < truth.walls.size(); ++w)
    look_at_wall(eyes, openings[w], truth.walls[w], task);
}

}  // namespace jalon::grammar
