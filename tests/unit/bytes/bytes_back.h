// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"

namespace jalon::test {

/// Writes by write(writer), reads by read(reader, task), to the end; the message of the refusal, "" for none.
template <class Write, class Read>
std::string bytes_back(Write&& write, Read&& read) {
  Task task;
  ByteWriter writer;
  write(writer);
  const Buffer<uint8_t> whole = writer.sealed(BytesKind::kFields, task);
  try {
    ByteReader reader({whole.data(), whole.size()}, BytesKind::kFields, task);
    read(reader, task);
    reader.end();
  } catch (const Error& error) {
    return error.status() == Status::kFormat ? error.what() : "another status";
  }
  return "";
}

inline bool has_text(const std::string& message, const char* part) {
  return message.find(part) != std::string::npos;
}

}  // namespace jalon::test
