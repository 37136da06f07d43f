// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "model/model.h"
#include "model/part_classes.h"

// A model with all that files must carry, made by hand on coordinates of a national grid: a wall at an angle to the
// axes with a round-headed window (frame behind it, reveals left out), a door, a copied window, a round window, an
// area without data; a sill as a closed solid; ground and a pitched roof.
namespace jalon::test {

inline constexpr double kArchRadius_m = 0.6, kRoundRadius_m = 0.4;

class House {
 public:
  House() {
    model_.crs = "EPSG:2154";
    building_ = add_part("house", part_class::kBuilding, kNoParent);
    facade_ = add_part("facade A", part_class::kFacade, building_);
    wall_ = add_part("wall \xC3\xA9t\xC3\xA9", part_class::kWall, facade_);
    window_ = add_part("window 1", part_class::kWindow, wall_, Evidence::kRevealed);
    joinery_ = add_part("joinery 1", part_class::kJoinery, window_, Evidence::kMeasured);
    door_ = add_part("door", part_class::kDoor, wall_, Evidence::kSeenBehind);
    copy_ = add_part("window 2", part_class::kWindow, wall_, Evidence::kCopied);
    model_.parts[copy_].copied_from = window_;
    model_.parts[window_].width_m = 1.2;
    model_.parts[window_].height_m = 2.1;
    model_.parts[window_].depth_m = 0.2;
    round_ = add_part("round", part_class::kOpening, wall_, Evidence::kShape);
    shadow_ = add_part("shadow", part_class::kNoData, wall_);
    sill_ = add_part("sill 1", part_class::kSill, wall_, Evidence::kMeasured);
    ground_ = add_part("ground", part_class::kGround, building_);
    roof_ = add_part("roof", part_class::kRoof, building_);
    add_wall();
    add_others();
    add_sill();
  }
  Model model() const { return model_; }

  static double arch_area() {
    return 1.2 * 1.5 + std::numbers::pi * kArchRadius_m * kArchRadius_m / 2;
  }
  static double round_area() { return std::numbers::pi * kRoundRadius_m * kRoundRadius_m; }
  static double wall_area() { return 12 * 8 - 2 * arch_area() - 1.0 * 2.2 - round_area(); }

 private:
  struct Corner {
    double s, z, sagitta_m = 0;
  };

  uint32_t add_part(const char* name, const char* part_class, uint64_t parent,
                    Evidence evidence = Evidence::kNone) {
    Part part;
    part.name = name;
    part.part_class = part_class;
    part.parent = parent;
    part.evidence = evidence;
    model_.parts.push_back(part);
    return static_cast<uint32_t>(model_.parts.size() - 1);
  }

  // s along the wall, z up, d in front of it.
  static Vec3 at(double s, double z, double d = 0) {
    constexpr double kAngle = 0.35;
    const double c = std::cos(kAngle), n = std::sin(kAngle);
    return {652417.123456 + s * c + d * n, 6861005.654321 + s * n - d * c, 142.5 + z};
  }
  static Vec3 front() { return at(0, 0, 1) - at(0, 0, 0); }

  void add_face(uint32_t part, uint32_t id, const Vec3& normal, double area_m2,
                const std::vector<std::vector<Corner>>& rings, double d = 0,
                const std::vector<uint32_t>& ring_parts = {}) {
    Face face;
    face.part = part;
    face.id = id;
    face.plane.normal = normalized(normal);
    face.area_m2 = area_m2;
    face.sigma_m = 0.001 * id;
    face.first_ring = model_.rings.size();
    face.ring_count = rings.size();
    for (size_t r = 0; r < rings.size(); ++r) {
      model_.rings.push_back({model_.corners.size(), rings[r].size(),
                              r < ring_parts.size() ? ring_parts[r] : kNoPart});
      for (const Corner& c : rings[r]) {
        model_.corners.push_back(static_cast<uint32_t>(model_.vertices.size()));
        model_.sagittas.push_back(c.sagitta_m);
        model_.vertices.push_back(at(c.s, c.z, d));
      }
    }
    face.plane.offset = dot(face.plane.normal, at(rings[0][0].s, rings[0][0].z, d));
    model_.faces.push_back(face);
  }

