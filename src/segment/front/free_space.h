// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/front/evidence.h"
#include "segment/front/sparse_places.h"
#include "segment/front/wall_sheet.h"

namespace jalon {

/// Fills reach and blocked of the evidence: beams end at the first surface (Girardeau-Montaut 2006, 2.3.3), so what
/// lies beyond a wall was seen through its openings or past its border. Stations are tried on both sides, and the
/// few taken that explain most; what then still lies behind the measured wall is blocked. O(places x stations tried).
void look_through(const SparsePlaces& places, const WallSheet& sheet, FrontEvidence& evidence,
                  Task& task);

}  // namespace jalon
