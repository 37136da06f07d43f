// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "formats/facade_views.h"
#include "formats/files/atomic_file.h"
#include "formats/files/utf8.h"
#include "formats/geopackage/geopackage.h"
#include "formats/geopackage/layer.h"
#include "formats/geopackage/plan.h"
#include "formats/geopackage/reference_system.h"
#include "model/chords.h"
#include "model/opening_rings.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon {

namespace {

using namespace gpkg;

constexpr size_t kFeatureTicks = 256;          // features between two looks at the task
constexpr uint32_t kApplication = 0x47504B47;  // "GPKG"
constexpr int kVersion = 10300;                // 1.3.0

constexpr char kPartColumns[] =
    "class TEXT, name TEXT, part_of TEXT, facade TEXT, evidence TEXT, copied BOOLEAN, copied_from "
    "TEXT, width_m DOUBLE, height_m DOUBLE, depth_m DOUBLE, class_confidence DOUBLE";
constexpr size_t kPartColumnCount = 11, kFacadeColumn = 3;
constexpr char kFaceColumns[] =
    "face INTEGER, area_m2 DOUBLE, sigma_m DOUBLE, normal_x DOUBLE, normal_y DOUBLE, normal_z "
    "DOUBLE";

constexpr size_t kFaceColumnCount = 6;

std::string columns_of(std::initializer_list<const char*> lists) {
  std::string out;
  for (const char* list : lists) out += (out.empty() ? "" : ", ") + std::string(list);
  return out;
}

using Values = std::vector<Value>;

Value number(double value) { return std::isfinite(value) ? Value(value) : Value(); }

/// A model without arcs as layers.
class GeoPackage {
 public:
  GeoPackage(const Model& model, double plan_height_m)
      : model_(model),
        plan_height_m_(plan_height_m),
        facades_(faces_by_facade(model)),
        facade_of_face_(model.faces.size(), kNoFacade),
        opening_rings_(opening_rings(model)) {
    for (const auto& [facade, faces] : facades_)
      for (const uint32_t f : faces) facade_of_face_[f] = facade;
  }

  void write(AtomicFile& file, Task& task) {
    database_.run("PRAGMA page_size = 4096; PRAGMA auto_vacuum = NONE; PRAGMA application_id = " +
                  std::to_string(kApplication) +
                  "; PRAGMA user_version = " + std::to_string(kVersion) + "; BEGIN");
    srs_id_ = add_reference_systems(database_, model_.crs.str());
    add_layer_lists(database_);
    add_faces(task);
    add_openings(task);
    add_elevation(task);
    add_plan(task);
    add_mesh(task);
    database_.run("COMMIT");
    database_.give_bytes([&](std::string_view bytes) { file.write(bytes); });
  }

 private:
  // ---- what is known of a part or a face ----
  Value name_of_part(uint64_t part) const {
    return part < model_.parts.size() ? Value(valid_utf8(model_.parts[part].name)) : Value();
  }

  Values part_values(uint32_t index, uint32_t facade) const {
    if (index >= model_.parts.size()) {
      Values none(kPartColumnCount);
      none[kFacadeColumn] = name_of_part(facade);
      return none;
    }
    const Part& part = model_.parts[index];
    return {valid_utf8(part.part_class),
            name_of_part(index),
            name_of_part(part.parent),
            name_of_part(facade),
            std::string(name_of(part.evidence)),
            int64_t{part.evidence == Evidence::kCopied},
            name_of_part(part.copied_from),
            number(part.width_m),
            number(part.height_m),
            number(part.depth_m),
            number(part.class_confidence)};
  }

  Values kind_and_part(const char* kind, uint32_t part, uint32_t facade) const {
    Values values{std::string(kind)};
    for (Value& value : part_values(part, facade)) values.push_back(std::move(value));
    return values;
  }

  void append_face(Values& values, const Face& face) const {
    const Vec3 n = normal_of(model_, face);
    for (const Value& value : {Value(int64_t{face.id}), number(face.area_m2), number(face.sigma_m),
                               Value(n.x), Value(n.y), Value(n.z)})
      values.push_back(value);
  }

