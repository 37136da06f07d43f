// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/names/no_data.h"

#include "model/part_classes.h"

namespace jalon {

NoData no_data_of(const Model& model) {
  NoData out;
  for (const Part& part : model.parts) out.count += part.part_class == part_class::kNoData;
  for (const Face& face : model.faces) {
    if (face.part >= model.parts.size()) continue;
    const std::string& c = model.parts[face.part].part_class;
    if (c == part_class::kNoData) out.area_m2 += face.area_m2;
    if (c == part_class::kWall) out.wall_area_m2 += face.area_m2;
  }
  return out;
}

}  // namespace jalon
