// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/change_outlines.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/setting_rows.h"
#include "cloud/statistics.h"
#include "compare/changes/diagnosis.h"
#include "compare/changes/point_discs.h"
#include "model/part_classes.h"
#include "modelling/contour/contour.h"
#include "modelling/plane/plane_frame.h"
#include "report/pages/zone_outlines.h"
#include "compare/landslide/cell_table.h"

namespace jalon {

namespace {

constexpr auto kChangeOutlinesRows = setting_rows(
    number_row<&ChangeOutlineSettings::max_edge_m>(
        "max_edge_m", 0, 1e6, "m", "",
        "Widest gap between points of one region that counts as surface; 0 = twice what joined its "
        "points"),
    number_row<&ChangeOutlineSettings::min_opening_area_m2>(
        "min_opening_area_m2", 0, 1e12, "m2", "",
        "Smaller holes in a region are closed; 0 = the square of the widest gap"));
// Cells that touch at a corner join points up to twice their edge apart, and so does the outline.
constexpr double kGapCells = 2;

const char* class_of(ChangeClass change) {
  switch (change) {
    case ChangeClass::kAppearance:
      return part_class::kAppearance;
    case ChangeClass::kDisappearance:
      return part_class::kDisappearance;
    case ChangeClass::kDisplacement:
    case ChangeClass::kDisplacementOverlap:
      return part_class::kDisplacement;
    case ChangeClass::kDeformation:
    case ChangeClass::kDeformationOverlap:
      return part_class::kDeformation;
  }
  return part_class::kRegion;
}

/// One region of one epoch.
struct Outlined {
  uint32_t region = 0, change = 0;
  std::vector<uint64_t> points;
};

std::span<const uint32_t> numbers_of(const FieldTable& table, const char* name, size_t rows) {
  const Column* column = table.find(name);
  if (column == nullptr) return {};
  if (column->info().type != ElementType::kUint32 || column->info().components != 1 ||
      column->count() != rows)
    fail(Status::kInvalidArgument,
         "column \"%s\" does not fit the comparison: %zu numbers of type uint32 are needed", name,
         rows);
  return column->values<uint32_t>();
}

std::vector<Outlined> regions_of(const ChangedCloud& epoch) {
  const size_t n = epoch.comparison->cloud->size();
  const auto labels = numbers_of(*epoch.points, "region", n),
             changes = numbers_of(*epoch.points, "change", n);
  if (labels.size() != n)
    fail(Status::kInvalidArgument,
         "the points have no column \"region\": hand over those of the regions or diagnosis");
  uint32_t most = 0;
  for (const uint32_t label : labels) most = std::max(most, label);
  if (most > n) fail(Status::kInvalidArgument, "region %u of a comparison of %zu points", most, n);
  std::vector<Outlined> out(most);
  for (size_t i = 0; i < n; ++i) {
    if (labels[i] == 0) continue;
    Outlined& one = out[labels[i] - 1];
    one.region = labels[i];
    if (!changes.empty() && one.change == 0) one.change = changes[i];
    one.points.push_back(i);
  }
  std::erase_if(out, [](const Outlined& one) { return one.points.empty(); });
  return out;
}

// The plane through the points, seen from above, or else from where x, or else y, grows to.
PlaneFit plane_of(const Cloud& cloud, const std::vector<uint64_t>& points) {
  Moments moments;
  moments.reference = cloud.point(points.front());
  for (const uint64_t i : points) moments.add(cloud.point(i));
  PlaneFit fit;
  if (!fit_plane(moments, fit)) {  // points in a line: a plane through it as level as can be
    const Eigen3 axes = symmetric_eigen(moments.covariance());
    const Vec3 along = axes.values[2] > 0 ? axes.vectors[2] : Vec3{1, 0, 0};
    const Vec3 up = Vec3{0, 0, 1} - along * along.z;
    fit.plane.normal = squared_norm(up) > 1e-6 ? normalized(up) : Vec3{1, 0, 0};
    fit.centroid = moments.centroid();
    fit.plane.offset = dot(fit.plane.normal, fit.centroid);
  }
  const Vec3& n = fit.plane.normal;
  constexpr double kUpright = 0.05;  // |n.z| below which a plane has no upper side
  const double side = std::fabs(n.z) > kUpright ? n.z : std::fabs(n.x) > std::fabs(n.y) ? n.x : n.y;
  if (side < 0) turn_over(fit);
  return fit;
}

// What stands for a region without a surface: the box around its points, a disc's radius wider.
ContourPiece box_around(const std::vector<Vec2>& points, double radius_m) {
  Vec2 low = points.front(), high = low;
  for (const Vec2& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  low = {low.u - radius_m, low.v - radius_m};
  high = {high.u + radius_m, high.v + radius_m};
  ContourPiece piece;
  piece.outline = {low, {high.u, low.v}, high, {low.u, high.v}};
  piece.area_m2 = (high.u - low.u) * (high.v - low.v);
  return piece;
}

class Outliner {
 public:
  Outliner(const Cloud& cloud, const Vec3& origin, const ChangeOutlineSettings& settings,
           Model& model, Task& task)
      : cloud_(cloud), origin_(origin), settings_(settings), model_(model), task_(task) {}

  void add(const Outlined& region, const std::string& name, const char* part_class) {
    const PlaneFit fit = plane_of(cloud_, region.points);
    const PlaneFrame frame = plane_frame(fit.plane, origin_, {1, 0, 0});
    std::vector<Vec2> flat;
    flat.reserve(region.points.size());
    for (const uint64_t i : region.points) flat.push_back(frame.project(cloud_.point(i)));
    const auto part = static_cast<uint32_t>(model_.parts.size());
    Part& made = model_.parts.emplace_back();
    made.name = name;
    made.part_class = part_class;
    made.parent = 0;
    made.evidence = Evidence::kMeasured;
    for (const ContourPiece& piece : pieces_of(region, flat))
      add_face(piece, frame, fit, part, region);
  }

 private:
  std::vector<ContourPiece> pieces_of(const Outlined& region, const std::vector<Vec2>& flat) {
    const std::vector<PointDisc> discs = point_discs(cloud_, region.points, task_);
    ContourSetting setting;
    setting.max_edge_m = settings_.max_edge_m;
    if (!(setting.max_edge_m > 0)) setting.max_edge_m = kGapCells * joining_distance(discs);
    setting.min_area_m2 = 0;
    setting.min_opening_width_m = 0;
    setting.min_opening_area_m2 = settings_.min_opening_area_m2;
    if (!(setting.min_opening_area_m2 > 0))
      setting.min_opening_area_m2 = setting.max_edge_m * setting.max_edge_m;
    std::vector<ContourPiece> pieces = extract_contour(flat, setting, task_).pieces;
    if (pieces.empty())
      pieces.push_back(box_around(flat, std::max(radius_quantile(discs, 0.5), 1e-6)));
    return pieces;
  }

  void add_face(const ContourPiece& piece, const PlaneFrame& frame, const PlaneFit& fit,
                uint32_t part, const Outlined& region) {
    Face face;
    face.part = part;
    face.id = region.change > 0 ? region.change : region.region;
    face.plane = fit.plane;
    face.sigma_m = fit.sigma;
    face.covariance = fit.covariance;
    face.area_m2 = piece.area_m2;
    std::vector<std::vector<Vec3>> rings;
    const auto add_ring = [&](const Chain& chain) {
      auto& corners = rings.emplace_back();
      for (const Vec2& p : chain) corners.push_back(frame.lift(p));
    };
    add_ring(piece.outline);
    for (const Chain& opening : piece.openings) add_ring(opening);
    const size_t made = model_.add_face(face, rings);
    // Holes of a region are not openings of a wall: they stay with it.
    const Face& added = model_.faces[made];
    for (uint64_t r = 0; r < added.ring_count; ++r) model_.rings[added.first_ring + r].part = part;
  }

  const Cloud& cloud_;
  const Vec3 origin_;
  const ChangeOutlineSettings& settings_;
  Model& model_;
  Task& task_;
};

// Of what moved or bent, where it was and where it is now.
std::string class_in(const Outlined& region, const FieldTable* changes, bool is_before) {
  if (changes == nullptr || region.change == 0) return part_class::kRegion;
  const Column& column = changes->require("class");
  if (region.change > column.count())
    fail(Status::kInvalidArgument, "the changes have no row %u", region.change);
  const auto change = static_cast<ChangeClass>(column.number(region.change - 1));
  const std::string name = class_of(change);
  const bool is_both = change >= ChangeClass::kDisplacement;
  return is_both ? name + (is_before ? "_before" : "_after") : name;
}

}  // namespace

std::span<const ParamRow> change_outlines_rows() { return kChangeOutlinesRows; }

Model change_outlines(const ChangedCloud& after, const ChangedCloud& before,
                      const FieldTable* changes, const ChangeOutlineSettings& settings,
                      Task& task) {
  Model model;
  model.crs = after.comparison->cloud->crs;
  Part& root = model.parts.emplace_back();
  root.name = "changes";
  root.part_class = part_class::kChanges;
  if (is_landslide(*after.comparison) && after.points->find("change") == nullptr) {
    add_zone_outlines(*after.comparison, *after.points, 0, model);
    return model;
  }
  const Vec3 origin = local_origin(*after.comparison->cloud, task);
  for (const ChangedCloud* epoch : {&after, &before}) {
    if (epoch->comparison == nullptr) continue;
    const bool is_before = epoch == &before;
    const std::vector<Outlined> regions = regions_of(*epoch);
    Outliner outliner(*epoch->comparison->cloud, origin, settings, model, task);
    for (size_t i = 0; i < regions.size(); ++i) {
      std::string name =
          regions[i].change > 0 ? "change " + std::to_string(regions[i].change) + " " : "";
      name += "region " + std::to_string(regions[i].region);
      if (before.comparison != nullptr) name += is_before ? " before" : " after";
      outliner.add(regions[i], name, class_in(regions[i], changes, is_before).c_str());
      task.checkpoint(static_cast<double>(i + 1) / static_cast<double>(regions.size()));
    }
  }
  return model;
}

}  // namespace jalon
