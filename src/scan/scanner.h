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

namespace jalon {

struct ScanStation {
  std::string name;
  Transform pose;  ///< T_world_scanner, a rigid motion
};

/// Throws kInvalidArgument unless the transform is a rotation and a shift (to 1e-6) of finite numbers.
void require_rigid(const Transform& pose);

/// Two or four tripods 1.7 m above the lowest point of the model, by the way its upright triangles face: in front of
/// a facade at 0.6 x its width; inside a street or a room, on its long axis; at the corners around a building. None
/// without upright triangles. A count puts so many evenly along the facade or the axis, or on a circle around the
/// building; a distance (0: the rule above) goes from the foremost upright triangle to the tripods.
std::vector<ScanStation> automatic_stations(const Model& model, uint64_t count = 0, double distance_m = 0);

/// A way to make a cloud of a model, with its parameter table. All have offset_m, truth_min_area_m2 and seed.
struct ScannerMethod {
  const char* name;
  const char* owner;  ///< of its parameters, in messages
  std::span<const ParamRow> (*rows)();
  Cloud (*scan)(const Model& model, std::span<const ScanStation> stations, const ParamSet& params, Task& task);
};
std::span<const ScannerMethod> scanner_methods();

/// Method "static": a tripod. Fields "face" and "segment" (uint32; see scan/truth.h), "true_xyz" (float64 x 3),
/// "range" (float32), on demand "incidence_angle" (float32); one cloud station a scan station. Without stations the
/// automatic ones are taken.
std::span<const ParamRow> static_scanner_rows();
Cloud scan_static(const Model& model, std::span<const ScanStation> stations, const ParamSet& params, Task& task);

/// Method "sample": random points on all faces, whether or not they can be seen, in the order of the triangles, with
/// noise along their normals. Fields "face", "segment", "true_xyz". Refuses stations.
std::span<const ParamRow> sample_scanner_rows();
Cloud scan_sample(const Model& model, std::span<const ScanStation> stations, const ParamSet& params, Task& task);

/// The true planes of the model as these parameters number and shift them, and, with a cloud of the same parameters,
/// how many of its points each has: see truth_table.
FieldTable true_planes(const Model& model, const Cloud* cloud, const ParamSet& params, Task& task);

/// Parameter table of the operation "scene" and its builder.
std::span<const ParamRow> scene_rows();
Model build_scene(const ParamSet& params, Task& task);

}  // namespace jalon
