// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/index.h"

#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "formats/ept/schema.h"
#include "formats/files/utf8.h"

namespace jalon::ept {

namespace {

constexpr uint64_t kMostJsonBytes = uint64_t{16} << 20;  // as all JSON here
constexpr size_t kMostDimensions = 4096;

/// What is asked of an index beside what it gives.
struct Told {
  std::optional<std::string> data, hierarchy;
  std::optional<double> span;
  bool has_bounds = false, has_schema = false;
};

void require(const ByteSource& source, bool there, const char* name) {
  if (!there) source.refuse(0, "no EPT: \"%s\" is missing", name);
}

void require_plain(const ByteSource& source, const std::optional<std::string>& text,
                   const char* name, const char* wanted) {
  require(source, text.has_value(), name);
  if (*text != wanted)
    fail(Status::kUnsupported, "%s: EPT is read where its \"%s\" is \"%s\", not \"%.20s\"",
         source.path().c_str(), name, wanted, name_from_file(*text, "").c_str());
}

void read_bounds(JsonCursor& json, Index& index) {
  std::array<double, 6> corners{};
  size_t n = 0;
  json.begin_array();
  while (json.next_element()) {
    if (n == corners.size()) json.refuse("the end of the six numbers of the bounds");
    corners[n++] = json.number();
  }
  if (n != corners.size()) json.refuse("six numbers of the bounds");
  index.low = {corners[0], corners[1], corners[2]};
  index.edge = corners[3] - corners[0];
  if (!(index.edge > 0) || !std::isfinite(index.edge)) json.refuse("a cube as bounds");
}

std::optional<ElementType> type_of(const std::string& kind, double bytes) {
  using enum ElementType;
  for (const ElementType type :
       {kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kInt64, kUint64, kFloat32, kFloat64})
    if (static_cast<double>(size_of(type)) == bytes && kind == kind_of(type)) return type;
  return std::nullopt;
}

// NormalX, NormalY, NormalZ of one type, one behind the other, are one field.
void join_normals(std::vector<Index::Member>& members) {
  for (size_t i = 0; i + 2 < members.size(); ++i) {
    if (members[i].field != "NormalX" || members[i + 1].field != "NormalY" ||
        members[i + 2].field != "NormalZ" || members[i].type != members[i + 1].type ||
        members[i].type != members[i + 2].type)
      continue;
    members[i].field = "normal";
    members[i].components = 3;
    members.erase(members.begin() + static_cast<ptrdiff_t>(i) + 1,
                  members.begin() + static_cast<ptrdiff_t>(i) + 3);
    return;
  }
}

struct Row {
  std::optional<std::string> name, kind;
  std::optional<double> bytes;
  double scale = 1, shift = 0;
};

Row read_row(JsonCursor& json) {
  Row row;
  json.begin_object();
  for (std::string name; json.next_member(name);) {
    if (name == "name") row.name = json.text();
    else if (name == "type") row.kind = json.text();
    else if (name == "size") row.bytes = json.number();
    else if (name == "scale") row.scale = json.number();
    else if (name == "offset") row.shift = json.number();
    else json.skip();  // statistics
  }
  if (!row.name || !row.kind || !row.bytes) json.refuse("name, type and size of a dimension");
  return row;
}

void read_schema(const ByteSource& source, JsonCursor& json, Index& index) {
  unsigned axes = 0;
  size_t count = 0;
  UniqueNames unique;
  index.record_bytes = 0;
  index.members.clear();
  json.begin_array();
  while (json.next_element()) {
    if (++count > kMostDimensions)
      source.refuse(json.byte(), "more than %zu dimensions", kMostDimensions);
    const Row row = read_row(json);
    const std::string& name = *row.name;
    const auto type = type_of(*row.kind, *row.bytes);
    if (!type)
      source.refuse(json.byte(), "the dimension %.60s has no known type",
                    name_from_file(name, "dimension").c_str());
    const size_t offset = index.record_bytes;
    index.record_bytes += size_of(*type);
    if (name == "X" || name == "Y" || name == "Z") {
      if (size_of(*type) < 4) json.refuse("no coordinates of fewer than 4 bytes");
      const auto k = static_cast<size_t>(name[0] - 'X');
      axes |= 1u << k;
      index.axes[k] = {*type, offset, row.scale, row.shift};
    } else {
      index.members.push_back(
          {unique.add(name_from_file(field_of(name), "field")), *type, 1, offset});
    }
  }
  if (axes != 7) json.refuse("X, Y and Z in the schema");
  join_normals(index.members);
}

std::string text_or_none(JsonCursor& json) {
  if (json.kind() == JsonCursor::Kind::kText) return json.text();
  json.skip();
  return {};
}

void read_crs(JsonCursor& json, Index& index) {
  if (json.kind() != JsonCursor::Kind::kObject) return void(json.skip());
  std::string authority, code;
  json.begin_object();
  for (std::string name; json.next_member(name);) {
    if (name == "wkt") index.crs = text_or_none(json);
    else if (name == "authority") authority = text_or_none(json);
    else if (name == "horizontal") code = text_or_none(json);
    else json.skip();
  }
  if (index.crs.empty() && !code.empty()) index.crs = authority + ":" + code;
}

void read_told(const ByteSource& source, JsonCursor& json, Index& index, Task& task) {
  if (json.kind() != JsonCursor::Kind::kArray) return void(json.skip());
  bool good = true;
  json.begin_array();
  while (json.next_element()) {
    const std::string_view text = json.skip();
    if (!good) continue;
    try {
      read_stations(text, index.stations);
    } catch (const Error& error) {
      if (error.status() != Status::kFormat) throw;
      task.log(Task::kWarning, "%s: the stations are left out: %s", source.path().c_str(),
               error.what());
      index.stations = {};
      good = false;
    }
  }
}

Told read_members(const ByteSource& source, JsonCursor& json, Index& index, Task& task) {
  Told told;
  json.begin_object();
  for (std::string name; json.next_member(name);) {
    if (name == "dataType") {
      told.data = json.text();
    } else if (name == "hierarchyType") {
      told.hierarchy = json.text();
    } else if (name == "span") {
      told.span = json.number();
    } else if (name == "bounds") {
      read_bounds(json, index);
      told.has_bounds = true;
    } else if (name == "schema") {
      read_schema(source, json, index);
      told.has_schema = true;
    } else if (name == "srs") {
      read_crs(json, index);
    } else if (name == "jalon") {
      read_told(source, json, index, task);
    } else {
      json.skip();
    }
  }
  json.end();
  return told;
}

}  // namespace

JsonFile::JsonFile(const ByteSource& source, Task& task) : source_(source), task_(task) {
  if (source.size() > kMostJsonBytes) source.refuse(0, "JSON of more than 16 MiB");
  text_.resize(source.size());
  source.read(0, text_.data(), text_.size());
}

void JsonFile::refuse(uint64_t byte, const char* expected) const {
  source_.refuse(byte, "no EPT: %s was expected", expected);
}

Index read_index(const ByteSource& source, Task& task) {
  const JsonFile file(source, task);
  JsonCursor json = file.cursor();
  Index index;
  const Told told = read_members(source, json, index, task);
  require_plain(source, told.data, "dataType", "binary");
  require_plain(source, told.hierarchy, "hierarchyType", "json");
  require(source, told.has_bounds, "bounds");
  require(source, told.has_schema, "schema");
  require(source, told.span.has_value(), "span");
  if (!(*told.span >= 1)) source.refuse(0, "a \"span\" of less than 1");
  index.spacing = index.edge / *told.span;
  return index;
}

}  // namespace jalon::ept
