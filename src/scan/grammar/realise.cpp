// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/realise.h"

#include <string>

namespace jalon::grammar {

namespace {

void add_pad(SceneBuilder& out, uint32_t parent, const Frame& wall, const Pad& pad) {
  const uint32_t part = out.part(pad.part_class, pad.part_class, parent);
  std::vector<Outline> holes;
  for (const Contour& hole : pad.holes) holes.push_back(chords_of(hole));
  out.polygon_face(part, wall.raised(pad.high_m), chords_of(pad.outline), holes);
  add_sides(out, part, wall, pad.outline, pad.low_m, pad.high_m, false);
  for (const Contour& hole : pad.holes)
    add_sides(out, part, wall, hole, pad.low_m, pad.high_m, true);
}

void add_wall(SceneBuilder& out, uint32_t facade, const PlannedWall& planned, Dice& dice) {
  const uint32_t wall = out.part(planned.name, "wall", facade);
  const Frame frame = planned.frame();
  // 1. The wall itself: openings at its border are notches.
  std::vector<Contour> notches;
  std::vector<Outline> holes;
  for (const PlannedOpening& o : planned.openings) {
    const Contour contour = contour_of(o.shape);
    if (touches_border(planned.outline, contour)) notches.push_back(contour);
    else holes.push_back(chords_of(contour));
  }
  out.polygon_face(wall, frame, chords_of(notched(planned.outline, notches)), holes);
  // 2. What fills its openings, and what stands on it.
  size_t number = 0;
  for (const PlannedOpening& o : planned.openings) {
    const char* word = name_of(o.opening_class);
    const uint32_t part = out.part(word + (" " + std::to_string(++number)), word, wall);
    add_filling(out, part, frame, o, dice);
  }
  for (const Pad& pad : planned.pads) add_pad(out, facade, frame, pad);
}

}  // namespace

void realise(const Plan& plan, Dice& dice, SceneBuilder& out) {
  const uint32_t facade = out.part("facade", "facade");
  for (const PlannedWall& wall : plan.walls) add_wall(out, facade, wall, dice);
  for (const Plate& plate : plan.plates)
    out.face(out.part(plate.part_class, plate.part_class, facade), plate.frame, plate.rect);
  for (const Block& block : plan.blocks)
    out.box(out.part(block.part_class, block.part_class, facade), block.corner, block.size, true);
  constexpr int kFacets = 24;
  if (!plan.pipes.empty()) out.part("drainpipes", "pipe", facade);
  for (const Pipe& pipe : plan.pipes)
    out.cylinder(pipe.foot, pipe.radius_m, pipe.height_m, kFacets);
}

}  // namespace jalon::grammar