  uint32_t facade_of_face(size_t f) const { return facade_of_face_[f]; }

  Line ring_of(uint64_t r) const {
    const Ring& ring = model_.rings[r];
    Line out;
    for (uint64_t i = 0; i < ring.count; ++i)
      out.push_back(model_.vertices[model_.corners[ring.first + i]]);
    return out;
  }

  // Empty without an outline.
  Polygon polygon_of(const Face& face) const {
    Polygon out;
    for (uint64_t r = 0; r < face.ring_count; ++r) {
      Line ring = ring_of(face.first_ring + r);
      if (ring.size() >= 3) out.push_back(std::move(ring));
      else if (r == 0) return {};
    }
    return out;
  }

  bool is_shown_opening(uint32_t part) const {
    return part_class::is_opening(model_.parts[part].part_class) && !opening_rings_[part].empty();
  }

  // ---- layers in space ----
  void add_faces(Task& task) {
    Layer layer(database_,
                {"faces", "POLYGON", "Faces with their holes, where they are in space",
                 columns_of({kPartColumns, kFaceColumns})},
                srs_id_);
    for (uint32_t f = 0; f < model_.faces.size(); ++f) {
      if (f % kFeatureTicks == 0)
        task.checkpoint(0.5 * static_cast<double>(f) / static_cast<double>(model_.faces.size()));
      const Face& face = model_.faces[f];
      const Polygon polygon = polygon_of(face);
      if (polygon.empty()) continue;
      Values values = part_values(face.part, facade_of_face(f));
      append_face(values, face);
      layer.add(polygon, values);
    }
    layer.end();
  }

  void add_openings(Task& task) {
    task.checkpoint(0.5);
    Layer layer(database_, {"openings", "POLYGON", "Outlines of openings in space", kPartColumns},
                srs_id_);
    for (uint32_t part = 0; part < model_.parts.size(); ++part) {
      if (!is_shown_opening(part)) continue;
      const OpeningRing& shown = opening_rings_[part].front();
      const Line ring = ring_of(shown.ring);
      if (ring.size() >= 3) layer.add(Polygon{ring}, part_values(part, facade_of_face(shown.face)));
    }
    layer.end();
  }

  // ---- the unrolled facades ----
  struct Drawn {
    Polygon polygon;
    Values values;
    double depth_m = 0;
  };

  void add_drawn(std::vector<Drawn>& out, const PlacedFacade& facade, Polygon polygon,
                 Values values) const {
    double sum_m = 0;
    for (Line& ring : polygon)
      for (Vec3& p : ring) p = facade.on_sheet(p);
    for (const Vec3& p : polygon.front()) sum_m += p.z;
    const double depth_m = sum_m / static_cast<double>(polygon.front().size());
    out.push_back({std::move(polygon), std::move(values), depth_m});
  }

  std::vector<Drawn> drawn_faces(const PlacedFacade& facade) const {
    std::vector<Drawn> out;
    for (const uint32_t f : facade.shown) {
      const Face& face = model_.faces[f];
      Polygon polygon = polygon_of(face);
      if (polygon.empty()) continue;
      Values values = kind_and_part("face", face.part, facade.facade);
      append_face(values, face);
      add_drawn(out, facade, std::move(polygon), std::move(values));
    }
    return out;
  }

  // Behind all faces, so that joinery lies before them.
  std::vector<Drawn> drawn_openings(const PlacedFacade& facade) const {
    std::vector<Drawn> out;
    for (uint32_t part = 0; part < model_.parts.size(); ++part) {
      if (!is_shown_opening(part)) continue;
      const OpeningRing& shown = opening_rings_[part].front();
      if (facade_of_face(shown.face) != facade.facade) continue;
      Line ring = ring_of(shown.ring);
      if (ring.size() < 3) continue;
      Values values = kind_and_part("opening", part, facade.facade);
      values.resize(values.size() + kFaceColumnCount);
      add_drawn(out, facade, {std::move(ring)}, std::move(values));
    }
    return out;
  }

