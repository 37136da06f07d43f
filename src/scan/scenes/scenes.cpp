// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scenes/scenes.h"

#include <cmath>

#include "base/error.h"
#include "scan/scanner.h"

namespace jalon {

namespace {

struct Scene {
  const char* name;
  void (*build)(const ParamSet&, SceneBuilder&);
  double angle_rad = 0;  ///< about Z, before the caller's
  Vec3 shift{};          ///< after the turn, before the caller's
};

const Scene& find_scene(const std::string& name) {
  static constexpr Scene kScenes[] = {
      {"facade", build_facade},
      {"street", build_street, kStreetAngle_rad},
      {"room", build_room},
      {"box", build_box},
      {"surrounds", build_surrounds},
      {"strips", build_strips},
      {"insa", build_insa, kInsaAngle_rad, {kInsaShift_m[0], kInsaShift_m[1], kInsaShift_m[2]}},
      {"insa_surveyed", build_insa_surveyed},
      {"unwanted", build_unwanted},
      {"std", build_std},
      {"normal", build_normal},
      {"patches", build_patches},
      {"sills", build_sills},
      {"robbery", build_robbery},
      {"lycee", build_lycee},
      {"arches", build_arches},
      {"residence", build_residence},
      {"earthworks", build_earthworks},
  };
  for (const Scene& scene : kScenes)
    if (name == scene.name) return scene;
  fail(Status::kInternal, "scene \"%s\" has a name and no builder", name.c_str());
}

}  // namespace

std::span<const ParamRow> scene_rows() {
  static constexpr ParamRow kRows[] = {
      choice_row("name", "facade",
                 "facade|street|room|box|surrounds|strips|insa|insa_surveyed|unwanted|std|normal|patches|sills|robbery|"
                 "lycee|arches|residence|earthworks",
                 "",
                 "facade: a town house with doors, windows, plinth, cornice and ground; street: 60 m, six facades, "
                 "columns, gutters, boxes, a sphere (the panes of one facade share an id); room: six walls from "
                 "inside; box: on a ground; surrounds: wall, window surrounds, joinery; strips: six staggered strips; "
                 "insa: 68 x 22 m of posts, bands, mullions and windows, turned by 37 degrees and shifted by (1000, "
                 "500, 40) m; insa_surveyed: the same building with the depths of its survey; residence: that with "
                 "balconies; unwanted: surrounds behind trees, cars and pedestrians, furniture behind the glass; "
                 "std: ten planes; normal: one plane; patches: two of one plane; sills: a wall and two sills; "
                 "robbery: a wall and a shelf; lycee: six facades, eight arched windows, two trees; arches: two "
                 "walls, square and arched windows; earthworks: rolling ground of 60 x 40 m between walls, on four "
                 "days"),
      number_row("rotation_rad", 0, -10, 10, "rad", "", "turns the scene about the vertical axis through its origin"),
      doubles_row("shift_m", "0 0 0", -1e9, 1e9, "m", "", "three numbers added to all coordinates after the turn"),
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
      integer_row("day", 1, 1, 4, "1", "earthworks",
                  "2: a heap of earth is new; 3: an excavator, and a pit is dug; 4: the excavator has moved, a free "
                  "wall is gone"),
      number_row("glass_m", 0, 0, 1, "m", "surrounds", "distance of the glass behind the joinery; 0: no glass"),
      number_row("gap_m", 0, 0, 1, "m", "sills", "gap between the sills and the wall"),
      number_row("depth_m", 0.25, 0.01, 5, "m", "robbery", "depth of the shelf along the wall"),
      bool_row("crossing", false, "robbery", "the shelf crosses the wall, half its depth behind it"),
      integer_row("seed", 1, 0, 9007199254740992.0, "1", "insa,insa_surveyed,residence,unwanted,lycee",
                  "of open windows, curtains, furniture and leaves"),
  };
  return kRows;
}

Model build_scene(const ParamSet& params, Task& task) {
  task.checkpoint(0);
  const Scene& scene = find_scene(params.text("name"));
  const double angle = params.number("rotation_rad") + scene.angle_rad;
  const auto& shift = params.numbers("shift_m");
  if (shift.size() != 3) fail(Status::kInvalidArgument, "shift_m takes three numbers");
  Transform T_world_scene;
  if (angle != 0) {
    const double c = std::cos(angle), s = std::sin(angle);
    T_world_scene.m = {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0};
  }
  for (int a = 0; a < 3; ++a)
    T_world_scene.m[static_cast<size_t>(4 * a + 3)] = scene.shift[a] + shift[static_cast<size_t>(a)];
  SceneBuilder builder(T_world_scene);
  scene.build(params, builder);
  return builder.take();
}

}  // namespace jalon
