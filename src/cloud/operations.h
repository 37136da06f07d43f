// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "cloud/cloud.h"
#include "cloud/subsample_cells.h"
#include "spatial/voxels/components.h"

/// What the operations of jalon/cloud.h do to a cloud. Each has its settings and the table of their
/// rows, which says what a member means; a row's default is the member's initialiser.
namespace jalon {

/// What a reduction did; the struct of jalon/types.h.
struct Reduction {
  uint64_t count_in = 0, count_out = 0, removed = 0;
  double removed_percent = 0;
};
Reduction reduction_of(uint64_t count_in, uint64_t count_out);

struct NormalsSettings {
  enum class Method { kPca, kQuadric, kTriangulation } method = Method::kPca;
  uint32_t k = 16;
  double radius_m = 0;
  bool curvature = false;
  enum class Orientation { kNone, kStation, kPoint, kCentroid } orientation = Orientation::kNone;
  std::vector<double> viewpoint{0, 0, 0};
  bool outward = true;
};
std::span<const ParamRow> normals_rows();
/// The cloud with the field "normal" and, on demand, "curvature".
Cloud with_normals(const Cloud& cloud, const NormalsSettings& settings, Task& task);
Cloud with_inverted_normals(const Cloud& cloud, Task& task);

struct FeaturesSettings {
  std::string which =
      "density roughness surface_variation linearity planarity sphericity verticality";
  uint32_t k = 16;
  double radius_m = 0;
};
std::span<const ParamRow> features_rows();
Cloud with_features(const Cloud& cloud, const FeaturesSettings& settings, Task& task);

struct ComponentsSettings {
  double cell_m = 0.1;
  int level = -1;
  Connectivity3 connectivity = Connectivity3::k26;
  uint64_t min_points = 10;
  std::string field{};
  double value = 1;
};
std::span<const ParamRow> components_rows();
/// The cloud with the field "component"; count: of those that are large enough.
Cloud with_components(const Cloud& cloud, const ComponentsSettings& settings, Task& task,
                      uint64_t& count);

Cloud without_duplicates(const Cloud& cloud, double tolerance_m, Task& task);

struct OutliersSettings {
  enum class Method { kStatistical, kRadius } method = Method::kStatistical;
  uint32_t k = 16;
  double sigmas = 2;
  double radius_m = 0.1;
  uint32_t neighbours = 4;
};
std::span<const ParamRow> outliers_rows();
Cloud without_outliers(const Cloud& cloud, const OutliersSettings& settings, Task& task);

struct SubsampleSettings {
  enum class Method { kVoxel, kMinimumDistance, kRandom, kOctree } method = Method::kVoxel;
  double cell_m = 0.05;
  Keep keep = Keep::kCentroid;
  double distance_m = 0.05;
  double fraction = 0.1;
  uint64_t count = 0;
  uint64_t seed = 1;
  int level = -1;
  uint64_t max_points = 1000000;
};
std::span<const ParamRow> subsample_rows();
Cloud subsampled(const Cloud& cloud, const SubsampleSettings& settings, Task& task);

/// One byte a point: 1 = inside.
std::vector<uint8_t> inside_box(const Cloud& cloud, const Box3& box, const Transform& T_box_world,
                                Task& task);
std::vector<uint8_t> inside_prism(const Cloud& cloud, std::span<const Vec2> polygon, double w_min,
                                  double w_max, const Transform& T_prism_world, Task& task);
std::vector<uint8_t> inside_cylinder(const Cloud& cloud, const Vec3& foot, const Vec3& top,
                                     double radius_m, Task& task);

struct InterestSettings {
  double distance_tolerance_m = 0.1;
  double vertical_tolerance_rad = 0.052;
  double front_m = 2.0;
  double back_m = 0.6;
  double pixel_m = 0.25;
  double gap_m = 1.0;
  bool remove_ground = false;
  std::vector<double> viewpoint{};
  uint64_t seed = 1;
};
std::span<const ParamRow> interest_rows();
/// 1 = point of interest (the facade), 0 = unwanted.
std::vector<uint8_t> points_of_interest(const Cloud& cloud, const InterestSettings& settings,
                                        Task& task);

/// The points whose mask byte equals value.
Cloud select_mask(const Cloud& cloud, std::span<const uint8_t> mask, uint8_t value, Task& task);

}  // namespace jalon
