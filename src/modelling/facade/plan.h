// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/evidence/evidence.h"
#include "modelling/patterns/patterns.h"
#include "modelling/plane/plane_joints.h"
#include "modelling/walls/facade_groups.h"
#include "modelling/walls/facade_parts.h"
#include "modelling/walls/survey.h"
#include "segment/segmentation.h"

namespace jalon {

struct PlannedWall {
  size_t plane = 0;  ///< index in FacadePlan::planes
  FacadeWall wall;
};

struct PlannedFacade {
  FacadeGroup group;
  std::vector<PlannedWall> walls;  ///< as group.walls
  std::vector<size_t>
      elements;  ///< planes that become parts of their own; joinery and reveals left out
};

/// All that is known before faces are made; faces of the wall planes are those that stay: filled
/// shadows are closed in them, the others are holes or notches.
struct FacadePlan {
  std::vector<VectorPlane> planes;  ///< one a segment
  std::vector<PlannedFacade> facades;
  std::vector<SharedCorner> shared;
};

/// What of a wall is drawn where nothing was measured.
enum class WallFill : uint8_t { kNever, kSmall, kOutline };

struct FillSetting {
  WallFill fill = WallFill::kSmall;
  /// Full; of the longer side of the box of what counts as small. Gaps between points are no longer than three spacings
  /// but in one case of a thousand; a dozen is what a lamp, a cable or a sign's bracket hides at usual spacings.
  double small_spacings = 12;
};

struct ClassSetting {
  double min_confidence = 0.7;  ///< least probability of a class; below an opening is "opening"
};

struct PlanSetting {
  bool by_evidence = true;  ///< walls and openings; else by the contours of their planes
  OpeningSearch openings;   ///< with evidence: how its openings are found
  GroupSetting group;
  SurveySetting survey;
  PatternSetting patterns;
  ClassSetting classes;
  FillSetting fill;
};

/// Facades, walls, their openings and shadows from the 2D models of the planes.
///
/// Before: planes[s] is that of segments[s]; edges are joined (join_planes); evidence[s] is what they were drawn by, or
/// there is none at all. After: each opening that is neither a copy nor a bay is a hole or notch of
/// the face that it names; elements are neither walls, nor joinery, nor reveals. shared is empty:
/// the caller sets it.
FacadePlan plan_facades(const Segmentation& segmentation, std::vector<VectorPlane> planes,
                        const PlanSetting& setting, Task& task,
                        std::span<const WallEvidence> evidence = {});

}  // namespace jalon
