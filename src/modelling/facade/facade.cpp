// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/facade.h"

#include <iterator>

#include "modelling/edges/join/vectorise.h"
#include "modelling/evidence/evidence.h"
#include "modelling/evidence/pieces_apart.h"
#include "modelling/facade/assembly.h"
#include "modelling/plane/ring_tools.h"
#include "modelling/walls/border_shadows.h"

namespace jalon {

namespace {

constexpr double kLeastEdge_m = 1e-6;  // below what any coordinate is told apart by

EvidenceSetting evidence_setting(const PlanSetting& plan) {
  const SurveySetting& survey = plan.survey;
  EvidenceSetting out;
  out.openings = plan.openings;
  out.cells.on_m = survey.min_depth_m;
  out.cells.behind_m = survey.max_depth_m;
  return out;
}

// Walls end at what was measured: beside them too it is told what nobody measured of them.
void add_border_shadows(const std::vector<WallEvidence>& evidence, const ContourSetting& setting,
                        FacadePlan& plan, Task& task) {
  for (PlannedFacade& facade : plan.facades)
    for (PlannedWall& planned : facade.walls) {
      auto more = border_shadows(plan.planes[planned.plane], planned.wall,
                                 evidence[planned.plane].cells, setting, task);
      auto& shadows = planned.wall.shadows;
      shadows.insert(shadows.end(), std::make_move_iterator(more.begin()),
                     std::make_move_iterator(more.end()));
    }
}

Model run(const Segmentation& given, const ExtrusionSettings& settings,
          const AssemblySetting& assembly, Task& task) {
  if (plane_count(given.segments) == 0) return {};
  Segmentation segmentation = given;
  FacadePlan plan;
  {
    const ProgressSpan span(task, 0, 0.9);
    plan = plan_model(segmentation, settings, task);
  }
  const ProgressSpan span(task, 0.9, 1, "putting faces together");
  return assemble_facades(segmentation, std::move(plan), assembly, task);
}

}  // namespace

FacadePlan plan_model(Segmentation& segmentation, const ExtrusionSettings& settings, Task& task) {
  const bool by_evidence = settings.plan.by_evidence;
  std::vector<WallEvidence> evidence;
  if (by_evidence) {
    const ProgressSpan span(task, 0, 0.17, "looking through openings");
    evidence = gather_whole_walls(segmentation, settings.plan.survey.min_depth_m,
                                  evidence_setting(settings.plan), task);
  }
  std::vector<VectorPlane> planes;
  {
    const ProgressSpan span(task, 0.17, 0.72);
    planes = vectorise(segmentation, settings.vectorise, task,
                       by_evidence ? contours_by(evidence) : ContourMaker{});
  }
  const ProgressSpan span(task, 0.72, 1);
  std::vector<SharedCorner> shared =
      join_planes(planes, segmentation.segments, settings.joints, task);
  // Edges drawn to one joint leave nothing of the step that was between them.
  for (VectorPlane& plane : planes)
    for (VectorFace& face : plane.faces) {
      drop_short_edges(face.outline, kLeastEdge_m);
      for (VectorRing& ring : face.openings) drop_short_edges(ring, kLeastEdge_m);
    }
  FacadePlan plan = plan_facades(segmentation, std::move(planes), settings.plan, task, evidence);
  plan.shared = std::move(shared);
  if (by_evidence) add_border_shadows(evidence, settings.vectorise.contour, plan, task);
  return plan;
}

Model model_facade(const Segmentation& segmentation, const FacadeSettings& settings, Task& task) {
  const double thickness_m = settings.walls.thickness_m;
  return run(segmentation, settings.walls, {settings.solids, false, thickness_m}, task);
}

Model model_cell_decomposition(const Segmentation& segmentation, const FacadeSettings& settings,
                               Task& task) {
  FacadeSettings used = settings;
  PlanSetting& plan = used.walls.plan;
  plan.openings.by_cells = plan.by_evidence = true;
  plan.patterns.enabled = false;  // the text completes nothing
  return model_facade(segmentation, used, task);
}

Model model_extrusion(const Segmentation& segmentation, const ExtrusionSettings& settings,
                      Task& task) {
  return run(segmentation, settings, {true, true, settings.thickness_m}, task);
}

}  // namespace jalon
