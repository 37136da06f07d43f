// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/settings.h"

#include <cmath>
#include <numbers>
#include <string>

#include "registration/icp/icp.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    choice_row("metric", "point_to_plane", "point_to_point|point_to_plane|plane_to_plane", "",
               "What is made small: distances of points (Besl & McKay 1992), of points from local planes (Chen & "
               "Medioni 1992), or of local planes from each other (Segal et al. 2009)"),
    choice_row("kernel", "tukey", "none|tukey|cauchy|huber", "",
               "Weight of large residuals; its scale is the median of their absolute values"),
    number_row("max_distance_m", 0, 0, 1e6, "m", "",
               "Residuals above this make no pair at the start; it shrinks by a fifth each iteration, down to three "
               "times the noise; 0 = three times the median distance at the start"),
    number_row("min_distance_m", 0, 0, 1e6, "m", "",
               "Where that distance stops shrinking; 0 = at three times the noise of both clouds"),
    number_row("trim_percent", 0, 0, 90, "%", "", "Share of the pairs, those with the largest residuals, left out"),
    number_row("max_angle_rad", std::numbers::pi / 4, 0, std::numbers::pi / 2, "rad", "",
               "Largest angle between the normals of a pair"),
    number_row("min_overlap_percent", 10, 0, 100, "%", "",
               "Share of the moving points that must keep a pair; with less the registration stops and says so"),
    number_row("cell_m", 0, 0, 1e6, "m", "",
               "Edge of cubes that are thinned to one point each before all else; 0 = none, but where points lie in "
               "lines too far apart for their neighbours to span a plane, as those of spinning scanners do"),
    integer_row("k", 16, 6, 256, "points", "", "Neighbours of a local plane, the point itself included"),
    integer_row("max_iterations", 100, 1, 10000, "", "", "Most iterations, all levels together"),
    bool_row("coarse_to_fine", true, "", "Begin with a few thousand points of both clouds; false: all from the start"),
};

}  // namespace

std::span<const ParamRow> icp_rows() { return kRows; }

IcpSettings icp_settings(const ParamSet& params) {
  IcpSettings out;
  const std::string &metric = params.text("metric"), &kernel = params.text("kernel");
  out.metric = metric == "point_to_point"   ? IcpMetric::kPointToPoint
               : metric == "plane_to_plane" ? IcpMetric::kPlaneToPlane
                                            : IcpMetric::kPointToPlane;
  out.kernel = kernel == "none"     ? KernelKind::kNone
               : kernel == "cauchy" ? KernelKind::kCauchy
               : kernel == "huber"  ? KernelKind::kHuber
                                    : KernelKind::kTukey;
  out.max_distance_m = params.number("max_distance_m");
  out.min_distance_m = params.number("min_distance_m");
  out.trim = params.number("trim_percent") / 100;
  out.least_cosine = std::cos(params.number("max_angle_rad"));
  out.least_overlap = params.number("min_overlap_percent") / 100;
  out.neighbours = static_cast<uint32_t>(params.integer("k"));
  out.max_iterations = static_cast<int>(params.integer("max_iterations"));
  out.cell_m = params.number("cell_m");
  out.coarse_to_fine = params.flag("coarse_to_fine");
  return out;
}

}  // namespace jalon
