// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/params.h"
#include "cloud/cloud.h"

namespace jalon {

/// What a reduction did; the struct of jalon/types.h.
struct Reduction {
  uint64_t count_in = 0, count_out = 0, removed = 0;
  double removed_percent = 0;
};
Reduction reduction_of(uint64_t count_in, uint64_t count_out);

// Parameter tables of the operations of the same names.
std::span<const ParamRow> normals_rows();
std::span<const ParamRow> features_rows();
std::span<const ParamRow> components_rows();
std::span<const ParamRow> outliers_rows();
std::span<const ParamRow> subsample_rows();
std::span<const ParamRow> interest_rows();

/// The cloud with the new fields; see jalon/cloud.h for what each does.
Cloud with_normals(const Cloud& cloud, const ParamSet& options, Task& task);
Cloud with_features(const Cloud& cloud, const ParamSet& options, Task& task);
Cloud with_components(const Cloud& cloud, const ParamSet& options, Task& task, uint64_t& count);
Cloud with_inverted_normals(const Cloud& cloud, Task& task);

Cloud without_duplicates(const Cloud& cloud, double tolerance_m, Task& task);
Cloud without_outliers(const Cloud& cloud, const ParamSet& options, Task& task);
Cloud subsampled(const Cloud& cloud, const ParamSet& options, Task& task);

/// One byte a point: 1 = inside.
std::vector<uint8_t> inside_box(const Cloud& cloud, const Box3& box, const Transform& T_box_world, Task& task);
std::vector<uint8_t> inside_prism(const Cloud& cloud, std::span<const Vec2> polygon, double w_min, double w_max,
                                  const Transform& T_prism_world, Task& task);
std::vector<uint8_t> inside_cylinder(const Cloud& cloud, const Vec3& foot, const Vec3& top, double radius_m,
                                     Task& task);
/// 1 = point of interest (the facade), 0 = unwanted.
std::vector<uint8_t> points_of_interest(const Cloud& cloud, const ParamSet& options, Task& task);
/// The points whose mask byte equals value.
Cloud select_mask(const Cloud& cloud, std::span<const uint8_t> mask, uint8_t value, Task& task);

}  // namespace jalon
