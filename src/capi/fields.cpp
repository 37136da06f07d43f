// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/fields.h"

#include <cstring>

#include "capi/support/guard.h"

using namespace jalon;
using namespace jalon::capi;

jalon_fields* jalon_fields_retain(jalon_fields* fields) { return retain(fields); }
void jalon_fields_release(jalon_fields* fields) { release(fields); }

jalon_status jalon_fields_count(const jalon_fields* fields, uint64_t* out) {
  return guard([&] {
    require(fields, "fields");
    require(out, "out");
    *out = fields->table.size();
  });
}

jalon_status jalon_fields_info(const jalon_fields* fields, uint64_t i, jalon_field_info* out) {
  return guard([&] {
    require(fields, "fields");
    require(out, "out");
    if (i >= fields->table.size())
      fail(Status::kInvalidArgument, "there are %zu fields", fields->table.size());
    if (out->struct_size < sizeof(uint32_t) || out->struct_size > 4096)
      fail(Status::kInvalidArgument, "struct_size of jalon_field_info is not set");
    const Column& column = *fields->table.at(i);
    const FieldInfo& field = column.info();
    const jalon_field_info info{out->struct_size,   static_cast<int32_t>(field.type),
                                field.components,   0,
                                column.count(),     field.name.c_str(),
                                field.unit.c_str(), field.meaning.c_str()};
    std::memcpy(out, &info, std::min<size_t>(out->struct_size, sizeof info));
  });
}

jalon_status jalon_fields_view(const jalon_fields* fields, const char* name,
                               jalon_array_view* out) {
  return guard([&] {
    require(fields, "fields");
    require(out, "out");
    *out = view_of(fields->table.require(require_text(name, "name")));
  });
}

jalon_status jalon_fields_copy(const jalon_fields* fields, const char* name, int32_t type,
                               void* out, uint64_t capacity_elements) {
  return guard([&] {
    require(fields, "fields");
    const Column& column = fields->table.require(require_text(name, "name"));
    const uint64_t needed = column.count() * column.info().components;
    require_type(type);
    if (needed != 0) require(out, "out");
    if (capacity_elements < needed)
      fail(Status::kInvalidArgument, "room for %llu elements; field \"%s\" has %llu",
           static_cast<unsigned long long>(capacity_elements), column.info().name.c_str(),
           static_cast<unsigned long long>(needed));
    load_converted(column, require_type(type), out);
  });
}