  void add_elevation(Task& task) {
    Layer layer(database_,
                {"elevation", "POLYGON",
                 "Facades unrolled side by side: x along them, y the height, z before their front",
                 columns_of({"kind TEXT", kPartColumns, kFaceColumns})},
                kLocalCartesian);
    for (const PlacedFacade& facade : facades_side_by_side(model_)) {
      task.checkpoint(0.6);
      for (const Drawn& one : drawn_openings(facade)) layer.add(one.polygon, one.values);
      const std::vector<Drawn> drawn = drawn_faces(facade);
      std::vector<double> depths_m;
      for (const Drawn& one : drawn) depths_m.push_back(one.depth_m);
      for (const size_t i : order_of_drawing(depths_m))
        layer.add(drawn[i].polygon, drawn[i].values);
    }
    layer.end();
  }

  // ---- the plan ----
  void add_plan(Task& task) {
    task.checkpoint(0.8);
    Layer layer(database_,
                {"plan", "LINESTRING",
                 "Upright faces cut at a height above the foot of their facade; openings as gaps, "
                 "and as lines of their own",
                 columns_of({"kind TEXT", kPartColumns, "face INTEGER, length_m DOUBLE"})},
                srs_id_);
    for (const auto& [facade, faces] : facades_) {
      const double level_m = section_level_m(model_, faces, plan_height_m_);
      if (!std::isfinite(level_m)) continue;
      for (const SectionLine& line : section_of(model_, faces, level_m)) {
        Values values = kind_and_part(line.is_opening ? "opening" : "face", line.part, facade);
        if (line.part >= model_.parts.size() && line.is_opening)
          values[1] = std::string(part_class::kOpening);
        values.emplace_back(int64_t{model_.faces[line.face].id});
        values.emplace_back(norm(line.to - line.from));
        layer.add(Line{line.from, line.to}, values);
      }
    }
    layer.end();
  }

  // ---- triangles of no face, a feature for each number ----
  void add_mesh(Task& task) {
    std::map<uint32_t, std::vector<uint32_t>> by_id;
    for (const uint32_t t : loose_triangles(model_)) by_id[model_.triangle_faces[t]].push_back(t);
    if (by_id.empty()) return;
    Layer layer(database_,
                {"mesh", "MULTIPOLYGON", "Triangles by their number",
                 columns_of({kPartColumns, "face INTEGER"})},
                srs_id_);
    const bool by_part = is_mesh_by_part(model_);
    for (const auto& [id, triangles] : by_id) {
      task.checkpoint(0.9);
      std::vector<Polygon> polygons;
      for (const uint32_t t : triangles) {
        const auto& corners = model_.triangles[t];
        polygons.push_back({{model_.vertices[corners[0]], model_.vertices[corners[1]],
                             model_.vertices[corners[2]]}});
      }
      const uint32_t part = by_part ? id : kNoPart;
      Values values = part_values(part, facade_of(model_, part));
      values.emplace_back(int64_t{id});
      layer.add(polygons, values);
    }
    layer.end();
  }

  const Model& model_;
  double plan_height_m_;
  std::map<uint32_t, std::vector<uint32_t>> facades_;
  std::vector<uint32_t> facade_of_face_;
  std::vector<std::vector<OpeningRing>> opening_rings_;
  Database database_;
  int32_t srs_id_ = kLocalCartesian;
};

}  // namespace

void write_geopackage(const Model& model, const std::string& path, const WriteSettings& settings,
                      Task& task) {
  require_sqlite(path, "GeoPackage");
  ProgressSpan span(task, 0, 0.99, "writing GeoPackage");
  validate(model);
  AtomicFile file(path);
  const double height_m = settings.gpkg_plan_height_m;
  if (has_arcs(model))
    GeoPackage(with_chords(model, settings.chord_error_m), height_m).write(file, task);
  else GeoPackage(model, height_m).write(file, task);
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
