// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/city/parts.h"

#include "model/part_classes.h"

namespace jalon::city {

namespace {

struct Pair {
  const char* part_class;
  const char* type;
};
constexpr Pair kPairs[] = {
    {part_class::kWall, "WallSurface"},
    {part_class::kWindow, "Window"},
    {part_class::kDoor, "Door"},
    {part_class::kOpening, "ClosureSurface"},
    {part_class::kRoof, "RoofSurface"},
    {part_class::kGround, "GroundSurface"},
    // Neither windows nor doors, so that those can be counted; the attribute "class" says which.
    {part_class::kGateway, "ClosureSurface"},
    {part_class::kShopFront, "ClosureSurface"},
    {part_class::kVent, "ClosureSurface"},
    {part_class::kRecess, "ClosureSurface"},
};

}  // namespace

uint32_t nearest(const Model& model, uint32_t part, const char* part_class) {
  for (size_t steps = 0; part < model.parts.size() && steps <= model.parts.size(); ++steps) {
    if (model.parts[part].part_class == part_class) return part;
    const uint64_t parent = model.parts[part].parent;
    part = parent < model.parts.size() ? static_cast<uint32_t>(parent) : kNoPart;
  }
  return kNoPart;
}

const char* surface_type(const Model& model, uint32_t part) {
  if (part >= model.parts.size()) return "WallSurface";
  std::string part_class = model.parts[part].part_class;
  if (part_class == part_class::kJoinery) {
    const uint64_t parent = model.parts[part].parent;
    part_class =
        parent < model.parts.size() && part_class::is_opening(model.parts[parent].part_class)
            ? model.parts[parent].part_class
            : part_class::kWindow;
  }
  for (const Pair& pair : kPairs)
    if (part_class == pair.part_class) return pair.type;
  return "WallSurface";
}

const char* class_of_surface(std::string_view type) {
  for (const Pair& pair : kPairs)
    if (type == pair.type) return pair.part_class;
  return part_class::kElement;
}

std::string class_of_object(std::string_view type) {
  if (type == "BuildingPart") return part_class::kBuilding;  // it stands below its building
  if (type.starts_with('+')) type.remove_prefix(1);          // of an extension
  const auto is_capital = [&](size_t i) {
    return i < type.size() && type[i] >= 'A' && type[i] <= 'Z';
  };
  std::string out;
  for (size_t i = 0; i < type.size(); ++i) {
    // A word begins where a capital follows a small letter or goes before one: "TINRelief" has two.
    const bool begins = i > 0 && is_capital(i) &&
                        (!is_capital(i - 1) || (i + 1 < type.size() && !is_capital(i + 1)));
    if (begins) out += '_';
    out += is_capital(i) ? static_cast<char>(type[i] - 'A' + 'a') : type[i];
  }
  return out;
}

Openings find_openings(const Model& model) {
  Openings out;
  out.wall.assign(model.parts.size(), kNoPart);
  out.filled.assign(model.parts.size(), 0);
  for (const Face& face : model.faces) {
    for (uint64_t r = 1; r < face.ring_count; ++r) {
      const uint32_t part = model.rings[face.first_ring + r].part;
      if (part < model.parts.size()) out.wall[part] = face.part;
    }
    // The sides of an opening do not close it.
    if (face.part >= model.parts.size() || model.parts[face.part].part_class == part_class::kReveal)
      continue;
    for (uint64_t p = face.part; p < model.parts.size() && out.filled[p] == 0;
         p = model.parts[p].parent)
      out.filled[p] = 1;
  }
  return out;
}

}  // namespace jalon::city
