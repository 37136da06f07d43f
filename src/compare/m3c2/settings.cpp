// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/settings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"

namespace jalon {

namespace {

// Origins: radii, depth and 5 points are what the programs around offer for building scans at some hundred points a
// square metre; Lague et al. ask for 25 times the roughness as normal scale and 20 points a cylinder.
using S = M3c2Settings;

constexpr auto kRows = setting_rows(
    choice_row<&S::core_from>(
        "core_from", "reference|compared", "",
        "The cloud that gives the core points, where distances are measured, unless they are "
        "given."),
    number_row<&S::core_spacing_m>(
        "core_spacing_m", 0, 1e6, "m", "",
        "Edge of the grid cells that give one core point each, the original point nearest to the "
        "middle; 0 = every point is one. Not read for given core points."),
    choice_row<&S::normals>(
        "normals", "scale|vertical|horizontal|given", "",
        "scale: of the plane through the points around; vertical: (0, 0, 1); horizontal: that of "
        "scale laid into the horizontal; given: the field \"normal\" of the core points, as it "
        "is."),
    number_row<&S::normal_radius_m>(
        "normal_radius_m", 1e-6, 1e6, "m", "",
        "Radius of the ball of points that gives a normal; 20 to 25 times the roughness."),
    doubles_row<&S::normal_radii_m>(
        "normal_radii_m", 1e-6, 1e6, "m", "",
        "Several such radii: each core point takes the one whose points are flattest. None = "
        "normal_radius_m."),
    choice_row<&S::normals_from>(
        "normals_from", "reference|compared|core", "",
        "The cloud whose points give the normals; core: the core points themselves."),
    choice_row<&S::orientation>(
        "orientation", "automatic|direction|station|point", "",
        "Turns normals to orientation_direction, to the station of the nearest point, or to "
        "viewpoint; automatic: station where each point has one with a pose, else direction."),
    doubles_row<&S::orientation_direction>("orientation_direction", -1e9, 1e9, "1", "",
                                           "The direction (x, y, z) to turn normals to."),
    doubles_row<&S::viewpoint>("viewpoint", -1e9, 1e9, "m", "",
                               "The point (x, y, z) to turn normals to."),
    number_row<&S::cylinder_radius_m>("cylinder_radius_m", 1e-6, 1e6, "m", "",
                                      "Radius of the cylinders along the normals."),
    number_row<&S::max_depth_m>(
        "max_depth_m", 1e-6, 1e6, "m", "",
        "Half-length of the cylinders: how far surfaces are looked for to either side of a core "
        "point."),
    choice_row<&S::position>(
        "position", "median|mean", "",
        "Where a surface lies along the normal: median (unmoved by outliers) or mean of its "
        "points."),
    choice_row<&S::surfaces>(
        "surfaces", "nearest|all", "",
        "nearest: the points in a cylinder are told apart into surfaces; the one nearest to the "
        "core point is compared with the one nearest to it in the other cloud. all: all points "
        "make one surface."),
    number_row<&S::surface_gap_m>(
        "surface_gap_m", 0, 1e6, "m", "",
        "Points farther apart along the normal than this belong to two surfaces; 0 = a third of "
        "cylinder_radius_m. Surfaces rougher than that have 5 sigma instead."),
    integer_row<&S::min_points>(
        "min_points", 3, 1e6, "points", "",
        "Fewest points of a surface in a cylinder for a distance and its level of detection."),
    number_row<&S::confidence>(
        "confidence", 0.5, 0.9999, "1", "",
        "Share of unchanged places whose distance stays within the level of detection."),
    number_row<&S::registration_error_m>(
        "registration_error_m", 0, 1e6, "m", "",
        "Standard error of the alignment, the same everywhere; joins the level as in Lague et "
        "al.: linearly."),
    doubles_row<&S::registration_covariance>(
        "registration_covariance", -1e9, 1e9, "", "",
        "36 numbers: covariance of the alignment's small rotation (rad) and translation (m), "
        "row-major, rotations first; none = not known. Joins the level in quadrature."),
    doubles_row<&S::registration_centre>("registration_centre", -1e9, 1e9, "m", "",
                                         "The point (x, y, z) about which those rotations turn."),
    choice_row<&S::precision_from>(
        "precision_from", "spread|covariances", "",
        "What the points are worth: their spread about the surface, or the field \"covariance\" "
        "of both clouds (m2; 6: xx xy xz yy yz zz, or 9), which leaves roughness out."));

void check_vector(const std::vector<double>& v, const char* name) {
  if (v.size() != 3)
    fail(Status::kInvalidArgument, "%s has %zu numbers; it needs x, y, z", name, v.size());
}

void check_covariance(const std::vector<double>& covariance) {
  if (covariance.empty()) return;
  if (covariance.size() != 36)
    fail(Status::kInvalidArgument, "registration_covariance has %zu numbers; it needs 36",
         covariance.size());
  for (size_t r = 0; r < 6; ++r) {
    if (!(covariance[7 * r] >= 0))
      fail(Status::kInvalidArgument, "registration_covariance: variance %zu is negative", r);
    for (size_t c = 0; c < r; ++c)
      if (std::fabs(covariance[6 * r + c] - covariance[6 * c + r]) >
          1e-9 * std::sqrt(covariance[7 * r] * covariance[7 * c]))
        fail(Status::kInvalidArgument,
             "registration_covariance is not symmetric at row %zu, column %zu", r, c);
  }
}

}  // namespace

std::span<const ParamRow> m3c2_rows() { return kRows; }

void use_registration_in_m3c2(std::span<const double> covariance36, const Vec3& centre,
                              ParamSet& params) {
  ParamSet values = params;
  values.set_numbers("registration_covariance", covariance36);
  values.set_numbers("registration_centre", std::array{centre.x, centre.y, centre.z});
  params = std::move(values);
}

void M3c2Settings::check() const {
  check_vector(orientation_direction, "orientation_direction");
  check_vector(viewpoint, "viewpoint");
  check_vector(registration_centre, "registration_centre");
  check_covariance(registration_covariance);
}

std::vector<double> M3c2Settings::radii_m() const {
  if (normal_radii_m.empty()) return {normal_radius_m};
  std::vector<double> radii = normal_radii_m;
  std::sort(radii.begin(), radii.end());
  return radii;
}

double M3c2Settings::gap_m() const {
  if (surfaces == Surfaces::kAll) return 0;
  return surface_gap_m > 0 ? surface_gap_m : cylinder_radius_m / 3;
}

std::optional<RigidUncertainty> M3c2Settings::registration() const {
  if (registration_covariance.empty()) return std::nullopt;
  const auto& c = registration_centre;
  return RigidUncertainty(registration_covariance, {c[0], c[1], c[2]});
}

}  // namespace jalon
