// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/diagnosis.h"
#include "compare/distance/distance.h"

namespace jalon::test {

/// Two epochs compared both ways, with levels of detection, and what changed. The comparisons that the diagnosis's
/// epochs point at are gone when it is back: its regions and changes are what may be read.
inline Diagnosis diagnosed(const CloudPtr& before, const CloudPtr& after,
                           DistanceSettings::VisibleFrom visibility) {
  Task task;
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = visibility;
  return diagnose(compare_distance(before, after, settings, task),
                  compare_distance(after, before, settings, task), {}, task);
}

}  // namespace jalon::test
