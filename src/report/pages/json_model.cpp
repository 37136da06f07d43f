// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/json_model.h"

#include <cmath>

#include "base/numbers.h"
#include "report/elevation/opening_list.h"
#include "report/names/no_data.h"
#include "report/names/part_tree.h"

namespace jalon {

namespace {

// A place in the list of parts, or null.
void write_place(JsonWriter& json, const char* name, uint64_t part, const Model& model) {
  json.name(name);
  if (part < model.parts.size()) json.value(part);
  else json.value(kNaN);
}

void write_type(JsonWriter& json, const OpeningType& type) {
  json.begin_object();
  json.name("type").value(type.tag);
  json.name("class").value(type.part_class);
  json.name("width_m").value(type.width_m);
  json.name("height_m").value(type.height_m);
  json.name("arched").value(type.arched);
  json.name("count").value(type.count);
  json.name("copies").value(type.copies);
  json.end_object();
}

void write_opening(JsonWriter& json, const OpeningRow& row, const OpeningList& openings,
                   const Model& model) {
  json.begin_object();
  json.name("name").value(row.name);
  json.name("class").value(row.part_class);
  json.name("class_confidence").value(row.class_confidence);
  json.name("type").value(openings.types[row.type].tag);
  write_place(json, "part", row.part, model);
  json.name("width_m").value(row.width_m);
  json.name("height_m").value(row.height_m);
  json.name("depth_m").value(row.depth_m);
  json.name("sigma_width_m").value(row.sigma_width_m);
  json.name("sigma_height_m").value(row.sigma_height_m);
  json.name("sigma_depth_m").value(row.sigma_depth_m);
  json.name("arched").value(row.arched);
  json.name("evidence").value(name_of(row.evidence));
  write_place(json, "copied_from", row.copied_from, model);
  json.end_object();
}

void write_part(JsonWriter& json, const Part& part, const Model& model, size_t faces) {
  json.begin_object();
  json.name("name").value(part.name);
  json.name("class").value(part.part_class);
  json.name("class_confidence").value(part.class_confidence);
  write_place(json, "parent", part.parent, model);
  json.name("faces").value(faces);
  json.name("width_m").value(part.width_m);
  json.name("height_m").value(part.height_m);
  json.name("depth_m").value(part.depth_m);
  json.name("evidence").value(name_of(part.evidence));
  write_place(json, "copied_from", part.copied_from, model);
  json.end_object();
}

}  // namespace

void write_model_parts(JsonWriter& json, const Model& model) {
  const OpeningList openings = list_openings(model, kTypeTolerance_m);
  json.name("opening_types").begin_array();
  for (const OpeningType& type : openings.types) write_type(json, type);
  json.end_array();
  json.name("openings").begin_array();
  for (const OpeningRow& row : openings.rows) write_opening(json, row, openings, model);
  json.end_array();
  const NoData no_data = no_data_of(model);
  json.name("no_data").begin_object();
  json.name("count").value(no_data.count);
  json.name("area_m2").value(no_data.area_m2);
  json.name("share").value(no_data.share());
  json.end_object();
  const PartTree tree(model);
  json.name("parts").begin_array();
  for (size_t i = 0; i < model.parts.size(); ++i)
    write_part(json, model.parts[i], model, tree.faces()[i].size());
  json.end_array();
}

}  // namespace jalon
