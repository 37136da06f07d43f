// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/city/geometry.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "formats/city/parts.h"
#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon::city {

namespace {

constexpr size_t kGeometryTicks = 1024;  // faces or triangles between two looks at the task
constexpr double kMaxSteps =
    9007199254740992.0;  // 2^53: whole numbers that every JSON reader keeps

/// Sorts the surfaces of a model into the objects they belong to.
class Arranger {
 public:
  Arranger(const Model& model, Grid& grid, Task& task)
      : model_(model), grid_(grid), task_(task), openings_(find_openings(model)) {
    city_.closing.assign(model.parts.size(), 0);
    city_.faces_of_part.resize(model.parts.size());
  }

  City run() {
    add_buildings();
    std::vector<uint8_t> in_solid(model_.faces.size(), 0);
    for (const Solid& solid : model_.solids) add_solid(solid, in_solid);
    for (uint32_t f = 0; f < model_.faces.size(); ++f) {
      if (f % kGeometryTicks == 0) task_.checkpoint(0.1);
      if (in_solid[f] == 0) add_face(surfaces_of(model_.faces[f].part), f);
      add_closings(model_.faces[f]);
    }
    const bool by_part = is_mesh_by_part(model_);
    for (const uint32_t t : loose_triangles(model_)) {
      if (t % kGeometryTicks == 0) task_.checkpoint(0.1);
      add_triangle(t, by_part ? model_.triangle_faces[t] : kNoPart);
    }
    city_.wall_of_opening = std::move(openings_.wall);
    return std::move(city_);
  }

 private:
  // Gutters are installed on their building.
  void add_buildings() {
    for (uint32_t p = 0; p < model_.parts.size(); ++p) {
      const std::string& part_class = model_.parts[p].part_class;
      const bool is_installed =
          part_class == part_class::kGutter && nearest(model_, p, part_class::kBuilding) != kNoPart;
      if (part_class != part_class::kBuilding && !is_installed) continue;
      const uint64_t above = model_.parts[p].parent;
      const uint32_t parent =
          above < model_.parts.size()
              ? nearest(model_, static_cast<uint32_t>(above), part_class::kBuilding)
              : kNoPart;
      city_.objects[p] = {p, parent, {}};
    }
  }

  // The nearest object above.
  Object& object_of(uint32_t part) {
    uint64_t at = part;
    for (size_t steps = 0; at < model_.parts.size() && steps <= model_.parts.size(); ++steps) {
      const auto found = city_.objects.find(static_cast<uint32_t>(at));
      if (found != city_.objects.end()) return found->second;
      at = model_.parts[at].parent;
    }
    return city_.objects[kNoPart];
  }

  // The first geometry of an object that is no solid takes all loose surfaces.
  Geometry& surfaces_of(uint32_t part) {
    std::vector<Geometry>& all = object_of(part).geometries;
    for (Geometry& geometry : all)
      if (!geometry.solid) return geometry;
    return all.emplace_back();
  }

  void add_solid(const Solid& solid, std::vector<uint8_t>& in_solid) {
    Geometry& geometry = object_of(solid.part).geometries.emplace_back();
    geometry.solid = true;
    for (uint64_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f) {
      add_face(geometry, static_cast<uint32_t>(f));
      in_solid[f] = 1;
    }
  }

  // A ring on the grid, without corners that fell together.
  std::vector<uint32_t> snapped(const Ring& ring) {
    std::vector<uint32_t> out;
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c) {
      const uint32_t vertex = grid_.add(model_.vertices[model_.corners[c]]);
      if (out.empty() || out.back() != vertex) out.push_back(vertex);
    }
    while (out.size() > 1 && out.front() == out.back()) out.pop_back();
    return out;
  }

  void add_face(Geometry& geometry, uint32_t f) {
    const Face& face = model_.faces[f];
    Surface surface;
    surface.part = face.part < model_.parts.size() ? face.part : kNoPart;
    for (uint64_t r = 0; r < face.ring_count; ++r) {
      std::vector<uint32_t> ring = snapped(model_.rings[face.first_ring + r]);
      if (ring.size() < 3 && r == 0) break;
      if (ring.size() < 3) continue;
      surface.rings.push_back(std::move(ring));
    }
    if (surface.rings.empty()) {
      ++city_.dropped;
      return;
    }
    city_.has_openings = city_.has_openings || surface.rings.size() > 1;
    if (surface.part != kNoPart) city_.faces_of_part[surface.part].push_back(f);
    geometry.surfaces.push_back(std::move(surface));
  }

  // Windows and doors of which the hole alone is known: a surface in the plane of the wall, as CityGML has it.
  void add_closings(const Face& face) {
    for (uint64_t r = 1; r < face.ring_count; ++r) {
      const Ring& hole = model_.rings[face.first_ring + r];
      if (hole.part >= model_.parts.size() || openings_.filled[hole.part] != 0) continue;
      if (!part_class::is_opening(model_.parts[hole.part].part_class)) continue;
      std::vector<uint32_t> ring = snapped(hole);
      if (ring.size() < 3) continue;
      std::ranges::reverse(ring);
      city_.closing[hole.part] = 1;
      surfaces_of(hole.part).surfaces.push_back({{std::move(ring)}, hole.part});
    }
  }

  void add_triangle(uint32_t t, uint32_t part) {
    std::vector<uint32_t> ring;
    for (const uint32_t v : model_.triangles[t]) ring.push_back(grid_.add(model_.vertices[v]));
    if (ring[0] == ring[1] || ring[1] == ring[2] || ring[2] == ring[0]) {
      ++city_.dropped;
      return;
    }
    surfaces_of(part).surfaces.push_back({{std::move(ring)}, part});
  }

  const Model& model_;
  Grid& grid_;
  Task& task_;
  Openings openings_;
  City city_;
};

}  // namespace

Grid::Grid(const Model& model, double scale_m) : scale_m_(scale_m) {
  Box3 box;
  for (const Vec3& p : model.vertices) box.add(p);
  if (box.empty()) return;
  translate_ = {std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
  const Vec3 size = box.max - translate_;
  if (std::max({size.x, size.y, size.z}) / scale_m >= kMaxSteps)
    fail(Status::kLimit, "the model is too large for steps of city_scale_m");
}

uint32_t Grid::add(const Vec3& p) {
  std::array<int64_t, 3> step;
  for (int k = 0; k < 3; ++k)
    step[static_cast<size_t>(k)] = std::llround((p[k] - translate_[k]) / scale_m_);
  const auto [entry, added] = index_.try_emplace(step, static_cast<uint32_t>(steps_.size()));
  if (added) steps_.push_back(step);
  return entry->second;
}

Vec3 Grid::place(uint32_t index) const {
  Vec3 p;
  for (int k = 0; k < 3; ++k)
    p[k] = static_cast<double>(steps_[index][static_cast<size_t>(k)]) * scale_m_ + translate_[k];
  return p;
}

size_t Grid::Hash::operator()(const std::array<int64_t, 3>& s) const {
  uint64_t h = 0x9E3779B97F4A7C15u;  // splitmix64 (Steele et al. 2014)
  for (const int64_t v : s) {
    h ^= static_cast<uint64_t>(v);
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
    h ^= h >> 31;
  }
  return h;
}

City arrange(const Model& model, Grid& grid, Task& task) {
  return Arranger(model, grid, task).run();
}

}  // namespace jalon::city
