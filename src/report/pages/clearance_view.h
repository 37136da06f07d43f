// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "report/charts/clearance_places.h"
#include "report/viewer/scene.h"

namespace jalon {

/// The cloud in the colours of its clearances (grey: farther than the margin), points on the model in those of their
/// faces, crosses with the numbers of the tight places, and the way of the gauge's origin. cloud, on_model (with fields
/// "face" and "triangle"): or nullptr. places: what jalon_gauge_sweep gives.
ViewScene clearance_scene(const CloudPtr& cloud, const CloudPtr& on_model, const FieldTable& places,
                          const GaugePath& path, std::span<const TightPlace> tight,
                          double margin_m);

}  // namespace jalon
