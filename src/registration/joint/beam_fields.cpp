// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/beam_fields.h"

#include <string>
#include <vector>

namespace jalon {

namespace {

template <class T>
void join_field(Cloud& cloud, const char* name, uint32_t components, const char* unit) {
  if (cloud.fields.find(name) != nullptr) return;
  std::vector<ColumnPtr> parts;
  for (uint32_t k = 0; k < components; ++k) {
    ColumnPtr part = cloud.fields.find_shared(name + ("_" + std::to_string(k)));
    if (part == nullptr || part->info().components != 1) return;
    parts.push_back(std::move(part));
  }
  auto whole = std::make_shared<Column>(
      FieldInfo{name, element_type_of<T>(), components, unit, "as the file keeps it, joined"},
      cloud.size());
  const auto out = whole->template values<T>();
  for (size_t i = 0; i < cloud.size(); ++i)
    for (uint32_t k = 0; k < components; ++k)
      out[components * i + k] = static_cast<T>(parts[k]->number(i));
  for (const ColumnPtr& part : parts) cloud.fields.remove(part->info().name);
  cloud.fields.set(std::move(whole));
}

}  // namespace

Cloud with_whole_beams(const Cloud& cloud) {
  Cloud made = cloud;
  join_field<double>(made, "beam_origin", 3, "m");
  join_field<float>(made, "beam_direction", 3, "1");
  join_field<float>(made, "covariance", 6, "m2");
  return made;
}

}  // namespace jalon
