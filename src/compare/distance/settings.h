// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "compare/visibility/settings.h"

namespace jalon {

enum class LocalModelKind { kNone, kPlane, kDelaunay, kQuadric };

/// The parameters of method "distance"; see distance_rows() for what they mean.
struct DistanceSettings {
  enum class Neighbourhood { kNearest, kPoint };  ///< of the nearest reference, the compared point
  enum class VisibleFrom { kAnywhere, kStations, kFound };

  double max_distance_m = 0;  ///< 0: no limit
  bool is_signed = true;      ///< of a model, as the next two
  double tolerance_m = 0;     ///< 0: no judgement
  double chord_error_m = 1e-4;
  LocalModelKind local_model = LocalModelKind::kNone;
  uint32_t k = 0;       ///< reference points of a local model, where radius_m is 0; 0: by its kind
  double radius_m = 0;  ///< 0: by k
  Neighbourhood neighbourhood = Neighbourhood::kNearest;
  bool differences = false;
  bool sampling_error = false;
  bool hausdorff = false;
  VisibleFrom visibility = VisibleFrom::kAnywhere;
  bool reference_spacing = false;
  bool detection = false;              ///< of changes, point by point
  double false_discovery_rate = 0.01;  ///< of detection, as the next
  double alignment_sigma_m = 0;
  DepthSettings depth{};    ///< of visibility
  HiddenSettings hidden{};  ///< of visibility

  /// Infinity without one.
  double limit_m() const {
    return max_distance_m > 0 ? max_distance_m : std::numeric_limits<double>::infinity();
  }
  /// k, or as many as the kind of local model wants.
  uint32_t model_points() const;
};

/// Parameter table of method "distance".
std::span<const ParamRow> distance_rows();

}  // namespace jalon
