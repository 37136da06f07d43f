// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/notes.h"

#include "base/json_writer.h"

namespace jalon {

namespace {

void write_place(JsonWriter& json, const Vec3& p) {
  json.begin_array().value(p.x).value(p.y).value(p.z).end_array();
}

// The border of an opening lies in the upright plane of its base line.
void write_border(JsonWriter& json, const CodeShape& shape, const Vec3& origin) {
  const Vec2 base = in_plan(shape.corner_b - shape.corner_a), along = base * (1 / norm(base));
  json.name("outline").begin_array();
  for (const Vec2& p : shape.polygon) {
    const Vec2 at = in_plan(shape.corner_a) + along * p.u;
    write_place(json, Vec3{at.u, at.v, p.v} + origin);
  }
  json.end_array();
}

// Every shape in world coordinates, as it was measured.
void write_shape(JsonWriter& json, const CodeShape& shape, const Vec3& origin) {
  json.name("shape").value(name_of(shape.kind));
  if (shape.kind == CodeShape::Kind::kPrism) {
    json.name("low_m").value(shape.low_m + origin.z).name("high_m").value(shape.high_m + origin.z);
    json.name("outline").begin_array();
    for (const Vec2& p : shape.polygon)
      json.begin_array().value(p.u + origin.x).value(p.v + origin.y).end_array();
    json.end_array();
  } else if (shape.kind == CodeShape::Kind::kPipe) {
    json.name("radius_m").value(shape.radius_m).name("axis").begin_array();
    for (const Vec3& p : shape.axis) write_place(json, p + origin);
    json.end_array();
  } else if (shape.kind != CodeShape::Kind::kNone) {
    json.name("corners").begin_array();
    write_place(json, shape.corner_a + origin);
    write_place(json, shape.corner_b + origin);
    json.end_array();
    if (shape.kind == CodeShape::Kind::kOutline) write_border(json, shape, origin);
    json.name("low_m").value(shape.low_m + origin.z).name("high_m").value(shape.high_m + origin.z);
  }
}

std::string code_of(const CodedPoint& p) {
  const std::string sequence = std::to_string(p.sequence);
  return p.modifier == kNoModifier ? sequence : sequence + "." + std::to_string(p.modifier);
}

void write_object(JsonWriter& json, const CodedObject& object, const Vec3& origin, uint32_t label,
                  uint64_t points) {
  constexpr const char* kHinges[] = {"unknown", "left", "right"};
  json.begin_object().name("name").value(object.name).name("kind").value(object.row.name);
  json.name("code").value(object.points.front().sequence);
  json.name("class").value(object.row.class_code).name("label").value(label);
  json.name("points").value(points).name("lines").begin_array();
  for (const CodedPoint& p : object.points) json.value(p.line);
  json.end_array().name("ids").begin_array();
  for (const CodedPoint& p : object.points) json.value(p.id);
  json.end_array().name("codes").begin_array();
  for (const CodedPoint& p : object.points) json.value(code_of(p));
  json.end_array().name("places").begin_array();
  for (const CodedPoint& p : object.points) write_place(json, p.position);
  json.end_array().name("geometry").value(name_of(object.row.geometry));
  if (object.row.is_hinged) json.name("hinge").value(kHinges[static_cast<size_t>(object.hinge)]);
  write_shape(json, object.shape, origin);
  json.end_object();
}

}  // namespace

std::string coded_notes(const char* method, const CodedObjects& objects,
                        const std::vector<uint32_t>& labels, const std::vector<uint64_t>& points,
                        const std::map<int64_t, uint64_t>& classes) {
  JsonWriter json;
  json.begin_object().name("method").value(method).name("classes").begin_array();
  for (const auto& [number, count] : classes)
    json.begin_object().name("class").value(number).name("points").value(count).end_object();
  json.end_array().name("objects").begin_array();
  for (size_t i = 0; i < objects.objects.size(); ++i)
    write_object(json, objects.objects[i], objects.origin, labels[i], points[i]);
  json.end_array().name("warnings").begin_array();
  for (const CodeWarning& w : objects.warnings)
    json.begin_object()
        .name("line")
        .value(w.line)
        .name("object")
        .value(w.object)
        .name("text")
        .value(w.text)
        .end_object();
  return json.end_array().end_object().take();
}

}  // namespace jalon
