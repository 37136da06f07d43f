// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/scenes/scenes.h"

#include "base/error.h"
#include "base/setting_rows.h"
#include "scan/builder/scene_frame.h"
#include "scan/grammar/grammar.h"
#include "scan/yard/yard.h"

namespace jalon {

namespace {

struct Scene {
  SceneName name;
  void (*build)(const SceneSettings&, SceneBuilder&);
  double angle_rad = 0;  ///< about Z, before the caller's
  Vec3 shift{};          ///< after the turn, before the caller's
};

const Scene& find_scene(SceneName name) {
  static constexpr Scene kScenes[] = {
      {SceneName::kFacade, build_facade},
      {SceneName::kStreet, build_street, kStreetAngle_rad},
      {SceneName::kRoom, build_room},
      {SceneName::kBox, build_box},
      {SceneName::kSurrounds, build_surrounds},
      {SceneName::kStrips, build_strips},
      {SceneName::kInsa,
       build_insa,
       kInsaAngle_rad,
       {kInsaShift_m[0], kInsaShift_m[1], kInsaShift_m[2]}},
      {SceneName::kInsaSurveyed, build_insa_surveyed},
      {SceneName::kUnwanted, build_unwanted},
      {SceneName::kStd, build_std},
      {SceneName::kNormal, build_normal},
      {SceneName::kPatches, build_patches},
      {SceneName::kSills, build_sills},
      {SceneName::kRobbery, build_robbery},
      {SceneName::kLycee, build_lycee},
      {SceneName::kArches, build_arches},
      {SceneName::kResidence, build_residence},
      {SceneName::kEarthworks, build_earthworks},
      {SceneName::kGrammar, build_grammar},
      {SceneName::kBow, build_bow},
      {SceneName::kYard, build_yard, 0, {kYardShift_m[0], kYardShift_m[1], kYardShift_m[2]}},
  };
  for (const Scene& scene : kScenes)
    if (name == scene.name) return scene;
  fail(Status::kInternal, "scene %d has a name and no builder", static_cast<int>(name));
}

}  // namespace

std::span<const ParamRow> scene_rows() {
  using S = SceneSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::name>(
          "name",
          "facade|street|room|box|surrounds|strips|insa|insa_surveyed|unwanted|std|normal|patches|"
          "sills|robbery|lycee|arches|residence|earthworks|grammar|bow|yard",
          "",
          "facade: a town house with doors, windows, plinth, cornice and ground; street: 60 m, six "
          "facades, columns, gutters, boxes, a sphere (the panes of one facade share an id); room: "
          "six walls from inside; box: on a ground; surrounds: wall, window surrounds, joinery; "
          "strips: six staggered strips; insa: 68 x 22 m of posts, bands, mullions and windows, "
          "turned by 37 degrees and shifted by (1000, 500, 40) m; insa_surveyed: the same building "
          "with the depths of its survey; residence: that with balconies; unwanted: surrounds "
          "behind trees, cars and pedestrians, furniture behind the glass; std: ten planes; "
          "normal: one plane; patches: two of one plane; sills: a wall and two sills; robbery: a "
          "wall and a shelf; lycee: six facades, eight arched windows, two trees; arches: two "
          "walls, square and arched windows; earthworks: rolling ground of 60 x 40 m between "
          "walls, on four days; grammar: a facade of the kind and by the seed told, which brings "
          "its "
          "own scanner and writes its truth; bow: a wall 8 m high, bent about an axis 6 m behind "
          "it; yard: low buildings of corrugated sheet with targets, which bring the code lists of "
          "a survey"),
      number_row<&S::rotation_rad>("rotation_rad", -10, 10, "rad", "",
                                   "turns the scene about the vertical axis through its origin"),
      doubles_row<&S::shift_m>("shift_m", -1e9, 1e9, "m", "",
                               "three numbers added to all coordinates after the turn"),
      number_row<&S::width_m>("width_m", 2, 1000, "m", "facade", "width of the facade"),
      number_row<&S::height_m>("height_m", 3, 200, "m", "facade",
                               "height of the facade, cornice included"),
      integer_row<&S::storeys>("storeys", 1, 50, "1", "facade", "rows of windows"),
      integer_row<&S::bays>("bays", 1, 500, "1", "facade", "columns of windows"),
      integer_row<&S::doors>("doors", 0, 100, "1", "facade",
                             "doors among the openings of the ground floor"),
      number_row<&S::reveal_m>("reveal_m", 0, 2, "m", "facade",
                               "depth of window reveals; 1.25, 1 and 0.75 times this from storey "
                               "to storey, 1.5 times at doors"),
      number_row<&S::frame_m>("frame_m", 0, 0.5, "m", "facade",
                              "distance of the glass behind an 8 cm wide window frame; 0: one "
                              "closed pane without a frame"),
      number_row<&S::cornice_m>("cornice_m", 0, 3, "m", "facade",
                                "depth of the cornice before the wall; 0: none"),
      number_row<&S::ground_m>("ground_m", 0, 200, "m", "facade",
                               "depth of the ground in front of the wall; 0: none"),
      integer_row<&S::epoch>("epoch", 1, 2, "1", "street",
                             "2: one box gone, one box and one pole new, five patches of the walls "
                             "moved by 5, 20, 100, -20 and 5 mm"),
      integer_row<&S::day>("day", 1, 4, "1", "earthworks",
                           "2: a heap of earth is new; 3: an excavator, and a pit is dug; 4: the "
                           "excavator has moved, a free wall is gone"),
      number_row<&S::glass_m>("glass_m", 0, 1, "m", "surrounds",
                              "distance of the glass behind the joinery; 0: no glass"),
      number_row<&S::gap_m>("gap_m", 0, 1, "m", "sills", "gap between the sills and the wall"),
      number_row<&S::depth_m>("depth_m", 0.01, 5, "m", "robbery",
                              "depth of the shelf along the wall"),
      bool_row<&S::crossing>("crossing", "robbery",
                             "the shelf crosses the wall, half its depth behind it"),
      integer_row<&S::seed>("seed", 0, 9007199254740992.0, "1",
                            "insa,insa_surveyed,residence,unwanted,lycee,grammar,yard",
                            "of open windows, curtains, furniture and leaves; of grammar: of all "
                            "that is not told"),
      nested_rows<&S::grammar, kGrammarRows>(), nested_rows<&S::yard, kYardRows>());
  return kRows;
}

Model build_scene(const SceneSettings& settings, Task& task) {
  task.checkpoint(0);
  const Scene& scene = find_scene(settings.name);
  SceneBuilder builder(scene_frame(settings, scene.angle_rad, scene.shift));
  scene.build(settings, builder);
  return builder.take();
}

}  // namespace jalon
