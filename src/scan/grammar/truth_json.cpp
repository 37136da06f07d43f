// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json_writer.h"
#include "scan/facade_truth.h"

namespace jalon {

namespace {

void write(JsonWriter& json, const Vec3& p) {
  json.begin_array().value(p.x).value(p.y).value(p.z).end_array();
}

void write(JsonWriter& json, const TruthContour& contour) {
  json.begin_array();
  for (const TruthCorner& c : contour)
    json.begin_array().value(c.at.u).value(c.at.v).value(c.sagitta_m).end_array();
  json.end_array();
}

void write(JsonWriter& json, const SightRaster& raster) {
  json.begin_object().name("cell_m").value(raster.cell_m);
  json.name("low").begin_array().value(raster.low.u).value(raster.low.v).end_array();
  json.name("rows").begin_array();
  for (uint32_t j = 0; j < raster.rows; ++j) {
    std::string row;
    for (uint32_t i = 0; i < raster.columns; ++i)
      row += static_cast<char>(raster.cells[static_cast<size_t>(j) * raster.columns + i]);
    json.value(row);
  }
  json.end_array().end_object();
}

void write(JsonWriter& json, const TruthWall& wall) {
  json.begin_object().name("name").value(wall.name);
  for (const auto& [name, v] : {std::pair{"origin", &wall.origin},
                                {"along", &wall.along},
                                {"up", &wall.up},
                                {"normal", &wall.normal}}) {
    json.name(name);
    write(json, *v);
  }
  json.name("outline");
  write(json, wall.outline);
  json.name("covers").begin_array();
  for (const TruthWall::Cover& cover : wall.covers) {
    json.begin_object().name("outline");
    write(json, cover.outline);
    json.name("holes").begin_array();
    for (const TruthContour& hole : cover.holes) write(json, hole);
    json.end_array().end_object();
  }
  json.end_array();
  json.name("area_m2").value(wall.area_m2).name("seen_share").value(wall.seen_share);
  json.name("hidden_share").value(wall.hidden_share);
  json.name("never_share").value(wall.never_share);
  json.name("raster");
  write(json, wall.raster);
  json.end_object();
}

void write(JsonWriter& json, const TruthOpening& o) {
  json.begin_object().name("wall").value(o.wall);
  json.name("class").value(name_of(o.opening_class)).name("contour");
  write(json, o.contour);
  json.name("depth_m").value(o.depth_m).name("storey").value(o.storey);
  json.name("touches_ground").value(o.touches_ground);
  json.name("touches_border").value(o.touches_border);
  json.name("outline_seen_share").value(o.outline_seen_share);
  json.name("area_seen_share").value(o.area_seen_share);
  json.name("spacing_m").value(o.spacing_m).name("width_spacings").value(o.width_spacings);
  json.end_object();
}

}  // namespace

std::string json_of(const FacadeTruth& truth) {
  JsonWriter json;
  json.begin_object().name("shape").value("jalon facade truth 1");
  json.name("scene").value("grammar").name("kind").value(truth.kind);
  json.name("seed").value(truth.seed).name("walls").begin_array();
  for (const TruthWall& wall : truth.walls) write(json, wall);
  json.end_array().name("openings").begin_array();
  for (const TruthOpening& o : truth.openings) write(json, o);
  return json.end_array().end_object().take();
}

}  // namespace jalon
