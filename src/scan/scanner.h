// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"
#include "scan/static_settings.h"

namespace jalon {

struct ScanStation {
  std::string name;
  Transform pose;  ///< T_world_scanner, a rigid motion
};

/// Two or four tripods 1.7 m above the lowest point of the model, by the way its upright triangles face: in front of
/// a facade at 0.6 x its width; inside a street or a room, on its long axis; at the corners around a building. None
/// without upright triangles. A count puts so many evenly along the facade or the axis, or on a circle around the
/// building; a distance (0: the rule above) goes from the foremost upright triangle to the tripods.
std::vector<ScanStation> automatic_stations(const Model& model, uint64_t count = 0,
                                            double distance_m = 0);

/// Method "static": a tripod. Fields "face" and "segment" (uint32; see scan/truth.h), "true_xyz" (float64 x 3),
/// "range" (float32), on demand "incidence_angle" (float32); one cloud station a scan station. Without stations the
/// automatic ones are taken.
Cloud scan_static(const Model& model, std::span<const ScanStation> stations,
                  const StaticSettings& settings, Task& task);

/// Method "sample": random points on all faces, whether or not they can be seen, in the order of the triangles, with
/// noise along their normals. Fields "face", "segment", "true_xyz". Refuses stations.
struct SampleSettings {
  uint64_t points = 0;  ///< 0: by the spacing
  double spacing_m = 0.1;
  bool equal_counts = false;
  double noise_m = 0.003, point_noise_m = 0;
  ScannedSurfaceSettings surfaces{};
  double outliers = 0;  ///< share of the points
  double coordinate_step_m = 0;
  std::vector<double> offset_m{0, 0, 0};
  uint64_t seed = 1;
  std::string densities = {};  ///< as triangle_densities() has it
};
std::span<const ParamRow> sample_scanner_rows();
Cloud scan_sample(const Model& model, std::span<const ScanStation> stations,
                  const SampleSettings& settings, Task& task);

/// The true planes of the model as a scan with these settings numbers and shifts them, and, with a
/// cloud of the same settings, how many of its points each has: see truth_table.
FieldTable true_planes(const Model& model, const Cloud* cloud, double truth_min_area_m2,
                       std::span<const double> offset_m, Task& task);

}  // namespace jalon
