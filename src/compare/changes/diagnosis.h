// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_features.h"
#include "compare/changes/change_objects.h"
#include "compare/matching/rigid_match.h"

namespace jalon {

/// Classes of changes (Girardeau-Montaut 2006, 1.1 and annex B); the numbers of jalon/changes.h.
enum class ChangeClass : uint8_t {
  kAppearance = 1,
  kDisappearance = 2,
  kDisplacement = 3,         ///< clear of where it was
  kDisplacementOverlap = 4,  ///< within the volume it took before
  kDeformation = 5,
  kDeformationOverlap = 6,
};

/// How a motion explains a thing and what changed of it: the points of before laid on those of after, and back.
struct MotionEvidence {
  LaidOn forth, back, changed_forth, changed_back;
  LaidOn stay_forth, stay_back;                                         ///< by none
  size_t before = 0, after = 0, changed_before = 0, changed_after = 0;  ///< points
  double way_m = 0;                                                     ///< of its farthest point
  double tilt_m = 0;      ///< of that, by turning off what it stands on
  bool is_whole = false;  ///< it ended within reach, and what it stands on is known
};

struct Change {
  ChangeClass change_class = ChangeClass::kAppearance;
  double confidence = 0;  ///< 0 ... 1
  ChangedObject object;
  RigidMatch match;       ///< of displacements; world coordinates relative to the epochs' origin
  double explained = 0;   ///< share of its points, by one rigid motion where one was looked for
  MotionEvidence motion;  ///< of a motion by the diagnosis by evidence
  ChangeFeatures features{};  ///< of the diagnosis by evidence
};

struct Diagnosis {
  Epoch before, after;
  std::vector<Change> changes;
  /// Of the diagnosis by evidence: what is as likely wrong as right. It cannot be told what happened there.
  std::vector<Change> untold;
  /// And what was weighed against these changes and is less probable.
  std::vector<Change> weighed;
};

/// Parameter table of operation "diagnosis": that of the regions it starts from.
std::span<const ParamRow> diagnosis_rows();
/// What happened, from the comparison in both directions (3.5): forward compares the cloud after with that before,
/// reverse the other way round. 1. Changed regions of both; 2. whole objects; 3. objects changed in both epochs moved
/// rigidly or were deformed; 4. those of one epoch alone: a soft border is a deformation, a twin in the other epoch a
/// displacement, a different object at the same place a deformation; 5. the others appeared or disappeared.
Diagnosis diagnose(const Comparison& forward, const Comparison& reverse,
                   const RegionSettings& settings, Task& task);

/// Columns "changed", "region", "change" of an epoch's points.
FieldTable diagnosis_points_table(const Diagnosis& diagnosis, bool is_after);
/// One row a change.
FieldTable changes_table(const Diagnosis& diagnosis);

}  // namespace jalon
