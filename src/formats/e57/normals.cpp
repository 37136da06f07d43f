// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/normals.h"

#include <memory>
#include <utility>

namespace jalon {

void join_normals(Cloud& cloud) {
  const Column* parts[3];
  for (size_t k = 0; k < 3; ++k) {
    parts[k] = cloud.fields.find(kNormalParts[k]);
    if (parts[k] == nullptr || !is_floating(parts[k]->info().type)) return;
  }
  auto normals = std::make_shared<Column>(
      FieldInfo{"normal", ElementType::kFloat32, 3, "", "unit normal"}, cloud.size());
  float* out = normals->values<float>().data();
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 local{parts[0]->number(i), parts[1]->number(i), parts[2]->number(i)};
    const Station* station = station_of(cloud, i);
    const Vec3 n = station != nullptr && station->has_pose ? station->pose.direction(local) : local;
    for (size_t k = 0; k < 3; ++k) out[3 * i + k] = static_cast<float>(n[static_cast<int>(k)]);
  }
  for (const char* name : kNormalParts) cloud.fields.remove(name);
  cloud.fields.set(std::move(normals));
}

}  // namespace jalon
