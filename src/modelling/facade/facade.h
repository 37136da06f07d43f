// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "modelling/edges/join/vectorise_setting.h"
#include "modelling/facade/plan.h"
#include "segment/segmentation.h"

namespace jalon {

/// Parameters of method "extrusion".
struct ExtrusionSettings {
  VectoriseSetting vectorise;
  PlanSetting plan;
  JointSetting joints;
  double thickness_m = 0;  ///< of solids; 0: the median depth of the facade's openings
};

/// Parameters of method "facade".
struct FacadeSettings {
  ExtrusionSettings walls;
  bool solids = false;
};

/// Their tables.
std::span<const ParamRow> facade_rows();
std::span<const ParamRow> cell_decomposition_rows();
std::span<const ParamRow> extrusion_rows();

/// Walls with windows and doors, their reveals and joinery, and the elements before and behind
/// them, in space (Boulaassal 2010, 4.4.1):
/// 1. the 2D vector model of every planar segment (vectorise);
/// 2. edges near other planes drawn to them (plane_joints.h);
/// 3. facades, their walls, openings told from shadows (plan.h, openings.h);
/// 4. faces with shared vertices in a tree of parts (assembly.h).
Model model_facade(const Segmentation& segmentation, const FacadeSettings& settings, Task& task);

/// The same with openings by cell decomposition, without completion of patterns (cell_decomposition.h).
Model model_cell_decomposition(const Segmentation& segmentation, const FacadeSettings& settings,
                               Task& task);

/// Steps 1 to 3 alone: what is known before faces are made. segmentation becomes that of which the plan's planes are.
FacadePlan plan_model(Segmentation& segmentation, const ExtrusionSettings& settings, Task& task);

/// The walls alone, extruded inward along their normals by the depth of their openings, as closed solids with the
/// reveals of the openings (Boulaassal 2010, 4.4.2).
Model model_extrusion(const Segmentation& segmentation, const ExtrusionSettings& settings,
                      Task& task);

}  // namespace jalon
