// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/building_offsets.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/random.h"
#include "base/setting_rows.h"
#include "model/buildings/part_numbers.h"
#include "model/part_classes.h"

namespace jalon {

namespace {

constexpr auto kBuildingSigmaRows = setting_rows(
    number_row<&BuildingSigmas::block_m>("sigma_block_m", 0, 1000, "m", "",
                                         "Standard deviation of a block's place, east and north."),
    number_row<&BuildingSigmas::facade_m>("sigma_facade_m", 0, 1000, "m", "",
                                          "Standard deviation of a facade along its normal."),
    number_row<&BuildingSigmas::strip_m>(
        "sigma_strip_m", 0, 1000, "m", "",
        "Standard deviation of a strip along its facade's normal."),
    integer_row<&BuildingSigmas::seed>("seed", 0, 1e15, "", "", "Of the draw."));

size_t parts_of_class(const Model& model, const char* name) {
  return static_cast<size_t>(std::count_if(model.parts.begin(), model.parts.end(),
                                           [&](const Part& p) { return p.part_class == name; }));
}

// Blocks, facades and strips draw from streams of their own: more of one change none of the others.
constexpr uint64_t kBlockDraws = 1, kFacadeDraws = 2, kStripDraws = 3;

std::vector<double> drawn_along(size_t n, double sigma_m, uint64_t seed, uint64_t stream) {
  RandomStream random(seed, stream);
  std::vector<double> out(n);
  for (double& v : out) v = sigma_m * random.normal();
  return out;
}

}  // namespace

std::span<const ParamRow> building_sigma_rows() { return kBuildingSigmaRows; }

BuildingOffsets drawn_offsets(const Model& strips, const BuildingSigmas& sigmas) {
  BuildingOffsets made;
  RandomStream random(sigmas.seed, kBlockDraws);
  for (size_t b = 0; b < parts_of_class(strips, part_class::kBlock); ++b) {
    const double x = sigmas.block_m * random.normal(), y = sigmas.block_m * random.normal();
    made.blocks.push_back({x, y});
  }
  made.facades = drawn_along(parts_of_class(strips, part_class::kFacade), sigmas.facade_m,
                             sigmas.seed, kFacadeDraws);
  made.strips = drawn_along(parts_of_class(strips, part_class::kStrip), sigmas.strip_m, sigmas.seed,
                            kStripDraws);
  return made;
}

Model moved_strips(const Model& strips, const BuildingOffsets& offsets) {
  const std::vector<PartNumbers> numbers = part_numbers(strips);
  constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
  Model moved = strips;
  bool has_strips = false;
  for (Face& face : moved.faces) {
    const PartNumbers& n = numbers[face.part];
    const bool is_strip = n.strip != kNone;
    if (!is_strip && n.block == kNone) continue;
    has_strips |= is_strip;
    if (n.block >= offsets.blocks.size() ||
        (is_strip && (n.facade >= offsets.facades.size() || n.strip >= offsets.strips.size())))
      fail(Status::kInvalidArgument,
           "face %u is of no strip, facade and block: it is no model of strips", face.id);
    const Vec2& b = offsets.blocks[n.block];
    Vec3 by{b.u, b.v, 0};
    if (is_strip) by += face.plane.normal * (offsets.facades[n.facade] + offsets.strips[n.strip]);
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      for (uint64_t c = moved.rings[r].first; c < moved.rings[r].first + moved.rings[r].count; ++c)
        moved.vertices[moved.corners[c]] += by;
    face.plane.offset += dot(face.plane.normal, by);
  }
  if (!has_strips)
    fail(Status::kInvalidArgument,
         "it is no model of strips: jalon_model_building_strips makes one");
  return moved;
}

}  // namespace jalon
