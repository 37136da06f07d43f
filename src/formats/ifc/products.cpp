// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/products.h"

#include <string_view>

#include "model/part_classes.h"
#include "model/polygon_triangles.h"

namespace jalon::ifc {

namespace {

struct Row {
  const char* part_class;
  Entity entity;
};
constexpr Row kRows[] = {
    {part_class::kWall, {"IFCWALL", "NOTDEFINED"}},
    {part_class::kFacade, {"IFCWALL", "NOTDEFINED"}},  // with faces of its own: of city models
    {part_class::kStrip, {"IFCWALL", "NOTDEFINED"}},
    {part_class::kWindow, {"IFCWINDOW", "WINDOW"}},
    {part_class::kDoor, {"IFCDOOR", "DOOR"}},
    {part_class::kGateway, {"IFCDOOR", "GATE"}},
    {part_class::kRoof, {"IFCROOF", "NOTDEFINED"}},
    {part_class::kGround, {"IFCGEOGRAPHICELEMENT", "TERRAIN"}},
    {part_class::kPost, {"IFCCOLUMN", "NOTDEFINED"}},
};

class Arranger {
 public:
  explicit Arranger(const Model& model) : model_(model), count_(model.parts.size()) {}

  Products take() {
    const size_t all = count_ + 1;
    out_.roles.assign(all, Role::kNothing);
    out_.shapes.resize(all);
    out_.holes.resize(all);
    out_.members.resize(all);
    out_.hosts.assign(all, kNoPart);
    out_.buildings.assign(all, kNoPart);
    find_buildings();
    find_holes();
    give_shapes();
    give_roles();
    fill_groups();
    return std::move(out_);
  }

 private:
  std::string_view class_of(size_t part) const { return model_.parts[part].part_class; }
  // count_ where there is none. Parents that name each other end after as many steps as there are parts.
  size_t parent_of(size_t part) const {
    const uint64_t parent = model_.parts[part].parent;
    return parent < count_ ? static_cast<size_t>(parent) : count_;
  }
  template <class Wanted>
  size_t nearest(size_t part, Wanted&& wanted) const {
    for (size_t steps = 0; part < count_ && steps <= count_; ++steps) {
      if (wanted(part)) return part;
      part = parent_of(part);
    }
    return count_;
  }

  void find_buildings() {
    for (size_t p = 0; p < count_; ++p) {
      const size_t found =
          nearest(p, [&](size_t q) { return class_of(q) == part_class::kBuilding; });
      if (found < count_) out_.buildings[p] = static_cast<uint32_t>(found);
    }
  }

  void find_holes() {
    for (uint32_t f = 0; f < model_.faces.size(); ++f) {
      const Face& face = model_.faces[f];
      for (uint64_t r = face.first_ring + 1; r < face.first_ring + face.ring_count; ++r) {
        const uint32_t part = model_.rings[r].part;
        if (part >= count_ || model_.rings[r].count < 3) continue;
        if (!part_class::is_opening(class_of(part))) continue;
        if (out_.holes[part].empty()) out_.hosts[part] = face.part;
        // A product is voided by one relation: holes in another part's faces are drawn by those faces alone.
        if (out_.hosts[part] == face.part) out_.holes[part].push_back({f, r});
      }
    }
  }

  // The part that shows what this one has: itself, or the opening that it stands in. Reveals are sides of the wall.
  size_t shown_by(size_t part) const {
    if (part >= count_) return count_;
    if (class_of(part) == part_class::kReveal) return part;
    const size_t opening =
        nearest(part, [&](size_t q) { return part_class::is_opening(class_of(q)); });
    return opening < count_ ? opening : part;
  }

  void give_shapes() {
    std::vector<bool> in_solid(model_.faces.size(), false);
    for (uint32_t s = 0; s < model_.solids.size(); ++s) {
      const Solid& solid = model_.solids[s];
      out_.shapes[shown_by(solid.part)].solids.push_back(s);
      for (uint64_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f)
        in_solid[f] = true;
    }
    for (uint32_t f = 0; f < model_.faces.size(); ++f) {
      const Face& face = model_.faces[f];
      if (in_solid[f] || face.ring_count == 0 || model_.rings[face.first_ring].count < 3) continue;
      out_.shapes[shown_by(face.part)].faces.push_back(f);
    }
    const bool by_part = is_mesh_by_part(model_);
    for (const uint32_t t : loose_triangles(model_))
      out_.shapes[by_part ? shown_by(model_.triangle_faces[t]) : count_].triangles.push_back(t);
  }

  void give_roles() {
    for (size_t p = 0; p < count_; ++p) {
      const bool is_shown = !out_.shapes[p].empty();
      if (class_of(p) == part_class::kBuilding) out_.roles[p] = Role::kBuilding;
      else if (!out_.holes[p].empty()) out_.roles[p] = Role::kOpening;
      else if (is_shown) out_.roles[p] = Role::kElement;
      else if (shown_by(p) != p) out_.roles[p] = Role::kWithin;
    }
    if (!out_.shapes[count_].empty()) out_.roles[count_] = Role::kElement;
    // What has nothing itself is a group where something below it is shown.
    for (size_t p = 0; p < count_; ++p) {
      if (out_.roles[p] != Role::kElement && out_.roles[p] != Role::kOpening) continue;
      size_t above = parent_of(p);
      for (size_t steps = 0; above < count_ && steps <= count_; ++steps, above = parent_of(above))
        if (out_.roles[above] == Role::kNothing) out_.roles[above] = Role::kGroup;
    }
  }

  void fill_groups() {
    for (size_t p = 0; p < count_; ++p) {
      if (out_.roles[p] != Role::kElement && out_.roles[p] != Role::kGroup) continue;
      const size_t above = parent_of(p);
      if (above == count_) continue;
      const size_t group = nearest(above, [&](size_t q) { return out_.roles[q] == Role::kGroup; });
      if (group < count_ && group != p) out_.members[group].push_back(static_cast<uint32_t>(p));
    }
  }

  const Model& model_;
  size_t count_;
  Products out_;
};

}  // namespace

Products arrange_products(const Model& model) { return Arranger(model).take(); }

Entity entity_of(std::string_view part_class) {
  for (const Row& row : kRows)
    if (part_class == row.part_class) return row.entity;
  return {"IFCBUILDINGELEMENTPROXY", "USERDEFINED"};
}

}  // namespace jalon::ifc
