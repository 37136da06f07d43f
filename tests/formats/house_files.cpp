// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Writes the house of the unit tests in every format, and its tables as model.json: house_files FOLDER
#include <cstdio>
#include <string_view>

#include "base/error.h"
#include "base/json_writer.h"
#include "formats/files/atomic_file.h"
#include "formats/formats.h"
#include "formats/geopackage/sqlite_database.h"
#include "unit/formats/house.h"

using namespace jalon;

namespace {

std::string tables(const Model& model) {
  JsonWriter json;
  json.begin_object().name("vertices").begin_array();
  for (const Vec3& p : model.vertices)
    json.begin_array().value(p.x).value(p.y).value(p.z).end_array();
  json.end_array().name("corners").begin_array();
  for (const uint32_t v : model.corners) json.value(v);
  json.end_array().name("sagittas").begin_array();
  for (size_t c = 0; c < model.corners.size(); ++c) json.value(model.sagitta(c));
  json.end_array().name("rings").begin_array();
  for (const Ring& r : model.rings)
    json.begin_array().value(r.first).value(r.count).value(r.part).end_array();
  json.end_array().name("faces").begin_array();
  for (const Face& f : model.faces) {
    const Vec3& n = f.plane.normal;
    json.begin_array()
        .value(f.part)
        .value(f.first_ring)
        .value(f.ring_count)
        .value(f.id)
        .value(f.area_m2);
    json.value(n.x).value(n.y).value(n.z).end_array();
  }
  json.end_array().name("parts").begin_array();
  for (const Part& p : model.parts)
    json.begin_array()
        .value(p.name)
        .value(p.part_class)
        .value(static_cast<int>(p.evidence))
        .value(p.parent == kNoParent ? int64_t{-1} : static_cast<int64_t>(p.parent))
        .end_array();
  json.end_array().name("solids").begin_array();
  for (const Solid& s : model.solids)
    json.begin_array().value(s.part).value(s.first_face).value(s.face_count).end_array();
  return json.end_array().end_object().take();
}

void write_all(const Model& model, const std::string& folder) {
  struct File {
    const char *name, *option, *value;
  };
  constexpr File kFiles[] = {
      {"r2000.dxf", "dxf_version", "r2000"},
      {"r12.dxf", "dxf_version", "r12"},
      {"elevation.dxf", "dxf_view", "elevation"},
      {"model.city.json", nullptr, nullptr},
      {"model.geojson", nullptr, nullptr},
      {"model.obj", nullptr, nullptr},
      {"binary.stl", "stl_format", "binary"},
      {"ascii.stl", "stl_format", "ascii"},
      {"model.ply", nullptr, nullptr},
      {"model.ifc", nullptr, nullptr},
      {"solid.ifc", nullptr, nullptr},
      {"model.gpkg", nullptr, nullptr},
  };
  Task task;
  for (const File& file : kFiles) {
    if (std::string_view(file.name) == "model.gpkg" && !has_sqlite()) continue;
    ParamSet options("write", write_rows());
    if (file.option != nullptr) options.set_text(file.option, file.value);
    auto settings = settings_from<WriteSettings>(options);
    if (std::string_view(file.name) == "solid.ifc") settings.ifc_wall_thickness_m = 0.3;
    write_model(model, folder + "/" + file.name, settings, task);
  }
  AtomicFile json(folder + "/model.json");
  json.write(tables(model));
  json.commit();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    write_all(test::House().model(), argv[1]);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
