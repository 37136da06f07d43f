// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/zone_outlines.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "compare/landslide/cell_rings.h"
#include "geometry/plane.h"
#include "geometry/polygon2.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

// Fewer cells without a measurement are the gaps between the lines of a scan.
constexpr size_t kFewestUnmeasured = 4;
constexpr double kLeastCosine = 0.05;  // between the plane of a piece and the direction

PlaneFit plane_of_cells(const Comparison& comparison, const CellTable& cells,
                        const CellPiece& piece) {
  Moments moments;
  moments.reference = comparison.cloud->point(piece.rows.front());
  for (const uint32_t row : piece.rows) moments.add(comparison.cloud->point(row));
  PlaneFit fit;
  const bool is_plane = fit_plane(moments, fit);
  if (is_plane && dot(fit.plane.normal, cells.up) < 0) turn_over(fit);
  if (is_plane && dot(fit.plane.normal, cells.up) > kLeastCosine) return fit;
  fit = {};  // cells in a row, or a face that is looked along: across the direction
  fit.centroid = moments.centroid();
  fit.plane = {cells.up, dot(cells.up, fit.centroid)};
  return fit;
}

class ZoneOutliner {
 public:
  ZoneOutliner(const Comparison& comparison, uint32_t root, Model& model)
      : comparison_(comparison), cells_(comparison), root_(root), model_(model) {}

  const CellTable& cells() const { return cells_; }

  void add(const std::string& name, const char* part_class, uint32_t id,
           const std::vector<CellPiece>& pieces) {
    if (pieces.empty()) return;
    const auto part = static_cast<uint32_t>(model_.parts.size());
    Part& made = model_.parts.emplace_back();
    made.name = name;
    made.part_class = part_class;
    made.parent = root_;
    made.evidence = Evidence::kMeasured;
    for (const CellPiece& piece : pieces) add_face(piece, part, id);
  }

 private:
  Vec3 on_plane(const Vec2& p, const Plane& plane) const {
    const Vec3 foot = cells_.first + cells_.u * p.u + cells_.v * p.v;
    return foot - cells_.up * (plane.distance(foot) / dot(plane.normal, cells_.up));
  }

  void add_face(const CellPiece& piece, uint32_t part, uint32_t id) {
    const PlaneFit fit = plane_of_cells(comparison_, cells_, piece);
    const double slant = dot(fit.plane.normal, cells_.up);
    Face face;
    face.part = part;
    face.id = id;
    face.plane = fit.plane;
    face.sigma_m = fit.sigma;
    face.covariance = fit.covariance;
    face.area_m2 = signed_area(piece.outline) / slant;
    std::vector<std::vector<Vec3>> rings;
    const auto add_ring = [&](const std::vector<Vec2>& ring) {
      auto& corners = rings.emplace_back();
      for (const Vec2& p : ring) corners.push_back(on_plane(p, fit.plane));
    };
    add_ring(piece.outline);
    for (const auto& opening : piece.openings) {
      add_ring(opening);
      face.area_m2 += signed_area(opening) / slant;
    }
    const size_t made = model_.add_face(face, rings);
    const Face& added = model_.faces[made];
    for (uint64_t r = 0; r < added.ring_count; ++r) model_.rings[added.first_ring + r].part = part;
  }

  const Comparison& comparison_;
  const CellTable cells_;
  const uint32_t root_;
  Model& model_;
};

std::span<const uint32_t> regions_column(const FieldTable& points, size_t rows) {
  const Column* column = points.find("region");
  if (column == nullptr || column->info().type != ElementType::kUint32 ||
      column->info().components != 1 || column->count() != rows)
    fail(Status::kInvalidArgument,
         "the points have no column \"region\" of %zu numbers: hand over those of the regions",
         rows);
  return column->values<uint32_t>();
}

}  // namespace

void add_zone_outlines(const Comparison& comparison, const FieldTable& points, uint32_t root,
                       Model& model) {
  ZoneOutliner outliner(comparison, root, model);
  const CellTable& cells = outliner.cells();
  const auto regions = regions_column(points, cells.size());
  uint32_t most = 0;
  for (const uint32_t region : regions) most = std::max(most, region);
  if (most > cells.size())
    fail(Status::kInvalidArgument, "region %u of a comparison of %zu points", most, cells.size());
  std::vector<double> moved(most + size_t{1}, 0);
  for (size_t i = 0; i < cells.size(); ++i)
    if (std::isfinite(cells.distance[i])) moved[regions[i]] += cells.distance[i];
  for (uint32_t region = 1; region <= most; ++region)
    outliner.add("region " + std::to_string(region),
                 moved[region] < 0 ? part_class::kDepletion : part_class::kAccumulation, region,
                 cell_pieces(
                     cells, [&](size_t row) { return regions[row] == region; }, 1));
  const auto unmeasured = [&](bool before, bool after) {
    return cell_pieces(
        cells,
        [&](size_t row) {
          return (cells.reference_status[row] != 0) == before &&
                 (cells.compared_status[row] != 0) == after;
        },
        kFewestUnmeasured);
  };
  outliner.add("not measured in the reference", part_class::kUnmeasured, 0,
               unmeasured(true, false));
  outliner.add("not measured in the compared epoch", part_class::kUnmeasured, 0,
               unmeasured(false, true));
  outliner.add("not measured in either epoch", part_class::kUnmeasured, 0, unmeasured(true, true));
}

}  // namespace jalon
