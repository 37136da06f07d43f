// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/field.h"
#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"

namespace jalon {

/// The columns, which must live until the writer has sealed.
void write_table(ByteWriter& writer, const FieldTable& table);
/// Columns of one length and of different names.
FieldTable read_table(ByteReader& reader, Task& task);

/// A column that code reads by name, which takes its type and components for granted.
struct KnownColumn {
  const char* name;
  ElementType type;
  uint32_t components = 1;
  bool is_needed = false;
};
/// Refuses a table in which one of them is of another type, or one that is needed lacks.
void require_known(const ByteReader& reader, const FieldTable& table,
                   std::span<const KnownColumn> known);
/// Refuses a table that has columns of another length; one without columns is as long as anything.
void require_rows(const ByteReader& reader, const FieldTable& table, const char* name, size_t rows);

}  // namespace jalon
