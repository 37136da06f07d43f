// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "formats/files/utf8.h"

namespace jalon {

inline constexpr const char* kNormalColumns[] = {"nx", "ny",
                                                 "nz"};  ///< as tables of points call them

inline bool is_normal(const FieldInfo& field) {
  return field.name == "normal" && field.components == 3;
}

/// Takes x, y, z and, where the cloud has normals, theirs before any field that is called so.
inline void reserve_point_names(const FieldTable& fields, UniqueNames& unique) {
  for (const char* name : {"x", "y", "z"}) unique.add(name);
  for (const ColumnPtr& column : fields)
    if (is_normal(column->info()))
      for (const char* name : kNormalColumns) unique.add(name);
}

}  // namespace jalon
