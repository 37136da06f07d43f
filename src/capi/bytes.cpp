// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/bytes.h"

#include "bytes/clouds.h"
#include "bytes/tables.h"
#include "capi/support/bytes_handle.h"

using namespace jalon;
using namespace jalon::capi;

jalon_bytes* jalon_bytes_retain(jalon_bytes* bytes) { return retain(bytes); }
void jalon_bytes_release(jalon_bytes* bytes) { release(bytes); }

jalon_status jalon_bytes_view(const jalon_bytes* bytes, jalon_array_view* out) {
  return guard([&] {
    require(bytes, "bytes");
    require(out, "out");
    *out = {bytes->buffer.data(), bytes->buffer.size(), 1, JALON_UINT8, 1};
  });
}

jalon_status jalon_cloud_to_bytes(const jalon_cloud* cloud, jalon_task* task, jalon_bytes** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    const CloudPtr kept = cloud->cloud;  // a progress callback may set a field
    *out = bytes_of(BytesKind::kCloud, task, [&](ByteWriter& w) { write_cloud(w, *kept); });
  });
}

jalon_status jalon_cloud_from_bytes(const uint8_t* bytes, uint64_t byte_count, jalon_task* task,
                                    jalon_cloud** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kCloud, task, [](ByteReader& r, Task& t) {
             return own(new_cloud(read_cloud(r, t)));
           }).release();
  });
}

jalon_status jalon_fields_to_bytes(const jalon_fields* fields, jalon_task* task,
                                   jalon_bytes** out) {
  return guard([&] {
    require(fields, "fields");
    require(out, "out");
    *out =
        bytes_of(BytesKind::kFields, task, [&](ByteWriter& w) { write_table(w, fields->table); });
  });
}

jalon_status jalon_fields_from_bytes(const uint8_t* bytes, uint64_t byte_count, jalon_task* task,
                                     jalon_fields** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kFields, task, [](ByteReader& r, Task& t) {
             return own(new_fields(read_table(r, t)));
           }).release();
  });
}
