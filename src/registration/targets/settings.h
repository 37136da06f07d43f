// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace jalon {

/// Standard deviation of unit weight: 1 (Baarda 1968), or from the residuals (Pope 1976).
enum class UnitWeight { kKnown, kEstimated };
/// How outliers are tested.
struct SnoopingSettings {
  UnitWeight sigma0 = UnitWeight::kKnown;
  double significance =
      0.001;           ///< chance that one good target is called an outlier (Baarda: alpha 0)
  double power = 0.8;  ///< chance that a blunder of the detectable size is found (Baarda: beta 0)

  bool estimated() const { return sigma0 == UnitWeight::kEstimated; }
};

enum class TargetTransform { kRigid, kSimilarity };
/// The parameters of method "targets"; the rows stand in targets.cpp.
struct TargetSettings {
  TargetTransform transform = TargetTransform::kRigid;
  double sigma_m = 0.003;  ///< of a coordinate, where a target has no covariance
  SnoopingSettings snooping;
  bool remove_outliers = false;
  double match_tolerance_m = 0;  ///< difference of distances; 0: from the covariances

  bool with_scale() const { return transform == TargetTransform::kSimilarity; }
};

enum class TargetShape { kSphere, kFlat };
/// Of a flat target; kAutomatic: by the intensities, else a patch.
enum class TargetPattern { kAutomatic, kChecker, kDisc, kPatch };
/// The parameters of operation "target"; the rows stand in measure.cpp.
struct MeasuringSettings {
  TargetShape kind = TargetShape::kSphere;
  double radius_m = 0;        ///< of the sphere; 0: free
  double size_m = 0.15;       ///< edge or diameter of a flat target
  double search_m = 0;        ///< radius around the place; 0: by radius or size
  double tolerance_m = 0.01;  ///< half-thickness
  TargetPattern pattern = TargetPattern::kAutomatic;
  std::string intensity_field = "intensity";
  std::string catalogue{};  ///< JSON; not empty: the whole cloud is searched
  double confidence = 0.9;  ///< from which a target of the catalogue is known
  uint64_t min_points = 30;
  uint64_t seed = 1;
};

}  // namespace jalon
