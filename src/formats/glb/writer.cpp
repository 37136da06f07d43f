// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// glTF 2.0 (Khronos 2021) in its binary form: a header of 12 bytes, JSON, the numbers that it describes.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string_view>

#include "base/error.h"
#include "base/json_writer.h"
#include "formats/face_geometry.h"
#include "formats/files/atomic_file.h"
#include "formats/files/endian.h"
#include "formats/files/utf8.h"
#include "formats/glb/glb.h"
#include "formats/glb/meshes.h"
#include "model/chords.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

using namespace glb;

enum : int { kFloat = 5126, kUint32 = 5125, kVertices = 34962, kIndices = 34963 };
enum : int { kLines = 1, kTriangles = 4 };
constexpr uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A,
                   kBinChunk = 0x004E4942;

struct Material {
  const char* part_class;
  double red, green, blue;
};
// Of render, joinery, earth; the last for all other classes.
constexpr Material kMaterials[] = {{part_class::kWall, 0.86, 0.80, 0.70},
                                   {part_class::kWindow, 0.25, 0.42, 0.62},
                                   {part_class::kJoinery, 0.30, 0.45, 0.60},
                                   {part_class::kDoor, 0.45, 0.29, 0.14},
                                   {part_class::kReveal, 0.75, 0.69, 0.60},
                                   {"ground", 0.55, 0.52, 0.45},
                                   {"roof", 0.62, 0.30, 0.22},
                                   {"", 0.72, 0.72, 0.72}};

size_t material_of(const Model& model, uint32_t part) {
  constexpr size_t kOther = std::size(kMaterials) - 1;
  if (part == kNoPart) return kOther;
  for (size_t m = 0; m < kOther; ++m)
    if (model.parts[part].part_class == kMaterials[m].part_class) return m;
  return kOther;
}

/// The numbers, and what the JSON says of them.
struct Numbers {
  std::string bytes;
  JsonWriter views, accessors;
  size_t count = 0;

  Numbers() {
    views.begin_array();
    accessors.begin_array();
  }

  /// Gives the number of the accessor. bounds: places must tell theirs.
  size_t add(const std::vector<Float3>& values, bool bounds) {
    describe(values.size(), 12 * values.size(), kFloat, kVertices, "VEC3");
    if (bounds) {
      for (const bool least : {true, false}) {
        accessors.name(least ? "min" : "max").begin_array();
        for (size_t k = 0; k < 3; ++k) {
          float end = values[0][k];
          for (const Float3& v : values) end = least ? std::min(end, v[k]) : std::max(end, v[k]);
          accessors.value(static_cast<double>(end));
        }
        accessors.end_array();
      }
    }
    for (const Float3& v : values)
      for (const float x : v) put(x);
    accessors.end_object();
    return count++;
  }
  size_t add(const std::vector<uint32_t>& values) {
    describe(values.size(), 4 * values.size(), kUint32, kIndices, "SCALAR");
    for (const uint32_t v : values) put(v);
    accessors.end_object();
    return count++;
  }

 private:
  template <class T>
  void put(T value) {
    char raw[sizeof(T)];
    store<T>(reinterpret_cast<std::byte*>(raw), value);
    bytes.append(raw, sizeof raw);
  }
  void describe(size_t items, size_t size, int type, int target, const char* shape) {
    views.begin_object().name("buffer").value(0).name("byteOffset").value(bytes.size());
    views.name("byteLength").value(size).name("target").value(target).end_object();
    accessors.begin_object().name("bufferView").value(count).name("componentType").value(type);
    accessors.name("count").value(items).name("type").value(shape);
  }
};

void write_primitive(JsonWriter& json, int mode, size_t places, const size_t* normals,
                     size_t corners, size_t material) {
  json.begin_object().name("mode").value(mode).name("attributes").begin_object();
  json.name("POSITION").value(places);
  if (normals != nullptr) json.name("NORMAL").value(*normals);
  json.end_object().name("indices").value(corners).name("material").value(material).end_object();
}

void write_known(JsonWriter& json, const char* name, double value) {
  if (std::isfinite(value)) json.name(name).value(value);
}

