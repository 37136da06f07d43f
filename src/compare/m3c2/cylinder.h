// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/numbers.h"
#include "cloud/cloud.h"
#include "compare/comparison.h"
#include "compare/m3c2/level_of_detection.h"
#include "compare/m3c2/point_covariances.h"
#include "compare/m3c2/settings.h"
#include "compare/m3c2/surfaces.h"
#include "spatial/neighbours/shape_search.h"

namespace jalon {

/// The surface that one cloud gives in a cylinder.
struct SurfaceInCylinder {
  uint32_t count = 0;  ///< of its points; of all points in the cylinder where there is no surface
  SurfacePosition position{0, kNaN, 0, 0};
};

/// What one cylinder tells.
struct CylinderResult {
  CompareStatus status = CompareStatus::kTooFewPoints;
  double distance_m = kNaN;  ///< compared minus reference
  double lod_m = kNaN;
  SurfaceInCylinder reference, compared;
};

/// Steps 2 to 4 of Lague, Brodu & Leroux (2013): the points of both clouds in a cylinder along the normal, where their
/// surfaces lie in it, and how sure that is.
class CylinderComparer {
 public:
  CylinderComparer(const M3c2Settings& settings, const CloudPtr& reference,
                   const CloudPtr& compared, Task& task);

  /// What one thread keeps of one cloud between cylinders.
  struct Side {
    ShapeSearch search;
    SurfaceFinder finder;
    std::vector<double> along_m;  ///< ascending
    std::vector<double> work_m;
    std::vector<ShapeSearch::AlongRun> runs;
    std::span<const ShapeSearch::Along>
        points;  ///< where covariances are asked for; else perhaps none
    std::span<const CylinderSurface> surfaces;
    PropagatedVariance variances;
  };
  struct Work {
    Side reference, compared;
  };
  Work work() const;

  CylinderResult at(const Vec3& centre, const Vec3& normal, Work& work) const;

 private:
  struct Epoch {
    CloudPtr cloud;
    std::shared_ptr<const Octree> tree;
    PointCovariances covariances;
  };
  Epoch epoch(const CloudPtr& cloud, const char* name, Task& task) const;
  Side side(const Epoch& epoch) const;
  void fill(const Epoch& epoch, const Vec3& centre, const Vec3& normal, Side& side) const;
  void take_points(const Vec3& centre, const Vec3& normal, Side& side) const;
  void take_runs(const Vec3& centre, const Vec3& normal, Side& side) const;
  SurfaceInCylinder measure(const Epoch& epoch, const Vec3& normal, Side& side,
                            const CylinderSurface& surface) const;

  const M3c2Settings& settings_;
  double gap_m_;
  bool at_median_, by_covariances_;
  std::optional<RigidUncertainty> registration_;
  Epoch reference_, compared_;
  MedianEstimator median_;
  LevelOfDetection detection_;
};

}  // namespace jalon
