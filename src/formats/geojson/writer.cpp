// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>

#include "base/json_writer.h"
#include "formats/files/atomic_file.h"
#include "formats/geojson/geojson.h"
#include "formats/units/crs_code.h"
#include "model/chords.h"
#include "model/opening_rings.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

constexpr size_t kTicks = 256;  // features between two looks at the task

/// GeoJSON in the structure of RFC 7946. The coordinates are the model's own, in metres; RFC 7946 knows longitude and
/// latitude alone, so their system is said in the member that tools look for: "crs" of the GeoJSON of 2008. Where it is
/// not known that is a local system in metres: without one, or with null, tools take the numbers for degrees.
/// ("coordRefSys" of JSON-FG would have them look for the geometries elsewhere.)
class GeoJson {
 public:
  GeoJson(const Model& model, AtomicFile& file) : model_(model), file_(file) {}

  void write(Task& task) {
    json_.begin_object().name("type").value("FeatureCollection");
    add_crs();
    json_.name("features").begin_array();
    for (size_t f = 0; f < model_.faces.size(); ++f) {
      if (f % kTicks == 0)
        task.checkpoint(static_cast<double>(f) / static_cast<double>(model_.faces.size()));
      add_face(f);
      file_.write(json_.take());
    }
    add_openings();
    add_mesh(task);
    json_.end_array().end_object();
    file_.write(json_.take());
    file_.write("\n");
  }

 private:
  void add_crs() {
    constexpr const char* kLocal = "LOCAL_CS[\"local, metres\",UNIT[\"metre\",1]]";
    const uint32_t code = metric_epsg_code(model_.crs.str());
    const std::string name = code != 0 ? "urn:ogc:def:crs:EPSG::" + std::to_string(code) : kLocal;
    json_.name("crs").begin_object().name("type").value("name");
    json_.name("properties").begin_object().name("name").value(name).end_object().end_object();
  }

  void add_position(const Vec3& p) {
    json_.begin_array().value(p.x).value(p.y).value(p.z).end_array();
  }

  // Twice the area of the ring in plan: RFC 7946 wants outlines anticlockwise there, holes clockwise.
  double plan_area(const Ring& ring) const {
    double sum = 0;
    const auto corner = [&](uint64_t i) {
      const Vec3 p = model_.vertices[model_.corners[ring.first + i]] -
                     model_.vertices[model_.corners[ring.first]];
      return Vec2{p.x, p.y};
    };
    for (uint64_t i = 1; i + 1 < ring.count; ++i) sum += cross(corner(i), corner(i + 1));
    return sum;
  }

  void add_ring(const Ring& ring, bool turned) {
    json_.begin_array();
    for (uint64_t i = 0; i <= ring.count; ++i) {
      const uint64_t at = turned ? (2 * ring.count - i) % ring.count : i % ring.count;
      add_position(model_.vertices[model_.corners[ring.first + at]]);
    }
    json_.end_array();
  }

  void add_number(const char* name, double value) {
    if (std::isfinite(value)) json_.name(name).value(value);
  }

  void add_part(uint32_t index) {
    if (index >= model_.parts.size()) return;
    const Part& part = model_.parts[index];
    json_.name("class").value(part.part_class).name("name").value(part.name);
    if (part.parent < model_.parts.size())
      json_.name("part_of").value(model_.parts[part.parent].name);
    json_.name("evidence").value(name_of(part.evidence));
    json_.name("copied").value(part.evidence == Evidence::kCopied);
    if (part.copied_from < model_.parts.size())
      json_.name("copied_from").value(model_.parts[part.copied_from].name);
    add_number("width_m", part.width_m);
    add_number("height_m", part.height_m);
    add_number("depth_m", part.depth_m);
    add_number("class_confidence", part.class_confidence);
  }

  void add_face(size_t f) {
    const Face& face = model_.faces[f];
    if (face.ring_count == 0 || model_.rings[face.first_ring].count < 3) return;
    const bool turned = plan_area(model_.rings[face.first_ring]) < 0;
    json_.begin_object().name("type").value("Feature").name("id").value(f);
    json_.name("geometry")
        .begin_object()
        .name("type")
        .value("Polygon")
        .name("coordinates")
        .begin_array();
    for (uint64_t r = 0; r < face.ring_count; ++r)
      if (const Ring& ring = model_.rings[face.first_ring + r]; ring.count >= 3)
        add_ring(ring, turned);
    json_.end_array().end_object().name("properties").begin_object();
    json_.name("face").value(face.id);
    add_part(face.part);
    add_number("area_m2", face.area_m2);
    add_number("sigma_m", face.sigma_m);
    const Vec3 n = normal_of(model_, face);
    json_.name("normal_x").value(n.x).name("normal_y").value(n.y).name("normal_z").value(n.z);
    json_.end_object().end_object();
  }

  // A feature for each opening that has no face of its own: what shows where it is (opening_rings.h).
  void add_openings() {
    const auto rings = opening_rings(model_);
    size_t id = model_.faces.size();
    for (uint32_t part = 0; part < model_.parts.size(); ++part) {
      if (!part_class::is_opening(model_.parts[part].part_class)) continue;
      const bool is_drawn = !rings[part].empty();
      if (is_drawn && model_.faces[rings[part].front().face].part == part) continue;
      json_.begin_object().name("type").value("Feature").name("id").value(id++).name("geometry");
      if (is_drawn) add_outline(model_.rings[rings[part].front().ring]);
      else json_.value(JsonValue{});
      json_.name("properties").begin_object();
      add_part(part);
      json_.end_object().end_object();
      file_.write(json_.take());
    }
  }

  void add_outline(const Ring& ring) {
    json_.begin_object().name("type").value("Polygon").name("coordinates").begin_array();
    if (ring.count >= 3) add_ring(ring, plan_area(ring) < 0);
    json_.end_array().end_object();
  }

  // A mesh: one feature for the triangles of each face number.
  void add_mesh(Task& task) {
    std::map<uint32_t, std::vector<uint32_t>> by_id;
    for (const uint32_t t : loose_triangles(model_)) by_id[model_.triangle_faces[t]].push_back(t);
    const bool by_part = is_mesh_by_part(model_);
    size_t done = 0;
    for (const auto& [id, triangles] : by_id) {
      json_.begin_object().name("type").value("Feature");
      json_.name("geometry")
          .begin_object()
          .name("type")
          .value("MultiPolygon")
          .name("coordinates")
          .begin_array();
      for (const uint32_t t : triangles) {
        if (done++ % kTicks == 0) {
          task.checkpoint(static_cast<double>(done) / static_cast<double>(model_.triangles.size()));
          file_.write(json_.take());
        }
        json_.begin_array().begin_array();
        for (const size_t k : {0, 1, 2, 0}) add_position(model_.vertices[model_.triangles[t][k]]);
        json_.end_array().end_array();
      }
      json_.end_array().end_object().name("properties").begin_object().name("face").value(id);
      if (by_part) add_part(id);
      json_.end_object().end_object();
    }
  }

  const Model& model_;
  AtomicFile& file_;
  JsonWriter json_;
};

}  // namespace

void write_geojson(const Model& model, const std::string& path, const WriteSettings& settings,
                   Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing GeoJSON");
  validate(model);
  AtomicFile file(path);
  if (has_arcs(model)) GeoJson(with_chords(model, settings.chord_error_m), file).write(task);
  else GeoJson(model, file).write(task);
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
