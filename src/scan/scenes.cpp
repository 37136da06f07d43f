// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scenes.h"

#include <cmath>

#include "scan/scanner.h"

namespace jalon {

std::span<const ParamRow> scene_rows() {
  static constexpr ParamRow kRows[] = {
      choice_row("name", "facade", "facade|street|room|box|surrounds|strips", "",
                 "facade: a town house with doors, windows, plinth, cornice and ground; street: 60 m, six facades, "
                 "columns, gutters, "
                 "boxes, a sphere (the panes of one facade share an id); room: six walls from inside; box: on a "
                 "ground; surrounds: "
                 "wall, window surrounds, joinery; strips: six staggered strips"),
      number_row("rotation_rad", 0, -10, 10, "rad", "", "turns the scene about the vertical axis through its origin"),
      number_row("width_m", 22, 2, 1000, "m", "facade", "width of the facade"),
      number_row("height_m", 10, 3, 200, "m", "facade", "height of the facade, cornice included"),
      integer_row("storeys", 3, 1, 50, "1", "facade", "rows of windows"),
      integer_row("bays", 7, 1, 500, "1", "facade", "columns of windows"),
      integer_row("doors", 2, 0, 100, "1", "facade", "doors among the openings of the ground floor"),
      number_row("reveal_m", 0.20, 0, 2, "m", "facade",
                 "depth of window reveals; 1.25, 1 and 0.75 times this from storey to storey, 1.5 times at doors"),
      number_row("frame_m", 0, 0, 0.5, "m", "facade",
                 "distance of the glass behind an 8 cm wide window frame; 0: one closed pane without a frame"),
      number_row("cornice_m", 0.35, 0, 3, "m", "facade", "depth of the cornice before the wall; 0: none"),
      number_row("ground_m", 6, 0, 200, "m", "facade", "depth of the ground in front of the wall; 0: none"),
      integer_row(
          "epoch", 1, 1, 2, "1", "street",
          "2: one box gone, one box and one pole new, five patches of the walls moved by 5, 20, 100, -20 and 5 mm"),
  };
  return kRows;
}

Model build_scene(const ParamSet& params, Task& task) {
  task.checkpoint(0);
  const std::string& name = params.text("name");
  const double angle = params.number("rotation_rad") + (name == "street" ? kStreetAngle_rad : 0);
  Transform T_world_scene;
  if (angle != 0) {
    const double c = std::cos(angle), s = std::sin(angle);
    T_world_scene.m = {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0};
  }
  SceneBuilder builder(T_world_scene);
  if (name == "facade") build_facade(params, builder);
  if (name == "street") build_street(params, builder);
  if (name == "room") build_room(builder);
  if (name == "box") build_box(builder);
  if (name == "surrounds") build_surrounds(builder);
  if (name == "strips") build_strips(builder);
  return builder.take();
}

}  // namespace jalon