  // A round-headed opening clockwise as holes run, its left foot at (s, z).
  static std::vector<Corner> arch(double s, double z) {
    return {{s, z}, {s, z + 1.5, -kArchRadius_m}, {s + 1.2, z + 1.5}, {s + 1.2, z}};
  }
  static std::vector<Corner> box(double s, double z, double w, double h) {
    return {{s, z}, {s + w, z}, {s + w, z + h}, {s, z + h}};
  }
  static std::vector<Corner> turned(std::vector<Corner> ring) {
    return {ring[0], ring[3], ring[2], ring[1]};
  }

  void add_wall() {
    const std::vector<Corner> circle{{8.6, 6, -kRoundRadius_m}, {9.4, 6, -kRoundRadius_m}};
    add_face(wall_, 1, front(), wall_area(),
             {box(0, 0, 12, 8), arch(1, 1), turned(box(4, 0.2, 1, 2.2)), arch(7, 1), circle}, 0,
             {kNoPart, window_, door_, copy_, round_});
    // The frame fills the arch of the first window 0.2 m behind the wall.
    add_face(joinery_, 2, front(), arch_area(),
             {{{1, 1}, {2.2, 1}, {2.2, 2.5, kArchRadius_m}, {1, 2.5}}}, -0.2);
    add_face(shadow_, 3, front(), 1.0, {box(10, 3, 1, 1)}, 0.001);
  }

  void add_others() {
    const auto quad = [&](uint32_t part, uint32_t id, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d) {
      Face face;
      face.part = part;
      face.id = id;
      face.plane.normal = normalized(cross(b - a, c - a));
      face.plane.offset = dot(face.plane.normal, a);
      face.area_m2 = norm(cross(b - a, c - a));
      model_.add_face(face, {{a, b, c, d}});
    };
    quad(ground_, 4, at(0, 0, 0), at(0, 0, 5), at(12, 0, 5), at(12, 0, 0));
    quad(roof_, 5, at(0, 8, 0), at(12, 8, 0), at(12, 11, -4), at(0, 11, -4));
  }

  // A box in front of the wall on shared vertices: closed, normals outward.
  void add_sill() {
    const auto first = static_cast<uint32_t>(model_.vertices.size());
    for (const double d : {0.0, 0.1})
      for (const double z : {0.9, 1.0})
        for (const double s : {0.9, 2.3}) model_.vertices.push_back(at(s, z, d));
    constexpr uint32_t kSides[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {0, 4, 6, 2},
                                       {5, 1, 3, 7}, {6, 7, 3, 2}, {0, 1, 5, 4}};
    model_.solids.push_back({sill_, model_.faces.size(), 6});
    for (const auto& side : kSides) {
      Face face;
      face.part = sill_;
      face.id = 6;
      face.first_ring = model_.rings.size();
      face.ring_count = 1;
      model_.rings.push_back({model_.corners.size(), 4});
      for (const uint32_t v : side) {
        model_.corners.push_back(first + v);
        model_.sagittas.push_back(0);
      }
      const auto corner = [&](size_t k) { return model_.vertices[first + side[k]]; };
      const Vec3 twice = cross(corner(2) - corner(0), corner(3) - corner(1));
      face.plane.normal = normalized(twice);
      face.plane.offset = dot(face.plane.normal, corner(0));
      face.area_m2 = norm(twice) / 2;
      model_.faces.push_back(face);
    }
  }

  Model model_;
  uint32_t building_, facade_, wall_, window_, joinery_, door_, copy_, round_, shadow_, sill_,
      ground_, roof_;
};

/// Of all faces of a model, m2.
inline double face_area(const Model& model) {
  double sum = 0;
  for (const Face& face : model.faces) sum += face.area_m2;
  return sum;
}

}  // namespace jalon::test
