// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/edit.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "model/topology.h"

namespace jalon {

namespace {

constexpr uint64_t kGone = std::numeric_limits<uint64_t>::max();

void require_part(const Model& model, uint64_t part) {
  if (part >= model.parts.size())
    fail(Status::kInvalidArgument, "there are %zu parts", model.parts.size());
}

// New index of each element, kGone for those that go.
std::vector<uint64_t> numbered(const std::vector<uint8_t>& is_gone) {
  std::vector<uint64_t> out(is_gone.size(), kGone);
  uint64_t next = 0;
  for (size_t i = 0; i < is_gone.size(); ++i)
    if (is_gone[i] == 0) out[i] = next++;
  return out;
}

// The part and all below it; parents may stand behind their children in models that were read.
std::vector<uint8_t> parts_below(const Model& model, uint64_t top) {
  std::vector<uint8_t> out(model.parts.size(), 0);
  out[top] = 1;
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < out.size(); ++i) {
      const uint64_t parent = model.parts[i].parent;
      if (out[i] != 0 || parent >= out.size() || out[parent] == 0) continue;
      out[i] = 1;
      changed = true;
    }
  }
  return out;
}

void copy_parts(const Model& model, const std::vector<uint64_t>& part_of, Model& out) {
  const auto moved = [&](uint64_t part) { return part < part_of.size() ? part_of[part] : part; };
  for (size_t i = 0; i < model.parts.size(); ++i) {
    if (part_of[i] == kGone) continue;
    Part part = model.parts[i];
    part.parent = moved(part.parent);
    part.copied_from = moved(part.copied_from);
    out.parts.push_back(std::move(part));
  }
}

// A face with those of its rings that stay; the area of the holes that close comes back.
void copy_face(const Model& model, const Face& face, const std::vector<uint64_t>& part_of,
               Model& out) {
  Face copy = face;
  copy.part = static_cast<uint32_t>(part_of[face.part]);
  copy.first_ring = out.rings.size();
  copy.ring_count = 0;
  for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r) {
    const Ring& ring = model.rings[r];
    const bool names_part = ring.part < part_of.size();
    if (names_part && part_of[ring.part] == kGone) {
      copy.area_m2 -= ring_area(model, ring, face.plane.normal);
      continue;
    }
    Ring kept{out.corners.size(), ring.count,
              names_part ? static_cast<uint32_t>(part_of[ring.part]) : ring.part};
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c) {
      out.corners.push_back(model.corners[c]);
      if (!model.sagittas.empty()) out.sagittas.push_back(model.sagittas[c]);
    }
    out.rings.push_back(kept);
    ++copy.ring_count;
  }
  out.faces.push_back(copy);
}

void copy_solids(const Model& model, const std::vector<uint64_t>& part_of,
                 const std::vector<uint64_t>& face_of, Model& out) {
  for (const Solid& solid : model.solids) {
    if (solid.part < part_of.size() && part_of[solid.part] == kGone) continue;
    Solid copy{static_cast<uint32_t>(part_of[solid.part]), kGone, 0};
    for (uint64_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f) {
      if (face_of[f] == kGone) continue;
      if (copy.first_face == kGone) copy.first_face = face_of[f];
      ++copy.face_count;
    }
    if (copy.face_count > 0) out.solids.push_back(copy);
  }
}

// Vertices that rings and triangles still use, in their order.
void copy_vertices(const Model& model, Model& out) {
  std::vector<uint8_t> is_gone(model.vertices.size(), 1);
  for (const uint32_t v : out.corners) is_gone[v] = 0;
  for (const auto& triangle : out.triangles)
    for (const uint32_t v : triangle) is_gone[v] = 0;
  const std::vector<uint64_t> vertex_of = numbered(is_gone);
  for (size_t v = 0; v < vertex_of.size(); ++v) {
    if (vertex_of[v] == kGone) continue;
    out.vertices.push_back(model.vertices[v]);
    if (!model.vertex_covariances.empty())
      out.vertex_covariances.push_back(model.vertex_covariances[v]);
  }
  for (uint32_t& v : out.corners) v = static_cast<uint32_t>(vertex_of[v]);
  for (auto& triangle : out.triangles)
    for (uint32_t& v : triangle) v = static_cast<uint32_t>(vertex_of[v]);
}

}  // namespace

double ring_area(const Model& model, const Ring& ring, const Vec3& normal) {
  double twice = 0, arcs = 0;
  // About the first corner, so that large coordinates lose nothing.
  const Vec3 origin = ring.count > 0 ? model.vertices[model.corners[ring.first]] : Vec3{};
  for (uint64_t i = 0; i < ring.count; ++i) {
    const uint64_t here = ring.first + i, next = ring.first + (i + 1) % ring.count;
    const Vec3 a = model.vertices[model.corners[here]] - origin,
               b = model.vertices[model.corners[next]] - origin;
    twice += dot(cross(a, b), normal);
    const double s = model.sagitta(here), chord = norm(b - a);
    if (s == 0 || !(chord > 0)) continue;
    const Arc2 arc = arc_of({0, 0}, {chord, 0}, s);
    const double angle = 4 * std::atan(std::fabs(arc.bulge));
    arcs += std::copysign(arc.radius * arc.radius / 2 * (angle - std::sin(angle)), s);
  }
  return twice / 2 + arcs;
}

Model with_renamed_part(Model model, uint64_t part, std::string name, std::string part_class) {
  require_part(model, part);
  model.parts[part].name = std::move(name);
  model.parts[part].part_class = std::move(part_class);
  return model;
}

Model without_copy(const Model& model, uint64_t part) {
  require_part(model, part);
  if (model.parts[part].evidence != Evidence::kCopied)
    fail(Status::kInvalidArgument, "part %llu (\"%.100s\") is no copy",
         static_cast<unsigned long long>(part), model.parts[part].name.c_str());
  const std::vector<uint64_t> part_of = numbered(parts_below(model, part));
  Model out;
  out.crs = model.crs;
  out.triangles = model.triangles;
  out.triangle_faces = model.triangle_faces;
  copy_parts(model, part_of, out);
  std::vector<uint64_t> face_of(model.faces.size(), kGone);
  for (size_t f = 0; f < model.faces.size(); ++f) {
    if (part_of[model.faces[f].part] == kGone) continue;
    face_of[f] = out.faces.size();
    copy_face(model, model.faces[f], part_of, out);
  }
  copy_solids(model, part_of, face_of, out);
  copy_vertices(model, out);
  return out;
}

}  // namespace jalon
