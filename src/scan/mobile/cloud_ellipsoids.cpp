// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/mobile/cloud_ellipsoids.h"

#include <cmath>
#include <limits>

#include "base/error.h"

namespace jalon {

namespace {

Symmetric3 covariance_at(const Column& column, size_t i) {
  constexpr uint32_t kOfNine[6] = {0, 1, 2, 4, 5, 8};
  Symmetric3 c;
  for (uint32_t k = 0; k < 6; ++k)
    c[k] = column.number(i, column.info().components == 6 ? k : kOfNine[k]);
  return c;
}

bool is_finite(const Symmetric3& c) {
  for (const double v : c)
    if (!std::isfinite(v)) return false;
  return true;
}

}  // namespace

Model cloud_ellipsoids(const Cloud& cloud, const EllipsoidSettings& settings, Task& task) {
  const Column& column = cloud.fields.require("covariance");
  if ((column.info().components != 6 && column.info().components != 9) ||
      !is_floating(column.info().type))
    fail(Status::kInvalidArgument,
         "the field \"covariance\" has %u components: 6 or 9 floating ones are needed",
         column.info().components);
  const SphereMesh sphere = sphere_mesh(settings.fineness);
  const uint64_t drawn = (cloud.size() + settings.every - 1) / settings.every;
  constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();
  if (cloud.size() > kMost || drawn > kMost / sphere.triangles.size())
    fail(Status::kLimit, "%llu ellipsoids are more than a model holds: draw fewer of them",
         static_cast<unsigned long long>(drawn));
  Model model;
  for (size_t i = 0; i < cloud.size(); i += settings.every) {
    if (i / settings.every % 1024 == 0)
      task.checkpoint(static_cast<double>(i) / static_cast<double>(cloud.size()));
    const Symmetric3 c = covariance_at(column, i);
    if (!is_finite(c)) continue;
    std::array<Vec3, 3> axes = ellipsoid_half_axes(c, settings.confidence);
    for (Vec3& axis : axes) axis *= settings.scale;
    add_ellipsoid(model, sphere, cloud.point(i), axes, static_cast<uint32_t>(i));
  }
  model.parts.push_back({"ellipsoids", "mesh", kNoParent});
  model.crs = cloud.crs;
  return model;
}

}  // namespace jalon
