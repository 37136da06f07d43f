// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/facade.h"

#include "modelling/edges/join/vectorise.h"
#include "modelling/facade/assembly.h"
#include "modelling/facade/plan.h"

namespace jalon {

namespace {

constexpr std::array kFacadeRows{
    number_row("min_wall_area_m2", 4, 0, 1e9, "m2", "",
               "Smallest area of a wall, its openings not taken off; smaller upright planes are elements"),
    number_row("min_wall_width_m", 1, 0, 1e6, "m", "",
               "Smallest width (full, not half) of a wall; narrower upright planes are sides of posts and reveals"),
    number_row("min_facade_share", 0.05, 0, 1, "1", "",
               "Smallest area of a facade's main wall, as a share of the largest wall's; smaller ones are elements"),
    number_row("min_facade_height_m", 2, 0, 1000, "m", "", "Smallest height of a facade's main wall"),
    number_row("facade_depth_m", 2.5, 0, 1000, "m", "",
               "Parallel walls belong to a facade up to this distance before and behind its main wall"),
    number_row("facade_gap_m", 3, 0, 1000, "m", "", "... and up to this gap beside the walls it has"),
    number_row("min_depth_m", 0.03, 0.001, 10, "m", "",
               "Nearer to the plane of a wall than this distance counts as on it: least depth of joinery"),
    number_row("max_depth_m", 1, 0.01, 100, "m", "", "Largest depth of joinery behind the plane of its wall"),
    number_row("front_m", 0.30, 0, 10, "m", "",
               "What fills an opening may stand up to this distance before the plane of the wall"),
    bool_row("joints", true, "", "Edges near another plane are drawn to the line in which both planes meet"),
    number_row("joint_gap_m", 0, 0, 100, "m", "",
               "Largest gap between an edge and that line; 0 = two spacings of the plane's points"),
    number_row("min_door_height_m", 1.5, 0.1, 100, "m", "",
               "Least height of a notch in the lower border of a wall that counts as an opening"),
};

constexpr std::array kSolidRow{
    bool_row("solids", false, "", "Walls with thickness_m as closed solids; arcs become chords within 1 mm")};
constexpr std::array kThicknessRow{
    number_row("thickness_m", 0, 0, 100, "m", "",
               "Thickness (full) of walls that become solids; 0 = the median depth of the facade's openings")};

constexpr auto kExtrusionRows =
    joined_rows(joined_rows(joined_rows(kVectoriseRows, kFacadeRows), kPatternRows), kThicknessRow);
constexpr auto kRows = joined_rows(kExtrusionRows, kSolidRow);

PlanSetting plan_setting(const ParamSet& params) {
  PlanSetting s;
  s.group.min_wall_area_m2 = params.number("min_wall_area_m2");
  s.group.min_wall_width_m = params.number("min_wall_width_m");
  s.group.min_facade_share = params.number("min_facade_share");
  s.group.min_facade_height_m = params.number("min_facade_height_m");
  s.group.facade_depth_m = params.number("facade_depth_m");
  s.group.facade_gap_m = params.number("facade_gap_m");
  s.survey.min_depth_m = params.number("min_depth_m");
  s.survey.max_depth_m = params.number("max_depth_m");
  s.survey.front_m = params.number("front_m");
  s.group.notch.min_height_m = params.number("min_door_height_m");
  s.patterns = pattern_setting(params);
  return s;
}

JointSetting joint_setting(const ParamSet& params) { return {params.flag("joints"), params.number("joint_gap_m")}; }

Model run(const Segmentation& segmentation, const ParamSet& params, const AssemblySetting& setting, Task& task) {
  if (plane_count(segmentation.segments) == 0) return {};
  std::vector<VectorPlane> planes;
  {
    const Span span(task, 0, 0.6);
    planes = vectorise(segmentation, vectorise_setting(params), task);
  }
  FacadePlan plan;
  {
    const Span span(task, 0.6, 0.9);
    std::vector<SharedCorner> shared = join_planes(planes, segmentation.segments, joint_setting(params), task);
    plan = plan_facades(segmentation, std::move(planes), plan_setting(params), task);
    plan.shared = std::move(shared);
  }
  const Span span(task, 0.9, 1, "putting faces together");
  return assemble_facades(segmentation, std::move(plan), setting, task);
}

}  // namespace

std::span<const ParamRow> facade_rows() { return kRows; }
std::span<const ParamRow> extrusion_rows() { return kExtrusionRows; }

Model model_facade(const Segmentation& segmentation, const ParamSet& params, Task& task) {
  return run(segmentation, params, {params.flag("solids"), false, params.number("thickness_m")}, task);
}

Model model_extrusion(const Segmentation& segmentation, const ParamSet& params, Task& task) {
  return run(segmentation, params, {true, true, params.number("thickness_m")}, task);
}

}  // namespace jalon
