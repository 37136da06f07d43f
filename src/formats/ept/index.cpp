// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/index.h"

#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/json_writer.h"
#include "formats/ept/schema.h"
#include "formats/files/utf8.h"

namespace jalon::ept {

namespace {

constexpr uint64_t kMostJsonBytes = uint64_t{16} << 20;  // what read_json() takes
constexpr size_t kMostDimensions = 4096;

const JsonValue& need(const ByteSource& source, const JsonValue& object, const char* name) {
  const JsonValue* found =
      object.kind == JsonValue::Kind::kObject ? find_member(object, name) : nullptr;
  if (found == nullptr) source.refuse(0, "no EPT: \"%s\" is missing", name);
  return *found;
}

double number(const ByteSource& source, const JsonValue& value, const char* what) {
  if (!value.is_number() || !std::isfinite(value.number))
    source.refuse(0, "\"%s\" is no number", what);
  return value.number;
}

void require_plain(const ByteSource& source, const JsonValue& json, const char* name,
                   const char* wanted) {
  const std::string& text = need(source, json, name).text;
  if (text != wanted)
    fail(Status::kUnsupported, "%s: EPT is read where its \"%s\" is \"%s\", not \"%.20s\"",
         source.path().c_str(), name, wanted, text.c_str());
}

void read_cube(const ByteSource& source, const JsonValue& json, Index& index) {
  std::vector<double> corners;
  for (const JsonValue& child : JsonChildren(need(source, json, "bounds")))
    corners.push_back(number(source, child, "bounds"));
  if (corners.size() != 6) source.refuse(0, "\"bounds\" has %zu numbers, not 6", corners.size());
  index.low = {corners[0], corners[1], corners[2]};
  index.edge = corners[3] - corners[0];
  const double span = number(source, need(source, json, "span"), "span");
  if (!(index.edge > 0) || !(span >= 1)) source.refuse(0, "the cube or its span cannot be");
  index.spacing = index.edge / span;
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

void read_axis(const ByteSource& source, const JsonValue& row, ElementType type, size_t offset,
               Index::Axis& axis) {
  if (size_of(type) < 4) source.refuse(0, "coordinates of fewer than 4 bytes");
  axis = {type, offset};
  if (const JsonValue* scale = find_member(row, "scale"))
    axis.scale = number(source, *scale, "scale");
  if (const JsonValue* shift = find_member(row, "offset"))
    axis.shift = number(source, *shift, "offset");
}

void read_schema(const ByteSource& source, const JsonValue& json, Index& index) {
  unsigned axes = 0;
  size_t count = 0;
  UniqueNames unique;
  for (const JsonValue& row : JsonChildren(need(source, json, "schema"))) {
    if (++count > kMostDimensions) source.refuse(0, "more than %zu dimensions", kMostDimensions);
    const std::string& name = need(source, row, "name").text;
    const auto type =
        type_of(need(source, row, "type").text, number(source, need(source, row, "size"), "size"));
    if (!type) source.refuse(0, "the dimension %.60s has no known type", name.c_str());
    const size_t offset = index.record_bytes;
    index.record_bytes += size_of(*type);
    if (name == "X" || name == "Y" || name == "Z") {
      const auto k = static_cast<size_t>(name[0] - 'X');
      axes |= 1u << k;
      read_axis(source, row, *type, offset, index.axes[k]);
    } else {
      index.members.push_back(
          {unique.add(name_from_file(field_of(name), "field")), *type, 1, offset});
    }
  }
  if (axes != 7) source.refuse(0, "no EPT: X, Y or Z is missing");
  join_normals(index.members);
}

void read_crs(const JsonValue& json, Index& index) {
  const JsonValue* srs = find_member(json, "srs");
  if (srs == nullptr || srs->kind != JsonValue::Kind::kObject) return;
  const JsonValue *wkt = find_member(*srs, "wkt"), *authority = find_member(*srs, "authority"),
                  *code = find_member(*srs, "horizontal");
  if (wkt != nullptr && wkt->kind == JsonValue::Kind::kText) index.crs = wkt->text;
  if (index.crs.empty() && authority != nullptr && code != nullptr && !code->text.empty())
    index.crs = authority->text + ":" + code->text;
}

void read_told(const ByteSource& source, const JsonValue& json, Index& index, Task& task) {
  const JsonValue* told = find_member(json, "jalon");
  if (told == nullptr || told->kind != JsonValue::Kind::kArray) return;
  try {
    for (const JsonValue& one : JsonChildren(*told))
      read_stations(JsonWriter().value(one).take(), index.stations);
  } catch (const Error& error) {
    if (error.status() != Status::kFormat) throw;
    task.log(Task::kWarning, "%s: the stations are left out: %s", source.path().c_str(),
             error.what());
    index.stations = {};
  }
}

}  // namespace

std::vector<JsonValue> json_of(const ByteSource& source) {
  if (source.size() > kMostJsonBytes) source.refuse(0, "JSON of more than 16 MiB");
  std::string text(source.size(), '\0');
  source.read(0, text.data(), text.size());
  try {
    return read_json(text);
  } catch (const Error& error) {
    if (error.status() != Status::kInvalidArgument) throw;
    source.refuse(0, "%s", error.what());
  }
}

Index read_index(const ByteSource& source, Task& task) {
  const std::vector<JsonValue> values = json_of(source);
  const JsonValue& json = values.front();
  require_plain(source, json, "dataType", "binary");
  require_plain(source, json, "hierarchyType", "json");
  Index index;
  read_cube(source, json, index);
  read_schema(source, json, index);
  read_crs(json, index);
  read_told(source, json, index, task);
  return index;
}

}  // namespace jalon::ept
