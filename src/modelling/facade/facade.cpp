// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/facade.h"

#include "modelling/edges/join/vectorise.h"
#include "modelling/facade/assembly.h"

namespace jalon {

namespace {

Model run(const Segmentation& segmentation, const ExtrusionSettings& settings,
          const AssemblySetting& assembly, Task& task) {
  if (plane_count(segmentation.segments) == 0) return {};
  std::vector<VectorPlane> planes;
  {
    const ProgressSpan span(task, 0, 0.6);
    planes = vectorise(segmentation, settings.vectorise, task);
  }
  FacadePlan plan;
  {
    const ProgressSpan span(task, 0.6, 0.9);
    std::vector<SharedCorner> shared =
        join_planes(planes, segmentation.segments, settings.joints, task);
    plan = plan_facades(segmentation, std::move(planes), settings.plan, task);
    plan.shared = std::move(shared);
  }
  const ProgressSpan span(task, 0.9, 1, "putting faces together");
  return assemble_facades(segmentation, std::move(plan), assembly, task);
}

}  // namespace

Model model_facade(const Segmentation& segmentation, const FacadeSettings& settings, Task& task) {
  const double thickness_m = settings.walls.thickness_m;
  return run(segmentation, settings.walls, {settings.solids, false, thickness_m}, task);
}

Model model_extrusion(const Segmentation& segmentation, const ExtrusionSettings& settings,
                      Task& task) {
  return run(segmentation, settings, {true, true, settings.thickness_m}, task);
}

}  // namespace jalon
