// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/opening_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "model/part_classes.h"
#include "modelling/plane/plane_frame.h"
#include "report/elevation/face_rings.h"
#include "report/elevation/opening_precision.h"
#include "report/names/part_tree.h"

namespace jalon {

namespace {

// Holes of a model that names no openings: what a person could look or step through, in steep planes.
constexpr double kSmallestHole_m = 0.3, kSteep = 0.26;

// The rings of each part that fills holes of its wall.
std::vector<std::vector<FaceRing>> filled_holes(const Model& model) {
  std::vector<std::vector<FaceRing>> out(model.parts.size());
  for (size_t f = 0; f < model.faces.size(); ++f)
    for (uint64_t r = 1; r < model.faces[f].ring_count; ++r) {
      const uint64_t ring = model.faces[f].first_ring + r;
      if (model.rings[ring].part < out.size()) out[model.rings[ring].part].push_back({f, ring});
    }
  return out;
}

void measure(OpeningRow& row, const Model& model) {
  FaceBox box;
  for (const FaceRing& at : row.contour) {
    box += ring_box(model, at);
    row.arched |= has_arc(model, model.rings[at.ring]);
  }
  if (row.contour.empty()) return;
  row.width_m = box.width();
  row.height_m = box.height();
  set_precision(row, model);
}

// What is seen in each opening: the faces of its part and below it, without the reveals.
std::vector<std::vector<size_t>> faces_inside(const Model& model, const PartTree& tree) {
  std::vector<std::vector<size_t>> out(model.parts.size());
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    if (face.part >= model.parts.size() || face.ring_count == 0) continue;
    if (model.parts[face.part].part_class == part_class::kReveal) continue;
    const uint32_t opening = tree.nearest(
        face.part, [&](uint32_t p) { return part_class::is_opening(model.parts[p].part_class); });
    if (opening != kNoPart) out[opening].push_back(f);
  }
  return out;
}

OpeningRow row_of(const Model& model, const PartTree& tree, uint32_t part,
                  std::vector<FaceRing> holes, std::vector<size_t> inside) {
  const Part& p = model.parts[part];
  OpeningRow row;
  row.part = part;
  row.name = part_label(model, part);
  row.part_class = p.part_class;
  row.class_confidence = p.class_confidence;
  row.evidence = p.evidence;
  row.copied_from = p.copied_from;
  row.depth_m = p.depth_m;
  row.contour = std::move(holes);
  row.joinery = std::move(inside);
  if (row.contour
          .empty())  // a door that reaches the ground is a notch of the wall's outline, and no hole
    for (const size_t f : row.joinery) row.contour.push_back({f, model.faces[f].first_ring});
  if (!row.contour.empty()) row.wall = row.contour.front().face;
  const bool is_notch =
      !row.contour.empty() && row.contour.front().ring == model.faces[row.wall].first_ring;
  if (is_notch && p.parent < model.parts.size() && !tree.faces()[p.parent].empty())
    row.wall = tree.faces()[p.parent].front();
  measure(row, model);
  if (std::isfinite(p.width_m)) row.width_m = p.width_m;
  if (std::isfinite(p.height_m)) row.height_m = p.height_m;
  return row;
}

std::vector<OpeningRow> named_openings(const Model& model) {
  const PartTree tree(model);
  auto holes = filled_holes(model);
  auto inside = faces_inside(model, tree);
  std::vector<OpeningRow> rows;
  for (uint32_t part = 0; part < model.parts.size(); ++part)
    if (part_class::is_opening(model.parts[part].part_class))
      rows.push_back(row_of(model, tree, part, std::move(holes[part]), std::move(inside[part])));
  return rows;
}

std::vector<OpeningRow> unnamed_holes(const Model& model) {
  std::vector<OpeningRow> rows;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    if (std::fabs(face.plane.normal.z) > kSteep) continue;
    for (uint64_t r = 1; r < face.ring_count; ++r) {
      OpeningRow row;
      row.name = "hole " + std::to_string(rows.size() + 1);
      row.part_class = part_class::kOpening;
      row.contour.push_back({f, face.first_ring + r});
      row.wall = f;
      measure(row, model);
      if (std::min(row.width_m, row.height_m) >= kSmallestHole_m) rows.push_back(std::move(row));
    }
  }
  return rows;
}

// The place of a class in lists, and its letter in tags: both in the order of part_class::kOpenings.
constexpr std::string_view kLetters = "WDGSVRO";
static_assert(kLetters.size() == std::size(part_class::kOpenings));

size_t class_rank(std::string_view c) {
  const auto* at = std::find(std::begin(part_class::kOpenings), std::end(part_class::kOpenings), c);
  return std::min(static_cast<size_t>(at - part_class::kOpenings), kLetters.size() - 1);
}

bool is_alike(const OpeningType& type, const OpeningRow& row, double tolerance_m) {
  return class_rank(type.part_class) == class_rank(row.part_class) && type.arched == row.arched &&
         std::fabs(type.width_m - row.width_m) <= tolerance_m &&
         std::fabs(type.height_m - row.height_m) <= tolerance_m;
}

// The first type that the row fits joins it; its means follow.
void sort_into_types(OpeningList& list, double tolerance_m) {
  for (OpeningRow& row : list.rows) {
    auto type = std::find_if(list.types.begin(), list.types.end(),
                             [&](const OpeningType& t) { return is_alike(t, row, tolerance_m); });
    if (type == list.types.end())
      type = list.types.insert(type, {"", row.part_class, 0, 0, row.arched, 0, 0});
    const auto n = static_cast<double>(++type->count);
    type->copies += row.is_copy();
    type->width_m += (row.width_m - type->width_m) / n;
    type->height_m += (row.height_m - type->height_m) / n;
    row.type = static_cast<size_t>(type - list.types.begin());
  }
}

void name_types(OpeningList& list) {
  std::vector<size_t> order(list.types.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t k) {
    const OpeningType &a = list.types[i], &b = list.types[k];
    if (class_rank(a.part_class) != class_rank(b.part_class))
      return class_rank(a.part_class) < class_rank(b.part_class);
    return a.count != b.count ? a.count > b.count : a.width_m * a.height_m > b.width_m * b.height_m;
  });
  std::vector<OpeningType> types;
  std::vector<size_t> place(order.size());
  std::array<size_t, kLetters.size()> number{};
  for (const size_t i : order) {
    place[i] = types.size();
    types.push_back(list.types[i]);
    const size_t rank = class_rank(types.back().part_class);
    types.back().tag = kLetters[rank] + std::to_string(++number[rank]);
  }
  for (OpeningRow& row : list.rows) row.type = place[row.type];
  list.types = std::move(types);
}

}  // namespace

size_t count_of(const OpeningList& list, std::string_view part_class) {
  return static_cast<size_t>(
      std::count_if(list.rows.begin(), list.rows.end(),
                    [&](const OpeningRow& row) { return row.part_class == part_class; }));
}

OpeningList list_openings(const Model& model, double tolerance_m) {
  OpeningList list;
  list.rows = named_openings(model);
  if (list.rows.empty()) list.rows = unnamed_holes(model);
  sort_into_types(list, tolerance_m);
  name_types(list);
  return list;
}

}  // namespace jalon
