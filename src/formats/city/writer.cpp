// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/json_writer.h"
#include "formats/city/city.h"
#include "formats/city/geometry.h"
#include "formats/city/parts.h"
#include "formats/files/atomic_file.h"
#include "formats/files/utf8.h"
#include "formats/units/crs_code.h"
#include "model/chords.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

using namespace city;

constexpr size_t kWriterTicks = 1024;  // surfaces or vertices between two looks at the task

/// The semantic surfaces of one geometry: a part each, in the order of their first polygon.
struct Semantics {
  std::vector<uint32_t> parts;
  std::map<uint32_t, uint32_t> index;

  explicit Semantics(const Geometry& geometry) {
    for (const Surface& surface : geometry.surfaces)
      if (surface.part != kNoPart &&
          index.try_emplace(surface.part, static_cast<uint32_t>(parts.size())).second)
        parts.push_back(surface.part);
  }
};

/// CityJSON 2.0 (https://www.cityjson.org/specs/2.0.1): buildings with their surfaces at level of detail 3, or 2 where
/// there are no openings. Attributes of the surfaces keep what the model knows of its parts.
class CityFile {
 public:
  CityFile(const Model& model, const PartAttributes& attributes, double scale_m, AtomicFile& file,
           Task& task)
      : model_(model),
        attributes_(attributes),
        file_(file),
        grid_(model, scale_m),
        city_(arrange(model, grid_, task)) {
    used_.assign(model.parts.size(), 0);
    UniqueNames unique;
    for (const auto& [part, object] : city_.objects) {
      for (const Geometry& geometry : object.geometries)
        for (const Surface& surface : geometry.surfaces)
          if (surface.part != kNoPart) used_[surface.part] = 1;
      const std::string name = part == kNoPart ? "" : valid_utf8(model.parts[part].name);
      ids_[part] = unique.add(name.empty() ? "building" : name);
    }
  }

  void write(Task& task) {
    if (city_.dropped != 0)
      task.log(Task::kWarning,
               "CityJSON: %zu faces smaller than the step of the coordinates left out",
               city_.dropped);
    json_.begin_object().name("type").value("CityJSON").name("version").value("2.0");
    json_.name("transform").begin_object().name("scale").begin_array();
    for (int k = 0; k < 3; ++k) json_.value(grid_.scale_m());
    json_.end_array().name("translate");
    add_point(grid_.translate());
    json_.end_object();
    add_metadata();
    json_.name("CityObjects").begin_object();
    for (const auto& [part, object] : city_.objects) add_object(part, object, task);
    json_.end_object().name("vertices").begin_array();
    for (size_t i = 0; i < grid_.steps().size(); ++i) {
      if (i % kWriterTicks == 0) flush(task);
      json_.begin_array();
      for (const int64_t step : grid_.steps()[i]) json_.value(step);
      json_.end_array();
    }
    json_.end_array().end_object();
    flush(task);
    file_.write("\n");
  }

 private:
  void flush(Task& task) {
    task.checkpoint(0.5);
    file_.write(json_.take());
  }

  void add_point(const Vec3& p) {
    json_.begin_array().value(p.x).value(p.y).value(p.z).end_array();
  }

  void add_metadata() {
    json_.name("metadata").begin_object();
    if (!grid_.steps().empty()) {
      Box3 box;
      for (uint32_t i = 0; i < grid_.steps().size(); ++i) box.add(grid_.place(i));
      json_.name("geographicalExtent").begin_array();
      for (const Vec3& p : {box.min, box.max}) json_.value(p.x).value(p.y).value(p.z);
      json_.end_array();
    }
    if (const uint32_t code = metric_epsg_code(model_.crs.str()); code != 0)
      json_.name("referenceSystem")
          .value("https://www.opengis.net/def/crs/EPSG/0/" + std::to_string(code));
    json_.end_object();
  }

  void add_number(const char* name, double value) {
    if (std::isfinite(value)) json_.name(name).value(value);
  }

  // "part" and "part_of" are the numbers of the tree of parts, from which a reader builds it again.
  void add_part(uint32_t index) {
    const Part& part = model_.parts[index];
    json_.name("part").value(index);
    if (part.parent < model_.parts.size()) json_.name("part_of").value(part.parent);
    json_.name("name").value(part.name).name("class").value(part.part_class);
    if (part.evidence != Evidence::kNone) json_.name("evidence").value(name_of(part.evidence));
    if (part.copied_from < model_.parts.size()) json_.name("copied_from").value(part.copied_from);
    if (part.level_of_detail != 0) json_.name("level_of_detail").value(part.level_of_detail);
    add_number("width_m", part.width_m);
    add_number("height_m", part.height_m);
    add_number("depth_m", part.depth_m);
    add_number("class_confidence", part.class_confidence);
    if (index >= attributes_.of_part.size()) return;
    for (const auto& [name, value, is_whole] : attributes_.of_part[index])
      if (is_whole) json_.name(name).value(static_cast<uint64_t>(value));
      else add_number(name.c_str(), value);
  }

  // What belongs to the faces of a part: one value, or one a face.
  void add_faces(uint32_t part) {
    const std::vector<uint32_t>& faces = city_.faces_of_part[part];
    const auto list = [&](const char* name, auto&& value) {
      json_.name(name);
      if (faces.size() > 1) json_.begin_array();
      for (const uint32_t f : faces) json_.value(value(model_.faces[f]));
      if (faces.size() > 1) json_.end_array();
    };
    if (faces.empty()) return;
    list("face", [](const Face& face) { return face.id; });
    list("area_m2", [](const Face& face) { return face.area_m2; });
    list("sigma_m", [](const Face& face) { return face.sigma_m; });
  }

