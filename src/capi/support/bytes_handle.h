// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "base/buffer.h"
#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "capi/support/guard.h"
#include "jalon/bytes.h"

struct jalon_bytes : jalon::capi::Counted {
  jalon::Buffer<uint8_t> buffer;
};

namespace jalon::capi {

/// What jalon_..._to_bytes does: write(writer) tells what the object holds, which must outlive this call.
template <class F>
jalon_bytes* bytes_of(BytesKind kind, jalon_task* task, F&& write) {
  auto handle = std::make_unique<jalon_bytes>();
  ByteWriter writer;
  write(writer);
  handle->buffer = with_task(task, [&](Task& t) { return writer.sealed(kind, t); });
  return handle.release();
}

inline std::span<const uint8_t> require_bytes(const uint8_t* bytes, uint64_t byte_count) {
  require(bytes, "bytes");
  if (byte_count > static_cast<uint64_t>(std::numeric_limits<ptrdiff_t>::max()))
    fail(Status::kInvalidArgument, "bytes: %llu do not fit the address space",
         static_cast<unsigned long long>(byte_count));
  return {bytes, byte_count};
}

/// What jalon_..._from_bytes does under the caller's task: read(reader, task) gives the new handle, owned. Nothing may
/// stand behind what it reads.
template <class F>
auto read_bytes(const uint8_t* bytes, uint64_t byte_count, BytesKind kind, jalon_task* task,
                F&& read) {
  const auto whole = require_bytes(bytes, byte_count);
  return with_task(task, [&](Task& t) {
    ByteReader reader(whole, kind, t);
    auto made = read(reader, t);
    reader.end();
    return made;
  });
}

}  // namespace jalon::capi