/// Nodes: the root, then those parts that show something or have a child that does, then the loose triangles.
class Writer {
 public:
  Writer(const Model& model, Task& task)
      : model_(model),
        origin_(whole_metre_corner(model)),
        meshes_(meshes_of(model, origin_, task)) {}

  std::string json() {
    number_nodes();
    JsonWriter json;
    json.begin_object().name("asset").begin_object();
    json.name("version").value("2.0").name("generator").value("Jalon").end_object();
    if (!meshes_.empty()) write_content(json);
    json.end_object();
    return json.take();
  }
  const std::string& bytes() const { return numbers_.bytes; }

 private:
  // The tree of parts, cut to what is seen; parents that name each other have none.
  void number_nodes() {
    std::vector<bool> shown(model_.parts.size(), false);
    for (const Mesh& mesh : meshes_)
      for (uint64_t p = mesh.part; p < model_.parts.size() && !shown[p]; p = model_.parts[p].parent)
        shown[p] = true;
    for (uint32_t p = 0; p < model_.parts.size(); ++p)
      if (shown[p]) node_of_[p] = 1 + node_of_.size();
    children_.resize(1 + node_of_.size());
    for (const auto& [part, node] : node_of_) {
      const uint64_t parent = model_.parts[part].parent;
      const bool is_below = parent < model_.parts.size() && !is_in_ring(part);
      children_[is_below ? node_of_.at(static_cast<uint32_t>(parent)) : 0].push_back(node);
    }
    if (meshes_.empty() || meshes_.back().part != kNoPart) return;
    children_[0].push_back(children_.size());
    children_.emplace_back();
  }
  bool is_in_ring(uint32_t part) const {
    uint64_t p = model_.parts[part].parent;
    for (size_t steps = 0; p < model_.parts.size(); p = model_.parts[p].parent) {
      if (p == part) return true;
      if (++steps > model_.parts.size()) break;  // a ring further up
    }
    return false;
  }

  void write_content(JsonWriter& json) {
    json.name("scene").value(0).name("scenes").begin_array().begin_object();
    json.name("nodes").begin_array().value(0).end_array().end_object().end_array();
    write_nodes(json);
    write_meshes(json);
    write_materials(json);
    numbers_.views.end_array();
    numbers_.accessors.end_array();
    json.name("bufferViews").value(read_json(numbers_.views.take())[0]);
    json.name("accessors").value(read_json(numbers_.accessors.take())[0]);
    json.name("buffers").begin_array().begin_object();
    json.name("byteLength").value(numbers_.bytes.size()).end_object().end_array();
  }

  void write_children(JsonWriter& json, size_t node) const {
    if (children_[node].empty()) return;
    json.name("children").begin_array();
    for (const size_t child : children_[node]) json.value(child);
    json.end_array();
  }

  void write_nodes(JsonWriter& json) const {
    json.name("nodes").begin_array().begin_object().name("name").value("model, Z up");
    json.name("matrix").begin_array();
    for (const double m : {1., 0., 0., 0., 0., 0., -1., 0., 0., 1., 0., 0., origin_.x, origin_.z,
                           0. - origin_.y, 1.})
      json.value(m);
    json.end_array().name("extras").begin_object().name("origin_m").begin_array();
    for (int k = 0; k < 3; ++k) json.value(origin_[k]);
    json.end_array();
    if (!model_.crs.empty()) json.name("crs").value(std::string(model_.crs));
    json.end_object();
    write_children(json, 0);
    json.end_object();
    std::map<uint32_t, size_t> mesh_of;
    for (size_t m = 0; m < meshes_.size(); ++m) mesh_of[meshes_[m].part] = m;
    for (const auto& [part, node] : node_of_) {
      const auto mesh = mesh_of.find(part);
      const Mesh* shown = mesh != mesh_of.end() ? &meshes_[mesh->second] : nullptr;
      json.begin_object().name("name").value(valid_utf8(model_.parts[part].name));
      if (shown != nullptr) json.name("mesh").value(mesh->second);
      write_extras(json, model_.parts[part], shown);
      write_children(json, node);
      json.end_object();
    }
    if (children_.size() > 1 + node_of_.size())
      json.begin_object()
          .name("name")
          .value("mesh")
          .name("mesh")
          .value(meshes_.size() - 1)
          .end_object();
    json.end_array();
  }

