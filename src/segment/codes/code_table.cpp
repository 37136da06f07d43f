// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/code_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.h"
#include "base/json_reader.h"

namespace jalon {

namespace {

constexpr std::array<const char*, 16> kGeometryNames{
    "ignored",     "point",       "line",          "prism",        "two_corners", "three_points",
    "four_points", "outline",     "centre",        "edge",         "top",         "pipe",
    "wall_target", "door_target", "window_target", "gutter_target"};

constexpr int64_t kMostSequence = 1000000000;  // codes have few digits
constexpr double kMostDistance_m = 10;
constexpr int64_t kMostClass = 255;  // the field "classification" holds a byte

CodeGeometry geometry_of(const std::string& name) {
  for (size_t i = 0; i < kGeometryNames.size(); ++i)
    if (name == kGeometryNames[i]) return static_cast<CodeGeometry>(i);
  fail(Status::kFormat, "code table: there is no geometry \"%s\"", name.c_str());
}

int64_t whole(const JsonValue& value, const char* what, int64_t most) {
  if (value.kind != JsonValue::Kind::kInteger || value.integer < 0 || value.integer > most)
    fail(Status::kFormat, "code table: \"%s\" must be a whole number from 0 to %lld", what,
         static_cast<long long>(most));
  return value.integer;
}

int64_t member(const JsonValue& object, const char* what, int64_t most, int64_t otherwise) {
  const JsonValue* value = find_member(object, what);
  return value != nullptr ? whole(*value, what, most) : otherwise;
}

std::string text_member(const JsonValue& object, const char* what) {
  const JsonValue* value = find_member(object, what);
  if (value == nullptr || value->kind != JsonValue::Kind::kText)
    fail(Status::kFormat, "code table: each code has a text \"%s\"", what);
  return value->text;
}

// A word that is none of these would be passed over unsaid, as would the thickness that it was to tell.
void require_known(const JsonValue& object) {
  constexpr std::array<std::string_view, 7> kMembers{"from",  "to",         "name",  "geometry",
                                                     "class", "distance_m", "hinged"};
  for (const JsonValue& member : JsonChildren(object))
    if (std::find(kMembers.begin(), kMembers.end(), member.name) == kMembers.end())
      fail(Status::kFormat,
           "code table: a code has no \"%s\"; it has from, to, name, geometry, class, distance_m "
           "and hinged",
           std::string(member.name).c_str());
}

bool has_class(CodeGeometry geometry) {
  return geometry != CodeGeometry::kIgnored && geometry != CodeGeometry::kPoint &&
         geometry != CodeGeometry::kLine;
}

CodeRow row_of(const JsonValue& object) {
  if (object.kind != JsonValue::Kind::kObject)
    fail(Status::kFormat, "code table: \"codes\" holds objects");
  require_known(object);
  if (find_member(object, "from") == nullptr)
    fail(Status::kFormat, "code table: each code has a number \"from\"");
  CodeRow row;
  row.from = member(object, "from", kMostSequence, 0);
  row.to = member(object, "to", kMostSequence, row.from);
  row.name = text_member(object, "name");
  row.geometry = geometry_of(text_member(object, "geometry"));
  if (has_class(row.geometry) && find_member(object, "class") == nullptr)
    fail(Status::kFormat, "code table: %s has no \"class\", the number of its points' class",
         row.name.c_str());
  row.class_code = member(object, "class", kMostClass, 0);
  if (const JsonValue* distance = find_member(object, "distance_m")) {
    if (!distance->is_number() || !(distance->number > 0 && distance->number < kMostDistance_m))
      fail(Status::kFormat, "code table: \"distance_m\" of %s is no length below 10 m",
           row.name.c_str());
    row.distance_m = distance->number;
  }
  if (const JsonValue* hinged = find_member(object, "hinged")) row.is_hinged = hinged->flag;
  if (row.to < row.from)
    fail(Status::kFormat, "code table: \"to\" of %s lies below its \"from\"", row.name.c_str());
  return row;
}

CodeModifiers modifiers_of(const JsonValue& object) {
  CodeModifiers m;
  m.start = member(object, "start", kMostSequence, m.start);
  m.next = member(object, "next", kMostSequence, m.next);
  m.curve = member(object, "curve", kMostSequence, m.curve);
  m.close = member(object, "close", kMostSequence, m.close);
  m.offset = member(object, "offset", kMostSequence, m.offset);
  return m;
}

std::vector<JsonValue> json_of(std::string_view text) {
  try {
    return read_json(text);
  } catch (const Error& error) {
    fail(error.status(), "code table: %s", error.what());
  }
}

void require_distinct(const CodeTable& table) {
  for (size_t i = 0; i < table.rows.size(); ++i)
    for (size_t k = 0; k < i; ++k)
      if (table.rows[i].from <= table.rows[k].to && table.rows[k].from <= table.rows[i].to)
        fail(Status::kFormat, "code table: %s and %s share a code", table.rows[k].name.c_str(),
             table.rows[i].name.c_str());
}

}  // namespace

const char* name_of(CodeGeometry geometry) { return kGeometryNames[static_cast<size_t>(geometry)]; }

const CodeRow* CodeTable::find(int64_t sequence) const {
  for (const CodeRow& row : rows)
    if (row.from <= sequence && sequence <= row.to) return &row;
  return nullptr;
}

CodeTable code_table_from_json(std::string_view text) {
  const std::vector<JsonValue> read = json_of(text);
  const JsonValue& top = read.front();
  if (top.kind != JsonValue::Kind::kObject) fail(Status::kFormat, "code table: no JSON object");
  CodeTable table;
  if (const JsonValue* name = find_member(top, "name")) table.name = name->text;
  if (const JsonValue* separator = find_member(top, "separator")) {
    if (separator->text.size() != 1 || separator->text.find_first_of("0123456789.;\t") == 0)
      fail(Status::kFormat, "code table: \"separator\" is one character that no number has");
    table.separator = separator->text[0];
  }
  if (const JsonValue* modifiers = find_member(top, "modifiers"))
    table.modifiers = modifiers_of(*modifiers);
  const JsonValue* codes = find_member(top, "codes");
  if (codes == nullptr || codes->kind != JsonValue::Kind::kArray)
    fail(Status::kFormat, "code table: no list \"codes\"");
  for (const JsonValue& code : JsonChildren(*codes)) table.rows.push_back(row_of(code));
  require_distinct(table);
  return table;
}

}  // namespace jalon
