// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/given_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The parts of one class, numbered in their order.
class Numbered {
 public:
  Numbered(const Model& model, const char* part_class) : model_(model), part_class_(part_class) {
    for (const Part& part : model.parts)
      number_.push_back(part.part_class == part_class ? n_++ : 0);
  }
  size_t size() const { return n_; }
  // The number of the part or of the nearest above it; kNoPart: none is.
  uint32_t above(uint64_t part) const {
    for (; part < model_.parts.size(); part = model_.parts[part].parent)
      if (model_.parts[part].part_class == part_class_) return number_[part];
    return kNoPart;
  }

 private:
  const Model& model_;
  const char* part_class_;
  std::vector<uint32_t> number_;
  uint32_t n_ = 0;
};

class GivenStrips {
 public:
  GivenStrips(const Model& model)
      : model_(model),
        blocks_(model, part_class::kBlock),
        buildings_(model, part_class::kBuilding),
        facades_(model, part_class::kFacade),
        strips_(model, part_class::kStrip) {}

  BuildingTree run() {
    add_parts();
    sort_faces();
    for (uint32_t f = 0; f < tree_.facades.size(); ++f) place_facade(f);
    return std::move(tree_);
  }

 private:
  void add_parts() {
    tree_.crs = model_.crs;
    tree_.blocks = static_cast<uint32_t>(blocks_.size());
    tree_.facades.resize(facades_.size());
    tree_.strips.resize(strips_.size());
    for (uint64_t p = 0; p < model_.parts.size(); ++p) {
      const Part& part = model_.parts[p];
      if (part.part_class == part_class::kBuilding) {
        tree_.buildings.push_back(part.name);
        tree_.block_of_building.push_back(blocks_.above(p));
      }
      if (part.part_class == part_class::kFacade)
        tree_.facades[facades_.above(p)].building = buildings_.above(p);
      if (part.part_class == part_class::kStrip)
        tree_.strips[strips_.above(p)].facade = facades_.above(p);
    }
  }

  void sort_faces() {
    faces_of_.resize(strips_.size());
    strips_of_.resize(facades_.size());
    for (uint32_t s = 0; s < tree_.strips.size(); ++s)
      strips_of_[tree_.strips[s].facade].push_back(s);
    for (uint32_t f = 0; f < model_.faces.size(); ++f) {
      const uint32_t part = model_.faces[f].part, strip = strips_.above(part);
      if (strip != kNoPart) faces_of_[strip].push_back(f);
      else tree_.others.push_back({f, buildings_.above(part)});
    }
  }

  template <class F>
  void each_corner(uint32_t face, F&& visit) const {
    const Ring& ring = model_.rings[model_.faces[face].first_ring];
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c)
      visit(model_.vertices[model_.corners[c]]);
  }

  double mean_along(const Vec3& normal, uint32_t face) const {
    double sum = 0;
    each_corner(face, [&](const Vec3& p) { sum += dot(normal, p); });
    return sum / static_cast<double>(model_.rings[model_.faces[face].first_ring].count);
  }

  double weight_of(uint32_t face) const { return std::max(0.0, model_.faces[face].area_m2); }

  void place_facade(uint32_t number) {
    BuildingFacade& facade = tree_.facades[number];
    Vec3 sum;
    double area_m2 = 0;
    for (const uint32_t s : strips_of_[number])
      for (const uint32_t f : faces_of_[s]) {
        sum += model_.faces[f].plane.normal * weight_of(f);
        area_m2 += weight_of(f);
      }
    const double level = std::hypot(sum.x, sum.y);
    if (!(level > 0)) return;  // no strip of it has a face
    facade.normal = {sum.x / level, sum.y / level, 0};
    for (const uint32_t s : strips_of_[number])
      for (const uint32_t f : faces_of_[s])
        facade.offset_m += mean_along(facade.normal, f) * weight_of(f) / area_m2;
    facade.from_m = facade.bottom_m = kInfinite, facade.to_m = facade.top_m = -kInfinite;
    for (const uint32_t s : strips_of_[number]) place_strip(facade, s);
  }

  void place_strip(BuildingFacade& facade, uint32_t number) {
    BuildingStrip& strip = tree_.strips[number];
    if (faces_of_[number].empty()) return;
    double sum = 0, area_m2 = 0, from = kInfinite, to = -kInfinite;
    for (const uint32_t f : faces_of_[number]) {
      sum += mean_along(facade.normal, f) * weight_of(f);
      area_m2 += weight_of(f);
      std::vector<Vec2>& outline = strip.outlines.emplace_back();
      each_corner(f, [&](const Vec3& p) {
        outline.push_back({dot(facade.along(), p), p.z});
        from = std::min(from, outline.back().u), to = std::max(to, outline.back().u);
        facade.bottom_m = std::min(facade.bottom_m, p.z);
        facade.top_m = std::max(facade.top_m, p.z);
      });
    }
    strip.from_m = from, strip.to_m = to;
    if (area_m2 > 0) strip.offset_m = sum / area_m2 - facade.offset_m;
    facade.from_m = std::min(facade.from_m, from), facade.to_m = std::max(facade.to_m, to);
  }

  const Model& model_;
  Numbered blocks_, buildings_, facades_, strips_;
  std::vector<std::vector<uint32_t>> faces_of_, strips_of_;  // of each strip, of each facade
  BuildingTree tree_;
};

}  // namespace

bool is_of_strips(const Model& model) {
  const Numbered blocks(model, part_class::kBlock), buildings(model, part_class::kBuilding),
      facades(model, part_class::kFacade), strips(model, part_class::kStrip);
  for (uint64_t p = 0; p < model.parts.size(); ++p) {
    const std::string& part_class = model.parts[p].part_class;
    const bool is_lost = (part_class == part_class::kStrip && facades.above(p) == kNoPart) ||
                         (part_class == part_class::kFacade && buildings.above(p) == kNoPart) ||
                         (part_class == part_class::kBuilding && blocks.above(p) == kNoPart);
    if (is_lost) return false;
  }
  std::vector<const Face*> first_of(facades.size(), nullptr);
  for (const Face& face : model.faces) {
    if (strips.above(face.part) == kNoPart) continue;
    const Face*& first = first_of[facades.above(face.part)];
    if (first == nullptr) first = &face;
    const Vec3& n = face.plane.normal;
    constexpr double kSameWay = 0.996;  // 5 degrees, as building_strips takes facades
    if (!(std::hypot(n.x, n.y) > kSameWay) || !(dot(n, first->plane.normal) > kSameWay))
      return false;
  }
  return strips.size() > 0;
}

BuildingTree given_strips(const Model& model) { return GivenStrips(model).run(); }

}  // namespace jalon
