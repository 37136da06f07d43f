// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/icp/patch_fit.h"
#include "registration/surface/planes.h"

namespace jalon {

/// Points of both clouds on one surface, patch by patch: each point counts once and with its own
/// weight, while a local plane of sixteen neighbours adds its noise to every pair it stands in. The
/// surface of a patch is an unknown beside the pose (least squares 3-D matching, Gruen & Akca 2005;
/// plane adjustment, Zhou, Koppel & Kaess 2021).
///
/// Before: neighbours are of all points; the clouds outlive the patches. After: which reference
/// points may share a patch, and the moving points by their partner, do not change with the pose;
/// the sums are the same bits for any number of threads. O(n log n), then O(n) a call.
class IcpPatches {
 public:
  IcpPatches(const IcpClouds& clouds, const IcpNeighbours& neighbours, Task& task);
  PatchSums sums(const Transform& T_reference_moving, const RobustKernel& kernel,
                 const IcpFrame& frame, Task& task) const;

 private:
  const IcpClouds& clouds_;
  double noise_m_;
  std::vector<uint32_t> order_;           ///< of the reference's points
  std::vector<uint32_t> first_, moving_;  ///< moving points by their partner
};

}  // namespace jalon
