// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/codes/grouping.h"
#include "segment/codes/shapes.h"
#include "unit/segment/codes/annex.h"

namespace jalon::test {

/// The objects of a list by the survey's ready-made table, with their shapes.
inline CodedObjects surveyed(const std::string& list) {
  const CodeTable table = code_table_from_json(kSurveyCodeTable);
  CodedObjects objects = grouped_objects(read_code_list(list, table), table);
  give_shapes(table, objects);
  return objects;
}

inline const CodedObject* object_named(const CodedObjects& all, const std::string& name) {
  for (const CodedObject& object : all.objects)
    if (object.name == name) return &object;
  return nullptr;
}

/// The warning about an object, or an empty one.
inline CodeWarning warning_of(const CodedObjects& all, const std::string& object) {
  for (const CodeWarning& w : all.warnings)
    if (w.object == object) return w;
  return {};
}

}  // namespace jalon::test
