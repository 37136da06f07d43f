// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

/// Corner of whole metres below all points: coordinates relative to it lose nothing, and it moves
/// with the cloud.
Vec3 local_origin(const Cloud& cloud, Task& task);

struct CloudCovariance {
  Vec3 origin;          ///< local_origin()
  Vec3 local_centroid;  ///< relative to it: the same bits wherever the cloud lies
  Vec3 centroid;
  Symmetric3 covariance{};  ///< divided by n
};
/// Two passes, ordered sums. Error(kInsufficientData) for an empty cloud.
CloudCovariance covariance_of(const Cloud& cloud, Task& task);
/// (1/n) sum of u^a v^b w^c about the centroid, or of the coordinates as they are.
/// Error(kInsufficientData) for an empty cloud.
double moment_of(const Cloud& cloud, uint32_t a, uint32_t b, uint32_t c, bool centred, Task& task);

}  // namespace jalon
