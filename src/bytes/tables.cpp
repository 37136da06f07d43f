// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/tables.h"

#include <cstring>
#include <unordered_set>

#include "base/parallel.h"

namespace jalon {

namespace {

// What a column takes at least: name, type, components, unit, meaning, count.
constexpr size_t kLeastColumnBytes = 8 + 4 + 4 + 8 + 8 + 8;
constexpr size_t kTableGrain = size_t{1} << 20;

FieldInfo read_info(ByteReader& reader) {
  FieldInfo info;
  info.name = reader.text();
  const auto type = reader.take<int32_t>();
  if (!is_element_type(type))
    reader.refuse("column \"%.100s\" has the element type %d, which is none", info.name.c_str(),
                  type);
  info.type = static_cast<ElementType>(type);
  info.components = reader.take<uint32_t>();
  if (info.components == 0 || info.components > kMostComponents)
    reader.refuse("column \"%.100s\" has %u components", info.name.c_str(), info.components);
  info.unit = reader.text();
  info.meaning = reader.text();
  return info;
}

ColumnPtr read_column(ByteReader& reader, Task& task) {
  FieldInfo info = read_info(reader);
  const size_t items = reader.count(size_of(info.type) * info.components);
  auto column = std::make_shared<Column>(std::move(info), items);
  const uint8_t* from = reader.block(column->bytes());
  parallel_for(task, column->bytes(), kTableGrain, [&](size_t begin, size_t end) {
    std::memcpy(static_cast<uint8_t*>(column->raw()) + begin, from + begin, end - begin);
  });
  return column;
}

}  // namespace

void write_table(ByteWriter& writer, const FieldTable& table) {
  writer.item(static_cast<uint64_t>(table.size()));
  for (const ColumnPtr& column : table) {
    const FieldInfo& info = column->info();
    writer.text(info.name);
    writer.item(info.type);
    writer.item(info.components);
    writer.text(info.unit);
    writer.text(info.meaning);
    writer.item(static_cast<uint64_t>(column->count()));
    writer.block(column->raw(), column->bytes());
  }
}

FieldTable read_table(ByteReader& reader, Task& task) {
  FieldTable table;
  std::unordered_set<std::string_view> names;
  for (size_t left = reader.count(kLeastColumnBytes); left > 0; --left) {
    ColumnPtr column = read_column(reader, task);
    const std::string& name = column->info().name;
    if (!names.insert(name).second) reader.refuse("two columns are named \"%.100s\"", name.c_str());
    if (table.size() > 0 && column->count() != table.at(0)->count())
      reader.refuse("column \"%.100s\" has %zu rows, the first one %zu", name.c_str(),
                    column->count(), table.at(0)->count());
    table.add(std::move(column));
  }
  return table;
}

void require_known(const ByteReader& reader, const FieldTable& table,
                   std::span<const KnownColumn> known) {
  for (const KnownColumn& wanted : known) {
    const Column* column = table.find(wanted.name);
    if (column == nullptr) {
      if (wanted.is_needed) reader.refuse("there is no column \"%s\"", wanted.name);
    } else if (column->info().type != wanted.type ||
               column->info().components != wanted.components) {
      reader.refuse("column \"%s\" is of %s x %u, not of %s x %u", wanted.name,
                    name_of(column->info().type), column->info().components, name_of(wanted.type),
                    wanted.components);
    }
  }
}

void require_rows(const ByteReader& reader, const FieldTable& table, const char* name,
                  size_t rows) {
  if (table.size() > 0 && table.at(0)->count() != rows)
    reader.refuse("the %s have %zu rows where there must be %zu", name, table.at(0)->count(), rows);
}

}  // namespace jalon
