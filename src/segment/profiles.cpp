// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/plane_rows.h"
#include "segment/profile_settings.h"
#include "segment/profiles/rectangles.h"
#include "segment/profiles/slices.h"
#include "segment/settle/assignment.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"
#include "segment/settle/merging.h"
#include "segment/surface/spacing.h"

namespace jalon {

namespace {

constexpr double kSpacingsPerStep = 5, kTolerancesPerStep = 4;  // steps of step_m = 0
constexpr double kSpacingsPerSlice = 2.5;  // thickness: a profile has some points each spacing
constexpr double kSpacingsPerGap = 4;      // "3 to 5 spacings"
constexpr double kSpacingsPerNode = 1.2;   // below it nodes stand behind each other in the noise

constexpr auto kProfileLeast = plane_least_rows("profiles");
constexpr auto kProfilePixel = plane_pixel_rows("profiles");
constexpr auto kProfileEnding = plane_ending_rows("profiles");

constexpr auto kProfileRows = setting_rows(
    nested_rows<&ProfileSettings::surface, kProfileLeast>(),
    choice_row<&ProfileSettings::axes>(
        "axes", "xyz|z|direction", "profiles",
        "Along what the cloud is cut: all three axes, heights alone, which miss what is level, or "
        "the given direction."),
    doubles_row<&ProfileSettings::direction>("direction", -1, 1, "1", "profiles",
                                             "Direction of axes = direction: x, y, z."),
    number_row<&ProfileSettings::step_m>(
        "step_m", 0, 1000, "m", "profiles",
        "From slice to slice; 0 = five times the point spacing, at least four tolerances. A plane "
        "needs three slices."),
    number_row<&ProfileSettings::thickness_m>(
        "thickness_m", 0, 1000, "m", "profiles",
        "Thickness of a slice, at most step_m; 0 = two and a half times the point spacing."),
    number_row<&ProfileSettings::gap_m>(
        "gap_m", 0, 100, "m", "profiles",
        "Gap at which a profile breaks off; 0 = four times the point spacing."),
    number_row<&ProfileSettings::line_tolerance_m>(
        "line_tolerance_m", 0, 10, "m", "profiles",
        "Largest distance of a profile from its straight pieces; 0 = distance_tolerance_m."),
    number_row<&ProfileSettings::angle_rad>(
        "angle_rad", 0.001, 0.785398, "rad", "profiles",
        "Largest angle between the lines of two slices that make a rectangle, and between two "
        "rectangles of a plane; 0.175 = 10 degrees."),
    nested_rows<&ProfileSettings::surface, kProfilePixel>(),
    nested_rows<&ProfileSettings::surface, kProfileEnding>());

std::vector<Vec3> axes_of(const ProfileSettings& settings) {
  if (settings.axes == ProfileAxes::kXyz) return {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  if (settings.axes == ProfileAxes::kZ) return {{0, 0, 1}};
  const std::vector<double>& d = settings.direction;
  const Vec3 n = d.size() == 3 ? normalized({d[0], d[1], d[2]}) : Vec3{};
  if (!(squared_norm(n) > 0.5))
    fail(Status::kInvalidArgument, "direction must be three numbers x, y, z, not all 0");
  return {n};
}

SliceRule slice_rule(const ProfileSettings& settings, double spacing_m) {
  const double tolerance = settings.surface.distance_tolerance_m;
  const auto own = [](double given, double otherwise) { return given > 0 ? given : otherwise; };
  SliceRule rule;
  rule.step_m =
      own(settings.step_m, std::max(kSpacingsPerStep * spacing_m, kTolerancesPerStep * tolerance));
  rule.thickness_m = own(settings.thickness_m, kSpacingsPerSlice * spacing_m);
  rule.cell_m = std::max(kSpacingsPerNode * spacing_m, tolerance);
  rule.gap_m = std::max(own(settings.gap_m, kSpacingsPerGap * spacing_m), rule.cell_m);
  rule.tolerance_m = own(settings.line_tolerance_m, tolerance);
  return rule;
}

// A set of lines as a surface that reaches from slice to slice; without points when it is no plane.
Surface surface_of(const SegmentScene& scene, std::span<const ProfileLine> lines,
                   const ProfileSet& set, double step_m, Task& task) {
  Surface surface;
  for (const uint32_t line : set.lines) {
    const auto& own = lines[line].positions;
    surface.positions.insert(surface.positions.end(), own.begin(), own.end());
  }
  std::sort(surface.positions.begin(), surface.positions.end());
  PlaneFit fit;
  if (surface.positions.size() < 3 || !fit_plane(set.moments, fit) ||
      !wide_enough(scene.settings, fit) || too_rough(scene.settings, fit.sigma)) {
    surface.positions = {};
    return surface;
  }
  surface.plane = fit.plane;
  surface.sigma_m = fit.sigma;
  surface.pixel_m = step_m;
  surface.area_m2 =
      occupied_area_m2(bounded_raster(flat_points(scene, surface, task), step_m, 0, task));
  return surface;
}

void cut_along(const SegmentScene& scene, const SliceRule& slices, const ProfileSettings& settings,
               std::vector<Surface>& surfaces, Task& task) {
  const std::vector<ProfileLine> lines = profile_lines(scene, slices, task);
  const RectangleRule rule{slices.step_m, settings.angle_rad,
                           settings.surface.distance_tolerance_m};
  const std::vector<ProfileRectangle> rectangles = match_lines(lines, rule, task);
  const auto sets = join_rectangles(lines, rectangles, rule, task);
  std::vector<Surface> found(sets.size());
  parallel_for(task, sets.size(), 1, [&](size_t s, size_t) {
    found[s] = surface_of(scene, lines, sets[s], slices.step_m, task);
  });
  for (Surface& surface : found)
    if (!surface.positions.empty()) surfaces.push_back(std::move(surface));
}

}  // namespace

std::span<const ParamRow> profile_rows() { return kProfileRows; }

// Successive profiles (the third of three methods for planes compared in France in 2006): 1. slices along each axis,
// their points moved into the slice's plane along the surface about them, chained and simplified to lines; 2. lines of
// neighbouring slices matched to rectangles; 3. rectangles grown to planes; 4. those of all axes joined, the points
// between the slices taken; 5. points shared out among all planes, last fit.
Segmentation segment_by_profiles(const CloudPtr& cloud, const ProfileSettings& settings,
                                 Task& task) {
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0, 0.3, "indexing");
    return scene_with_cells(*cloud, settings.surface, task);
  }();
  std::vector<Surface> surfaces;
  const std::vector<Vec3> axes = axes_of(settings);
  SliceRule rule = slice_rule(settings, median_spacing_m(scene));
  for (size_t k = 0; k < axes.size(); ++k) {
    const double part = 0.3 / static_cast<double>(axes.size());
    ProgressSpan span(task, 0.3 + part * static_cast<double>(k),
                      0.3 + part * static_cast<double>(k + 1), "cutting profiles");
    rule.axis = axes[k];
    cut_along(scene, rule, settings, surfaces, task);
  }
  {
    ProgressSpan span(task, 0.6, 0.7, "taking points");
    merge_coplanar(scene, surfaces, task);
    assign_points(scene, surfaces, task);
    surfaces = surfaces_of_owners(scene, static_cast<uint32_t>(surfaces.size()), task);
  }
  ProgressSpan span(task, 0.7, 1, "sharing out points");
  Segmentation out = settled_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(profile_rows(), settings);
  return out;
}

}  // namespace jalon
