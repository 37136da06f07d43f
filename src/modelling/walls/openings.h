// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "modelling/evidence/find_openings.h"
#include "modelling/walls/facade_parts.h"
#include "modelling/walls/holes.h"
#include "modelling/walls/survey.h"
#include "segment/segmentation.h"

namespace jalon {

/// Tells the openings of a wall from its shadows (Boulaassal 2010, 5.6.3.2) and says what is known of
/// them; wall.openings, wall.shadows and wall.map are set from the survey.
///
/// A hole is an opening when rays passed through it or points lie behind it, when reveals were
/// measured in it, when something parallel to the wall fills it at most front_m before it or flush
/// with it, or, as the last resort, when nothing is known but its shape is that of one: upright
/// sides and a straight or arched head. It is a shadow when things in front hide it, and when
/// nothing is known and its shape is none.
///
/// Where the wall was drawn by its evidence the candidates tell instead which holes are openings.
///
/// Before: wall.frame, outlines and spacing are set; survey is of these holes. After:
/// - for each hole its index in wall.openings, or -1 for a shadow (or a bay that is none);
/// - openings have evidence, kind, depth and what was measured of their border;
/// - survey.map has moved to wall.map.
std::vector<int32_t> judge_holes(const Segmentation& segmentation, std::span<const WallHole> holes,
                                 WallSurvey& survey, const SurveySetting& setting, FacadeWall& wall,
                                 Task& task, std::span<const OpeningCandidate> candidates = {});

}  // namespace jalon
