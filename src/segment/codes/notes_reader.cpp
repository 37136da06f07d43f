// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/notes_reader.h"

#include <limits>

#include "base/error.h"
#include "base/json_reader.h"

namespace jalon {

namespace {

const JsonValue& required(const JsonValue& object, const char* name, JsonValue::Kind kind) {
  const JsonValue* value = find_member(object, name);
  if (value == nullptr || value->kind != kind)
    fail(Status::kFormat, "notes of codes: \"%s\" is missing or of another kind", name);
  return *value;
}

std::string text_at(const JsonValue& object, const char* name) {
  return required(object, name, JsonValue::Kind::kText).text;
}

std::string optional_text(const JsonValue& object, const char* name) {
  return find_member(object, name) != nullptr ? text_at(object, name) : "";
}

int64_t whole_at(const JsonValue& object, const char* name, int64_t most) {
  const int64_t value = required(object, name, JsonValue::Kind::kInteger).integer;
  if (value < 0 || value > most)
    fail(Status::kFormat, "notes of codes: \"%s\" is out of its range", name);
  return value;
}

// A height that nobody measured is null.
double number_at(const JsonValue& object, const char* name) {
  const JsonValue* value = find_member(object, name);
  return value != nullptr && value->is_number() ? value->number : kNaN;
}

Vec3 place_of(const JsonValue& list, double height) {
  Vec3 place{0, 0, height};
  int axis = 0;
  if (list.kind != JsonValue::Kind::kArray) fail(Status::kFormat, "notes of codes: no place");
  for (const JsonValue& value : JsonChildren(list)) {
    if (axis == 3 || !value.is_number()) fail(Status::kFormat, "notes of codes: no place");
    place[axis++] = value.number;
  }
  if (axis < 2 || !is_finite(place)) fail(Status::kFormat, "notes of codes: no place");
  return place;
}

// Corners of a prism have two coordinates and its upper height.
std::vector<Vec3> places_at(const JsonValue& object, const char* name, double height = kNaN) {
  std::vector<Vec3> places;
  if (const JsonValue* list = find_member(object, name);
      list != nullptr && list->kind == JsonValue::Kind::kArray)
    for (const JsonValue& each : JsonChildren(*list)) places.push_back(place_of(each, height));
  return places;
}

// Four lists side by side.
std::vector<NotedPoint> surveyed_at(const JsonValue& object) {
  std::vector<NotedPoint> points;
  for (const Vec3& place : places_at(object, "places")) points.push_back({"", "", 0, place});
  const auto each = [&](const char* name, JsonValue::Kind kind, auto&& take) {
    size_t at = 0;
    for (const JsonValue& value : JsonChildren(required(object, name, JsonValue::Kind::kArray))) {
      if (at == points.size() || value.kind != kind)
        fail(Status::kFormat, "notes of codes: \"%s\" does not go with \"places\"", name);
      take(points[at++], value);
    }
  };
  each("ids", JsonValue::Kind::kText, [](NotedPoint& p, const JsonValue& v) { p.id = v.text; });
  each("codes", JsonValue::Kind::kText, [](NotedPoint& p, const JsonValue& v) { p.code = v.text; });
  each("lines", JsonValue::Kind::kInteger, [](NotedPoint& p, const JsonValue& v) {
    p.line = static_cast<size_t>(std::max<int64_t>(0, v.integer));
  });
  return points;
}

NotedObject object_of(const JsonValue& from) {
  constexpr int64_t kMost = std::numeric_limits<int64_t>::max();
  if (from.kind != JsonValue::Kind::kObject)
    fail(Status::kFormat, "notes of codes: \"objects\" holds objects");
  NotedObject o;
  o.name = text_at(from, "name");
  o.kind = text_at(from, "kind");
  o.geometry = text_at(from, "geometry");
  o.shape = text_at(from, "shape");
  o.hinge = optional_text(from, "hinge");
  o.code = whole_at(from, "code", kMost);
  o.class_code = whole_at(from, "class", kMost);
  o.label = static_cast<uint32_t>(whole_at(from, "label", UINT32_MAX));
  o.points = static_cast<uint64_t>(whole_at(from, "points", kMost));
  o.radius_m = number_at(from, "radius_m");
  o.low_m = number_at(from, "low_m");
  o.high_m = number_at(from, "high_m");
  o.surveyed = surveyed_at(from);
  o.axis = places_at(from, "axis");
  o.outline = places_at(from, "outline", o.high_m);
  if (const auto corners = places_at(from, "corners"); o.outline.empty() && corners.size() == 2) {
    const Vec3 &a = corners[0], &b = corners[1];
    o.outline = {
        {a.x, a.y, o.low_m}, {b.x, b.y, o.low_m}, {b.x, b.y, o.high_m}, {a.x, a.y, o.high_m}};
  }
  for (const Vec3& p : o.outline)
    if (!is_finite(p)) fail(Status::kFormat, "notes of codes: %s has no heights", o.name.c_str());
  return o;
}

}  // namespace

CodedNotes read_coded_notes(std::string_view json) {
  CodedNotes notes;
  if (json.empty()) return notes;
  const std::vector<JsonValue> read = read_json(json);
  const JsonValue& top = read.front();
  if (top.kind != JsonValue::Kind::kObject) fail(Status::kFormat, "notes of codes: no object");
  notes.method = text_at(top, "method");
  for (const JsonValue& each : JsonChildren(required(top, "classes", JsonValue::Kind::kArray)))
    notes.classes.push_back(
        {whole_at(each, "class", 255),
         static_cast<uint64_t>(whole_at(each, "points", std::numeric_limits<int64_t>::max()))});
  for (const JsonValue& each : JsonChildren(required(top, "objects", JsonValue::Kind::kArray)))
    notes.objects.push_back(object_of(each));
  for (const JsonValue& each : JsonChildren(required(top, "warnings", JsonValue::Kind::kArray)))
    notes.warnings.push_back({static_cast<size_t>(whole_at(each, "line", INT64_MAX)),
                              text_at(each, "object"), text_at(each, "text")});
  return notes;
}

}  // namespace jalon
