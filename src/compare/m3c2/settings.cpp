// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/settings.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "compare/m3c2/m3c2.h"

namespace jalon {

namespace {

// Origins: radii, depth and 5 points are what the programs around offer for building scans at some hundred points a
// square metre; Lague et al. ask for 25 times the roughness as normal scale and 20 points a cylinder.
constexpr ParamRow kRows[] = {
    choice_row("core_from", "reference", "reference|compared", "",
               "The cloud that gives the core points, where distances are measured, unless they are given."),
    number_row("core_spacing_m", 0, 0, 1e6, "m", "",
               "Edge of the grid cells that give one core point each, the original point nearest to the middle; 0 = "
               "every point is one. Not read for given core points."),
    choice_row("normals", "scale", "scale|vertical|horizontal|given", "",
               "scale: of the plane through the points around; vertical: (0, 0, 1); horizontal: that of scale laid "
               "into the horizontal; given: the field \"normal\" of the core points, as it is."),
    number_row("normal_radius_m", 0.25, 1e-6, 1e6, "m", "",
               "Radius of the ball of points that gives a normal; 20 to 25 times the roughness."),
    doubles_row("normal_radii_m", "", 1e-6, 1e6, "m", "",
                "Several such radii: each core point takes the one whose points are flattest. None = normal_radius_m."),
    choice_row("normals_from", "reference", "reference|compared|core", "",
               "The cloud whose points give the normals; core: the core points themselves."),
    choice_row("orientation", "automatic", "automatic|direction|station|point", "",
               "Turns normals to orientation_direction, to the station of the nearest point, or to viewpoint; "
               "automatic: station where each point has one with a pose, else direction."),
    doubles_row("orientation_direction", "0 0 1", -1e9, 1e9, "1", "", "The direction (x, y, z) to turn normals to."),
    doubles_row("viewpoint", "0 0 0", -1e9, 1e9, "m", "", "The point (x, y, z) to turn normals to."),
    number_row("cylinder_radius_m", 0.15, 1e-6, 1e6, "m", "", "Radius of the cylinders along the normals."),
    number_row("max_depth_m", 1, 1e-6, 1e6, "m", "",
               "Half-length of the cylinders: how far surfaces are looked for to either side of a core point."),
    choice_row("position", "median", "median|mean", "",
               "Where a surface lies along the normal: median (unmoved by outliers) or mean of its points."),
    choice_row("surfaces", "nearest", "nearest|all", "",
               "nearest: the points in a cylinder are told apart into surfaces; the one nearest to the core point is "
               "compared with the one nearest to it in the other cloud. all: all points make one surface."),
    number_row("surface_gap_m", 0, 0, 1e6, "m", "",
               "Points farther apart along the normal than this belong to two surfaces; 0 = a third of "
               "cylinder_radius_m. Surfaces rougher than that have 5 sigma instead."),
    integer_row("min_points", 5, 3, 1e6, "points", "",
                "Fewest points of a surface in a cylinder for a distance and its level of detection."),
    number_row("confidence", 0.95, 0.5, 0.9999, "1", "",
               "Share of unchanged places whose distance stays within the level of detection."),
    number_row("registration_error_m", 0, 0, 1e6, "m", "",
               "Standard error of the alignment, the same everywhere; joins the level as in Lague et al.: linearly."),
    doubles_row("registration_covariance", "", -1e9, 1e9, "", "",
                "36 numbers: covariance of the alignment's small rotation (rad) and translation (m), row-major, "
                "rotations first; none = not known. Joins the level in quadrature."),
    doubles_row("registration_centre", "0 0 0", -1e9, 1e9, "m", "",
                "The point (x, y, z) about which those rotations turn."),
    choice_row("precision_from", "spread", "spread|covariances", "",
               "What the points are worth: their spread about the surface, or the field \"covariance\" of both clouds "
               "(m2; 6: xx xy xz yy yz zz, or 9), which leaves roughness out."),
};

Vec3 vector_of(const ParamSet& params, const char* name) {
  const auto& v = params.numbers(name);
  if (v.size() != 3) fail(Status::kInvalidArgument, "%s has %zu numbers; it needs x, y, z", name, v.size());
  return {v[0], v[1], v[2]};
}

M3c2Settings::Source source_of(const std::string& text) {
  if (text == "core") return M3c2Settings::Source::kCore;
  return text == "compared" ? M3c2Settings::Source::kCompared : M3c2Settings::Source::kReference;
}

void read_normals(const ParamSet& params, M3c2Settings& s) {
  using Normals = M3c2Settings::Normals;
  using Orientation = M3c2Settings::Orientation;
  const std::string &kind = params.text("normals"), &turn = params.text("orientation");
  s.normals = kind == "vertical"     ? Normals::kVertical
              : kind == "horizontal" ? Normals::kHorizontal
              : kind == "given"      ? Normals::kGiven
                                     : Normals::kScale;
  s.orientation = turn == "direction" ? Orientation::kDirection
                  : turn == "station" ? Orientation::kStation
                  : turn == "point"   ? Orientation::kPoint
                                      : Orientation::kAutomatic;
  s.normals_from = source_of(params.text("normals_from"));
  s.normal_radii_m = params.numbers("normal_radii_m");
  if (s.normal_radii_m.empty()) s.normal_radii_m = {params.number("normal_radius_m")};
  std::sort(s.normal_radii_m.begin(), s.normal_radii_m.end());
  s.direction = vector_of(params, "orientation_direction");
  s.viewpoint = vector_of(params, "viewpoint");
}

void read_registration(const ParamSet& params, M3c2Settings& s) {
  s.registration_error_m = params.number("registration_error_m");
  const auto& covariance = params.numbers("registration_covariance");
  const Vec3 centre = vector_of(params, "registration_centre");
  if (covariance.empty()) return;
  if (covariance.size() != 36)
    fail(Status::kInvalidArgument, "registration_covariance has %zu numbers; it needs 36", covariance.size());
  for (size_t r = 0; r < 6; ++r) {
    if (!(covariance[7 * r] >= 0))
      fail(Status::kInvalidArgument, "registration_covariance: variance %zu is negative", r);
    for (size_t c = 0; c < r; ++c)
      if (std::fabs(covariance[6 * r + c] - covariance[6 * c + r]) >
          1e-9 * std::sqrt(covariance[7 * r] * covariance[7 * c]))
        fail(Status::kInvalidArgument, "registration_covariance is not symmetric at row %zu, column %zu", r, c);
  }
  s.registration.emplace(covariance, centre);
}

}  // namespace

std::span<const ParamRow> m3c2_rows() { return kRows; }

M3c2Settings m3c2_settings(const ParamSet& params) {
  M3c2Settings s;
  s.core_from = source_of(params.text("core_from"));
  s.core_spacing_m = params.number("core_spacing_m");
  read_normals(params, s);
  s.cylinder_radius_m = params.number("cylinder_radius_m");
  s.max_depth_m = params.number("max_depth_m");
  s.median = params.text("position") == "median";
  const double gap_m = params.number("surface_gap_m");
  if (params.text("surfaces") == "nearest") s.surface_gap_m = gap_m > 0 ? gap_m : s.cylinder_radius_m / 3;
  s.min_points = static_cast<uint32_t>(params.integer("min_points"));
  s.confidence = params.number("confidence");
  s.point_covariances = params.text("precision_from") == "covariances";
  read_registration(params, s);
  return s;
}

}  // namespace jalon