  static void write_extras(JsonWriter& json, const Part& part, const Mesh* mesh) {
    json.name("extras").begin_object().name("class").value(valid_utf8(part.part_class));
    if (part.evidence != Evidence::kNone) json.name("evidence").value(name_of(part.evidence));
    write_known(json, "confidence", part.class_confidence);
    write_known(json, "width_m", part.width_m);
    write_known(json, "height_m", part.height_m);
    write_known(json, "depth_m", part.depth_m);
    if (mesh != nullptr && mesh->area_m2 > 0) json.name("area_m2").value(mesh->area_m2);
    if (mesh != nullptr && mesh->sigma_m > 0) json.name("sigma_m").value(mesh->sigma_m);
    json.end_object();
  }

  void write_meshes(JsonWriter& json) {
    json.name("meshes").begin_array();
    for (const Mesh& mesh : meshes_) {
      const size_t material = used_material(material_of(model_, mesh.part));
      json.begin_object().name("primitives").begin_array();
      if (!mesh.corners.empty()) {
        const size_t places = numbers_.add(mesh.places, true),
                     normals = numbers_.add(mesh.normals, false);
        write_primitive(json, kTriangles, places, &normals, numbers_.add(mesh.corners), material);
      }
      if (!mesh.outline_ends.empty()) {
        const size_t places = numbers_.add(mesh.outline_places, true);
        write_primitive(json, kLines, places, nullptr, numbers_.add(mesh.outline_ends), material);
      }
      json.end_array().end_object();
    }
    json.end_array();
  }

  size_t used_material(size_t material) {
    const auto at = std::ranges::find(materials_, material);
    if (at != materials_.end()) return static_cast<size_t>(at - materials_.begin());
    materials_.push_back(material);
    return materials_.size() - 1;
  }

  void write_materials(JsonWriter& json) const {
    json.name("materials").begin_array();
    for (const size_t m : materials_) {
      const Material& material = kMaterials[m];
      json.begin_object().name("name").value(*material.part_class != '\0' ? material.part_class
                                                                          : "other");
      json.name("doubleSided").value(true).name("pbrMetallicRoughness").begin_object();
      json.name("baseColorFactor").begin_array();
      for (const double c : {material.red, material.green, material.blue, 1.0}) json.value(c);
      json.end_array().name("metallicFactor").value(0).end_object().end_object();
    }
    json.end_array();
  }

  const Model& model_;
  Vec3 origin_;
  std::vector<Mesh> meshes_;
  std::map<uint32_t, size_t> node_of_;  // of a part
  std::vector<std::vector<size_t>> children_;
  std::vector<size_t> materials_;
  Numbers numbers_;
};

void put_chunk(AtomicFile& file, uint32_t kind, std::string_view bytes, char filling) {
  std::byte head[8];
  const size_t padding = (4 - bytes.size() % 4) % 4;
  store<uint32_t>(head, static_cast<uint32_t>(bytes.size() + padding));
  store<uint32_t>(head + 4, kind);
  file.write(head, sizeof head);
  file.write(bytes);
  file.write(std::string(padding, filling));
}

size_t chunk_bytes(size_t bytes) { return 8 + (bytes + 3) / 4 * 4; }

}  // namespace

void write_glb(const Model& given, const std::string& path, const WriteSettings& settings,
               Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing glTF");
  validate(given);
  const Model chords = has_arcs(given) ? with_chords(given, settings.chord_error_m) : Model{};
  Writer writer(chords.vertices.empty() ? given : chords, task);
  const std::string json = writer.json();
  const std::string& bytes = writer.bytes();
  const size_t total =
      12 + chunk_bytes(json.size()) + (bytes.empty() ? 0 : chunk_bytes(bytes.size()));
  if (total > std::numeric_limits<uint32_t>::max())
    fail(Status::kLimit, "%s: a glTF file holds at most 4 GiB", path.c_str());
  AtomicFile file(path);
  std::byte head[12];
  store<uint32_t>(head, kMagic);
  store<uint32_t>(head + 4, kVersion);
  store<uint32_t>(head + 8, static_cast<uint32_t>(total));
  file.write(head, sizeof head);
  put_chunk(file, kJsonChunk, json, ' ');
  if (!bytes.empty()) put_chunk(file, kBinChunk, bytes, '\0');
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