  void add_object(uint32_t part, const Object& object, Task& task) {
    json_.name(ids_[part]).begin_object();
    json_.name("type").value(object_type(part, object));
    json_.name("attributes").begin_object();
    if (part != kNoPart) add_part(part);
    if (part == city_.objects.begin()->first) add_groups();
    json_.end_object();
    if (object.parent != kNoPart)
      json_.name("parents").begin_array().value(ids_[object.parent]).end_array();
    add_children(part);
    json_.name("geometry").begin_array();
    for (const Geometry& geometry : object.geometries) add_geometry(geometry, task);
    json_.end_array().end_object();
  }

  const char* object_type(uint32_t part, const Object& object) const {
    if (object.parent == kNoPart) return "Building";
    const bool is_gutter = model_.parts[part].part_class == part_class::kGutter;
    return is_gutter ? "BuildingInstallation" : "BuildingPart";
  }

  void add_children(uint32_t part) {
    bool any = false;
    for (const auto& [other, object] : city_.objects) {
      if (part == kNoPart || object.parent != part) continue;
      if (!any) json_.name("children").begin_array();
      any = true;
      json_.value(ids_[other]);
    }
    if (any) json_.end_array();
  }

  // Parts that have no surface of their own: facades, and windows that consist of frame and pane.
  void add_groups() {
    json_.name("groups").begin_array();
    for (uint32_t p = 0; p < model_.parts.size(); ++p) {
      if (used_[p] != 0 || city_.objects.contains(p)) continue;
      json_.begin_object();
      add_part(p);
      json_.end_object();
    }
    json_.end_array();
  }

  void add_geometry(const Geometry& geometry, Task& task) {
    json_.begin_object().name("type").value(geometry.solid ? "Solid" : "MultiSurface");
    json_.name("lod").value(city_.has_openings ? "3" : "2");
    json_.name("boundaries").begin_array();
    if (geometry.solid) json_.begin_array();
    for (size_t s = 0; s < geometry.surfaces.size(); ++s) {
      if (s % kWriterTicks == 0) flush(task);
      json_.begin_array();
      for (const auto& ring : geometry.surfaces[s].rings) {
        json_.begin_array();
        for (const uint32_t vertex : ring) json_.value(vertex);
        json_.end_array();
      }
      json_.end_array();
    }
    if (geometry.solid) json_.end_array();
    json_.end_array();
    add_semantics(geometry);
    json_.end_object();
  }

  void add_semantics(const Geometry& geometry) {
    const Semantics semantics(geometry);
    if (semantics.parts.empty()) return;
    json_.name("semantics").begin_object().name("surfaces").begin_array();
    std::vector<std::vector<uint32_t>> children(semantics.parts.size());
    std::vector<uint32_t> parent(semantics.parts.size(), kNoPart);
    for (uint32_t i = 0; i < semantics.parts.size(); ++i) {
      parent[i] = parent_surface(semantics, i);
      if (parent[i] != kNoPart) children[parent[i]].push_back(i);
    }
    for (uint32_t i = 0; i < semantics.parts.size(); ++i) {
      const uint32_t part = semantics.parts[i];
      json_.begin_object().name("type").value(surface_type(model_, part));
      if (parent[i] != kNoPart) json_.name("parent").value(parent[i]);
      if (!children[i].empty()) {
        json_.name("children").begin_array();
        for (const uint32_t child : children[i]) json_.value(child);
        json_.end_array();
      }
      add_part(part);
      if (city_.closing[part] != 0) json_.name("closes_opening").value(true);
      add_faces(part);
      json_.end_object();
    }
    json_.end_array().name("values").begin_array();
    if (geometry.solid) json_.begin_array();
    for (const Surface& surface : geometry.surfaces) {
      if (surface.part == kNoPart) json_.value(JsonValue{});
      else json_.value(semantics.index.at(surface.part));
    }
    if (geometry.solid) json_.end_array();
    json_.end_array().end_object();
  }

  // Windows and doors are children of the wall whose hole they fill, their frames and panes too.
  uint32_t parent_surface(const Semantics& semantics, uint32_t i) const {
    const std::string type = surface_type(model_, semantics.parts[i]);
    if (type != "Window" && type != "Door") return kNoPart;
    uint64_t part = semantics.parts[i];
    for (size_t steps = 0; part < model_.parts.size() && steps <= model_.parts.size(); ++steps) {
      const uint32_t wall = city_.wall_of_opening[part];
      const auto found = semantics.index.find(wall != kNoPart ? wall : static_cast<uint32_t>(part));
      if (found != semantics.index.end() && found->second != i &&
          std::string_view(surface_type(model_, found->first)) == "WallSurface")
        return found->second;
      part = model_.parts[part].parent;
    }
    return kNoPart;
  }

  const Model& model_;
  const PartAttributes& attributes_;
  AtomicFile& file_;
  JsonWriter json_;
  Grid grid_;
  City city_;
  std::vector<uint8_t> used_;
  std::map<uint32_t, std::string> ids_;
};

}  // namespace

void write_city(const Model& model, const std::string& path, const WriteSettings& settings,
                Task& task) {
  write_city_attributes(model, {}, path, settings, task);
}

void write_city_attributes(const Model& model, const PartAttributes& attributes,
                           const std::string& path, const WriteSettings& settings, Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing CityJSON");
  validate(model);
  AtomicFile file(path);
  const double scale_m = settings.city_scale_m;
  if (has_arcs(model))
    CityFile(with_chords(model, settings.chord_error_m), attributes, scale_m, file, task)
        .write(task);
  else CityFile(model, attributes, scale_m, file, task).write(task);
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
