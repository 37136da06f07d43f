// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/yard/plan.h"
#include "unit/scan/scenes/built.h"

namespace jalon::test {

inline yard::Plan yard_plan(YardZone zone, uint64_t seed = 1) {
  YardSettings settings;
  settings.zone = zone;
  return yard::plan_of(settings, seed);
}

inline size_t openings_of(const yard::Plan& plan, bool is_door) {
  size_t count = 0;
  for (const yard::Side& side : plan.sides)
    for (const yard::Opening& o : side.openings) count += o.is_door == is_door;
  return count;
}

inline size_t targets_of(const yard::Plan& plan, int code) {
  size_t count = 0;
  for (const yard::Target& t : plan.targets) count += t.code == code;
  return count;
}

}  // namespace jalon::test
