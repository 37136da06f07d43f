// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"

namespace jalon {

/// Points of a cloud by their indices (none = all), relative to a whole-metre origin near them.
struct PointList {
  Vec3 origin;
  std::vector<Vec3> points;
};
PointList listed_points(const Cloud& cloud, std::span<const uint64_t> indices, Task& task);
/// Normals of the listed points: the field "normal" where the cloud has it, else planes through the k nearest points.
std::vector<Vec3> listed_normals(const Cloud& cloud, std::span<const uint64_t> indices, uint32_t k,
                                 Task& task);
/// Normal of the least-squares plane through the k points nearest to a place; NaN when they have none.
Vec3 normal_near(const Cloud& cloud, const Octree& tree, const Vec3& place, uint32_t k);

/// The parameters of operation "primitive".
struct PrimitiveFitSettings {
  PrimitiveSetting fit;
  uint32_t k = 16;  ///< neighbours of a cylinder's normals, where the cloud has no field "normal"
};
std::span<const ParamRow> primitive_rows();

/// One segment, in world coordinates; Error(kInsufficientData) for too few points,
/// Error(kDegenerate) when they do not fix
/// the primitive.
Segment sphere_segment(const Cloud& cloud, std::span<const uint64_t> indices,
                       const PrimitiveFitSettings& settings, Task& task);
/// direction: of the axis, or null when it is to be found.
Segment cylinder_segment(const Cloud& cloud, std::span<const uint64_t> indices,
                         const Vec3* direction, const PrimitiveFitSettings& settings, Task& task);
/// A circle in the least-squares plane of its points: one row of "centre", "normal", "radius", "sigma", "inliers",
/// "covariance".
FieldTable circle_table(const Cloud& cloud, std::span<const uint64_t> indices,
                        const PrimitiveFitSettings& settings, Task& task);

/// Area, length and arc of a sphere or cylinder from its points (in the frame of its fit).
void describe_curved(std::span<const Vec3> points, double pixel_m, Segment& segment, Task& task);
/// Moves a fit from local to world coordinates.
void shift_origin(Segment& segment, const Vec3& origin);

}  // namespace jalon
