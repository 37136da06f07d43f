// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/facade/assembly.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <string_view>

#include "model/part_classes.h"
#include "modelling/facade/opening_classes.h"
#include "modelling/facade/opening_faces.h"
#include "modelling/facade/part_rules.h"
#include "modelling/facade/wall_solid.h"
#include "modelling/plane/corner_covariances.h"
#include "modelling/plane/face_builder.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kBoxChord_m = 0.001;
constexpr uint8_t kWalls = 2, kOpenings = 3;  // levels of detail of CityGML 3.0

// "shop front" of "shop_front".
std::string spoken(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

Box3 box_in(const FacadeFrame& frame, const PlaneFrame& plane, const VectorRing& ring) {
  Box3 box;
  for (const Vec2& p : flattened(ring, kBoxChord_m)) box.add(frame.local(plane.lift(p)));
  return box;
}

// The same closed chain, wherever it begins.
bool same_corners(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  if (a.size() != b.size() || a.empty()) return false;
  const auto start = static_cast<size_t>(std::find(b.begin(), b.end(), a.front()) - b.begin());
  for (size_t i = 0; i < a.size(); ++i)
    if (start == b.size() || !(a[i] == b[(start + i) % b.size()])) return false;
  return true;
}

class Assembly {
 public:
  Assembly(const Segmentation& segmentation, const FacadePlan& plan, const AssemblySetting& setting,
           Task& task)
      : segmentation_(segmentation), plan_(plan), setting_(setting), task_(task) {
    if (setting.solids) thicknesses_ = wall_thicknesses(plan, setting.thickness_m);
    for (const VectorPlane& plane : plan.planes)
      vertices_.emplace_back(model_, shared_, plane.frame);
    for (size_t s = 0; s < plan.shared.size(); ++s) {
      shared_.positions.push_back(plan.shared[s].position);
      for (const auto& use : plan.shared[s].uses) vertices_[use.plane].share(use.place, s);
    }
    shared_.vertices.assign(plan.shared.size(), kNoVertex);
  }

  Model run() {
    model_.crs = segmentation_.cloud->crs;
    uint64_t building = kNoParent;
    if (plan_.facades.size() > 1)
      building = append_part(model_, "building", part_class::kBuilding, kNoParent, Evidence::kNone);
    for (size_t f = 0; f < plan_.facades.size(); ++f) {
      const std::string name =
          plan_.facades.size() > 1 ? "facade " + std::to_string(f + 1) : "facade";
      if (setting_.solids) thickness_m_ = thicknesses_[f];
      add_facade(plan_.facades[f],
                 append_part(model_, name, part_class::kFacade, building, Evidence::kMeasured));
    }
    add_covariances();
    return std::move(model_);
  }

 private:
  Face face_of(size_t plane, uint32_t part) const {
    const Segment& segment = segmentation_.segments[plane];
    Face face;
    face.part = part;
    face.id = segment.label;
    face.face_class = static_cast<uint8_t>(segment.orientation);
    face.plane = segment.fit.plane;
    face.sigma_m = segment.fit.sigma;
    face.covariance = segment.fit.covariance;
    return face;
  }

  void set_size(uint32_t part, const Box3& box) {
    model_.parts[part].width_m = box.max.x - box.min.x;
    model_.parts[part].height_m = box.max.z - box.min.z;
  }

  void add_facade(const PlannedFacade& facade, uint32_t part) {
    facade_ = &facade;
    if (!facade.group.box.empty()) set_size(part, facade.group.box);
    shape_ = {facade.group.box, {}};
    std::vector<Box3> boxes;
    for (const PlannedWall& wall : facade.walls) {
      Box3 box;
      for (const VectorRing& ring : wall.wall.outlines)
        box += box_in(facade.group.frame, wall.wall.frame, ring);
      boxes.push_back(box);
    }
    name_openings();
    for (const size_t w : by_place(boxes)) add_wall(facade.walls[w], w, boxes[w], part);
    if (!setting_.walls_only) add_elements(part);
  }

  // Names of all openings of the facade together, so that storeys keep their numbers across walls.
  void name_openings() {
    names_.clear();
    std::map<OpeningKind, std::vector<Box3>> boxes;
    for (const PlannedWall& wall : facade_->walls)
      for (const FacadeOpening& o : wall.wall.openings)
        boxes[o.kind].push_back(box_in(facade_->group.frame, wall.wall.frame, o.outline));
    std::map<OpeningKind, std::vector<std::string>> numbers;
    for (const auto& [kind, list] : boxes) numbers[kind] = row_numbers(list);
    std::map<OpeningKind, size_t> next;
    for (const PlannedWall& wall : facade_->walls) {
      auto& names = names_.emplace_back();
      for (const FacadeOpening& o : wall.wall.openings)
        names.push_back(spoken(class_of(o.kind)) + " " + numbers[o.kind][next[o.kind]++]);
    }
  }

  void add_wall(const PlannedWall& planned, size_t index, const Box3& box, uint32_t facade_part) {
    task_.checkpoint(0);
    const FacadeWall& wall = planned.wall;
    const uint32_t part = append_part(model_, "wall " + std::to_string(++wall_count_),
                                      part_class::kWall, facade_part, Evidence::kMeasured);
    set_size(part, box);
    model_.parts[part].depth_m = -(box.min.y + box.max.y) / 2;
    model_.parts[part].level_of_detail = kWalls;
    // 1. The openings' parts, so that the rings can name them.
    std::vector<uint32_t> openings;
    for (size_t o = 0; o < wall.openings.size(); ++o)
      openings.push_back(add_opening_part(wall, wall.openings[o], names_[index][o], part));
    for (size_t o = 0; o < wall.openings.size(); ++o)
      if (wall.openings[o].copied_from >= 0)
        model_.parts[openings[o]].copied_from =
            openings[static_cast<size_t>(wall.openings[o].copied_from)];
    std::vector<uint32_t> shadows;
    for (const FacadeShadow& shadow : wall.shadows)
      shadows.push_back(add_shadow_part(planned.plane, shadow, part));
    // 2. The wall's faces.
    const VectorPlane& plane = plan_.planes[planned.plane];
    for (const VectorFace& face : plane.faces)
      add_wall_face(planned.plane, face, wall, {openings, shadows, part});
    // 3. What fills the openings, and what was not seen.
    for (size_t o = 0; o < wall.openings.size() && !setting_.walls_only; ++o) {
      Face joinery;
      if (wall.openings[o].joinery_label != 0)
        joinery = face_of(wall.openings[o].joinery_label - 1, 0);
      append_opening_faces(model_, vertices_[planned.plane], wall.openings[o], openings[o], joinery,
                           !setting_.solids);
    }
    for (size_t k = 0; k < shadows.size(); ++k)
      if (!wall.shadows[k].is_filled)  // areas count once: filled, it is wall
        append_face(model_, face_of(planned.plane, shadows[k]),
                    {part_ring(vertices_[planned.plane], wall.shadows[k].outline)});
  }

  uint32_t add_opening_part(const FacadeWall& wall, const FacadeOpening& opening,
                            const std::string& name, uint32_t wall_part) {
    const bool is_copy = opening.copied_from >= 0;
    const uint32_t part = append_part(model_, name, class_of(opening.kind), wall_part,
                                      is_copy ? Evidence::kCopied : opening.evidence);
    const Box3 box = box_in(facade_->group.frame, wall.frame, opening.outline);
    set_size(part, box);
    model_.parts[part].depth_m = opening.depth_m;
    model_.parts[part].level_of_detail = kOpenings;
    model_.parts[part].class_confidence = opening.kind_confidence;
    shape_.openings.push_back(box);
    return part;
  }

  // The parts of a wall: what its faces, and each of their holes, belong to.
  struct WallParts {
    const std::vector<uint32_t>&openings, &shadows;
    uint32_t wall;
  };

  void add_wall_face(size_t plane, const VectorFace& face, const FacadeWall& wall,
                     const WallParts& parts) {
    const uint32_t part = parts.wall;
    std::vector<uint32_t> hole_parts(face.openings.size(), kNoPart),
        reveal_parts(face.openings.size(), part);
    std::vector<uint8_t> is_opening(face.openings.size(), 0);
    for (size_t r = 0; r < face.openings.size(); ++r) {
      const VectorRing outline = reversed(face.openings[r]);
      for (size_t k = 0; k < wall.shadows.size(); ++k)
        if (same_corners(wall.shadows[k].outline.corners, outline.corners))
          hole_parts[r] = parts.shadows[k];
      for (size_t o = 0; o < wall.openings.size(); ++o)
        if (same_corners(wall.openings[o].outline.corners, outline.corners)) {
          hole_parts[r] = parts.openings[o];
          is_opening[r] = 1;
        }
    }
    if (setting_.solids) {
      for (size_t r = 0; r < hole_parts.size(); ++r)
        if (is_opening[r] != 0)
          reveal_parts[r] =
              append_part(model_, "reveal", part_class::kReveal, hole_parts[r], Evidence::kDerived);
      append_wall_solid(model_, vertices_[plane], face, face_of(plane, part), hole_parts,
                        reveal_parts, thickness_m_);
      return;
    }
    std::vector<PartRing> rings{part_ring(vertices_[plane], face.outline)};
    for (size_t r = 0; r < face.openings.size(); ++r) {
      rings.push_back(part_ring(vertices_[plane], face.openings[r]));
      rings.back().part = hole_parts[r];
    }
    append_face(model_, face_of(plane, part), rings);
  }

  uint32_t add_shadow_part(size_t plane, const FacadeShadow& shadow, uint32_t wall_part) {
    const uint32_t part = append_part(model_, "no data " + std::to_string(++shadow_count_),
                                      part_class::kNoData, wall_part, Evidence::kNone);
    set_size(part, box_in(facade_->group.frame, plan_.planes[plane].frame, shadow.outline));
    return part;
  }

  // Faces that are no wall: each a part of its own, named by class and number.
  void add_elements(uint32_t facade_part) {
    struct Element {
      size_t plane;
      const VectorFace* face;
      Box3 box;
      const char* part_class;
    };
    std::vector<Element> elements;
    std::vector<Box3> boxes;
    for (const size_t plane : facade_->elements) {
      const char* largest = nullptr;
      for (const VectorFace& face : plan_.planes[plane].faces) {
        const FacadeFrame& frame = facade_->group.frame;
        const Vec3& n = plan_.planes[plane].frame.normal;
        const Box3 box = box_in(frame, plan_.planes[plane].frame, face.outline);
        const ElementShape shape{
            box, {dot(n, frame.along), dot(n, frame.outward), n.z}, area(face)};
        // Small pieces of the ground beside cars and tripods are ground.
        const char* own = class_of_element(shape, shape_);
        if (largest == nullptr) largest = own;
        elements.push_back(
            {plane, &face, box, largest == std::string_view(part_class::kGround) ? largest : own});
        boxes.push_back(box);
      }
    }
    std::map<std::string, size_t> numbers;
    for (const size_t k : by_place(boxes)) {
      task_.checkpoint(0);
      const Element& e = elements[k];
      std::string name = spoken(e.part_class);
      const size_t number = ++numbers[name];
      name += " " + std::to_string(number);
      const uint32_t part =
          append_part(model_, name, e.part_class, facade_part, Evidence::kMeasured);
      set_size(part, e.box);
      model_.parts[part].depth_m = -(e.box.min.y + e.box.max.y) / 2;
      model_.parts[part].level_of_detail = kOpenings;
      std::vector<PartRing> rings{part_ring(vertices_[e.plane], e.face->outline)};
      for (const VectorRing& ring : e.face->openings)
        rings.push_back(part_ring(vertices_[e.plane], ring));
      append_face(model_, face_of(e.plane, part), rings);
    }
  }

  // Of the corners of all rings, and of the panes behind them.
  void add_covariances() {
    const auto add = [&](size_t plane, const VectorRing& ring, double w, double extra_sigma_m) {
      RingVertices of{&ring, {}, extra_sigma_m};
      for (const Vec2& p : ring.corners) {
        const uint32_t vertex = vertices_[plane].find(p, w);
        if (vertex == kNoVertex) return;
        of.vertices.push_back(vertex);
      }
      set_covariances(model_, plan_.planes[plane].frame, face_of(plane, 0), of);
    };
    for (size_t p = 0; p < plan_.planes.size(); ++p)
      for (const VectorFace& face : plan_.planes[p].faces) {
        add(p, face.outline, 0, 0);
        for (const VectorRing& ring : face.openings) add(p, ring, 0, 0);
      }
    for (const PlannedFacade& facade : plan_.facades)
      for (const PlannedWall& wall : facade.walls)
        for (const FacadeOpening& o : wall.wall.openings)
          add(wall.plane, o.outline, -o.depth_m, o.depth_sigma_m);
  }

  // From left to right, then from below; ties by index.
  static std::vector<size_t> by_place(const std::vector<Box3>& boxes) {
    std::vector<size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
      const double left = boxes[a].min.x + boxes[a].max.x, right = boxes[b].min.x + boxes[b].max.x;
      return left != right ? left < right : boxes[a].min.z < boxes[b].min.z;
    });
    return order;
  }

  const Segmentation& segmentation_;
  const FacadePlan& plan_;
  const AssemblySetting& setting_;
  Task& task_;
  std::vector<double> thicknesses_;
  double thickness_m_ = 0;
  Model model_;
  SharedVertices shared_;
  std::vector<PlaneVertices> vertices_;
  const PlannedFacade* facade_ = nullptr;
  FacadeShape shape_;
  std::vector<std::vector<std::string>> names_;
  size_t wall_count_ = 0, shadow_count_ = 0;
};

}  // namespace

Model assemble_facades(const Segmentation& segmentation, FacadePlan plan,
                       const AssemblySetting& setting, Task& task) {
  if (setting.solids) draw_chords(plan, kRevealChord_m);
  return Assembly(segmentation, plan, setting, task).run();
}

}  // namespace jalon
