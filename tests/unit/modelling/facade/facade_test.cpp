// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <map>

#include "base/error.h"
#include "unit/modelling/facade_scenes.h"
#include "unit/modelling/walls.h"

using namespace facades;

namespace {

const Scan& arches() {
  static const Scan kScan("{\"name\":\"arches\"}",
                          "{\"horizontal_step_rad\":0.0015,\"vertical_step_rad\":0.0015}");
  return kScan;
}

const Scan& town_house() {
  static const Scan kScan("{\"name\":\"facade\"}",
                          "{\"horizontal_step_rad\":0.0015,\"vertical_step_rad\":0.0015}");
  return kScan;
}

bool same_bits(const Model& a, const Model& b) {
  const auto equal = [](const auto& x, const auto& y) {
    using T = typename std::decay_t<decltype(x)>::value_type;
    return x.size() == y.size() &&
           (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0);
  };
  if (!equal(a.vertices, b.vertices) || !equal(a.corners, b.corners) ||
      !equal(a.sagittas, b.sagittas))
    return false;
  if (!equal(a.vertex_covariances, b.vertex_covariances)) return false;
  if (a.faces.size() != b.faces.size() || a.parts.size() != b.parts.size()) return false;
  for (size_t i = 0; i < a.faces.size(); ++i)
    if (a.faces[i].part != b.faces[i].part || a.faces[i].area_m2 != b.faces[i].area_m2)
      return false;
  for (size_t i = 0; i < a.parts.size(); ++i)
    if (a.parts[i].name != b.parts[i].name || a.parts[i].evidence != b.parts[i].evidence)
      return false;
  return true;
}

}  // namespace

TEST_CASE("facade: every window of two walls is found with its depth and its reveals") {
  const Model model = facade_of(arches().segmentation);
  CHECK(parts_of(model, "facade").size() == 1);
  CHECK(parts_of(model, "wall").size() == 2);
  const auto windows = parts_of(model, "window");
  REQUIRE(windows.size() == 8);
  CHECK(parts_of(model, "opening").empty());
  CHECK(parts_of(model, "no_data").empty());
  double worst = 0;
  for (const size_t w : windows) {
    const Part& part = model.parts[w];
    worst = std::max(worst, std::fabs(part.depth_m - 0.15));
    CHECK(part.evidence == Evidence::kRevealed);
    CHECK(model.parts[part.parent].part_class == "wall");
    CHECK(child_of(model, w, "joinery") < model.parts.size());
    CHECK(child_of(model, w, "reveal") < model.parts.size());
  }
  MESSAGE("FIGURE facade depth: worst of 8 windows " << 1000 * worst << " mm");
  CHECK(worst < 0.002);
}

TEST_CASE("facade: holes, reveals and panes share their vertices, rings name their openings") {
  const Model model = facade_of(arches().segmentation);
  std::map<uint32_t, size_t> named;
  for (const Face& face : model.faces)
    for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
      if (model.rings[r].part != kNoPart) ++named[model.rings[r].part];
  for (const size_t w : parts_of(model, "window")) CHECK(named[static_cast<uint32_t>(w)] == 1);
  // An edge of a hole belongs to the wall and a reveal, an edge of a pane to the pane and a reveal: none is used once
  // but those of the walls' outlines and of arcs, whose reveals are strips.
  std::vector<uint8_t> on_outline(model.vertices.size(), 0);
  for (const Face& face : model.faces) {
    if (model.parts[face.part].part_class != "wall") continue;
    const Ring& ring = model.rings[face.first_ring];
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c)
      on_outline[model.corners[c]] = 1;
  }
  size_t shared = 0;
  for (const Edge& edge : find_edges(model)) {
    if (on_outline[edge.from] != 0 || edge.sagitta_m != 0) continue;
    if (edge.uses == 2) ++shared;
  }
  CHECK(shared >= 8 * 3 * 2 + 8 * 4);
}

TEST_CASE("facade: doors, cornice, base course and ground of a town house get their names") {
  const Model model = facade_of(town_house().segmentation);
  const auto doors = parts_of(model, "door"), windows = parts_of(model, "window");
  CHECK(doors.size() == 2);
  CHECK(windows.size() == 19);
  CHECK(parts_of(model, "cornice").size() >= 1);
  CHECK(parts_of(model, "base_course").size() == 3);
  CHECK(parts_of(model, "ground").size() >= 1);
  for (const size_t d : doors) {
    CHECK(std::fabs(model.parts[d].depth_m - 0.30) < 0.01);
    CHECK(std::fabs(model.parts[d].width_m - 1.30) < 0.03);
  }
  // Storeys have reveals of 25, 20 and 15 cm; rows are counted from below.
  for (const size_t w : windows) {
    const double expected = 0.30 - 0.05 * (model.parts[w].name[7] - '0');
    CHECK(std::fabs(model.parts[w].depth_m - expected) < 0.005);
  }
  std::set<std::string> names;
  for (const size_t w : windows) CHECK(names.insert(model.parts[w].name).second);
  CHECK(names.count("window 1.1") == 1);
  CHECK(names.count("window 3.7") == 1);
}

namespace {

// A wall of 10 x 4 m with a window (pane 20 cm behind) and a box 2 m in front, as one eye sees them.
struct Hidden {
  double away_m = 8;  ///< of the eye from the wall: from far away a box lies on its own shadow
  const Vec3 eye{5, -away_m, 1.5};
  const walls::Rectangle window{2, 1, 3.2, 2.5}, box{6.2, 0.6, 7, 1.4};

  bool sees(const Vec3& p) const {
    const double t = (-2 - eye.y) / (p.y - eye.y);  // where the ray meets the plane of the box
    const Vec3 q = eye + (p - eye) * t;
    return t >= 1 || !box.contains(q.x, q.z);
  }
  Segmentation segmentation(bool with_station) const {
    std::vector<Vec3> wall, pane, front;
    RandomStream random(3, 1);
    const double step = 0.02;
    for (double x = 0.01; x < 10; x += step)
      for (double z = 0.01; z < 4; z += step) {
        const Vec3 p{x, 0.002 * random.normal(), z};
        if (!window.contains(x, z)) {
          if (sees(p)) wall.push_back(p);
        } else {
          const Vec3 q{x, 0.2, z};
          const Vec3 crossing = eye + (q - eye) * (-eye.y / (q.y - eye.y));
          if (window.contains(crossing.x, crossing.z) && sees(q)) pane.push_back(q);
        }
        if (box.contains(x, z)) front.push_back({x, -2, z});
      }
    Segmentation out = walls::segmentation_of({wall, pane, front});
    Cloud cloud = *out.cloud;
    Station station;
    station.has_pose = with_station;
    station.pose.m[3] = eye.x, station.pose.m[7] = eye.y, station.pose.m[11] = eye.z;
    station.count = cloud.size();
    cloud.stations = {station};
    out.cloud = std::make_shared<const Cloud>(cloud);
    return out;
  }
};

}  // namespace

TEST_CASE("facade: what something in front hides is no opening but a hole without data") {
  const Hidden hidden;
  const Model model = facade_of(hidden.segmentation(true));
  REQUIRE(parts_of(model, "window").size() == 1);
  CHECK(std::fabs(model.parts[parts_of(model, "window")[0]].depth_m - 0.2) < 0.002);
  const auto shadows = parts_of(model, "no_data");
  REQUIRE(shadows.size() == 1);
  // Seen from the eye the box of 0.8 m throws a shadow of 0.8 x 8 / 6 m, from 6.6 to 7.667 m.
  const Box3 box = box_of_part(model, shadows[0]);
  CHECK(std::fabs(box.min.x - 6.6) < 0.05);
  CHECK(std::fabs(box.max.x - 7.667) < 0.05);
}

TEST_CASE(
    "facade: fill says what of a wall is drawn where nobody measured, by contour and by evidence") {
  const Hidden hidden;
  const Segmentation segmentation = hidden.segmentation(true);
  const auto wall_and_no_data_m2 = [](const Model& model) {
    std::array<double, 2> out{};
    for (const Face& face : model.faces) {
      if (model.parts[face.part].part_class == "wall") out[0] += face.area_m2;
      if (model.parts[face.part].part_class == "no_data") out[1] += face.area_m2;
    }
    return out;
  };
  for (const std::string way : {"false", "true"}) {
    CAPTURE(way);
    const auto filled = [&](const std::string& fill) {
      return facade_of(segmentation, ("{\"evidence\":" + way + "," + fill + "}").c_str());
    };
    const Model never = filled("\"fill\":\"never\""), small = filled("\"fill\":\"small\""),
                larger = filled("\"fill\":\"small\",\"fill_spacings\":1000"),
                outline = filled("\"fill\":\"outline\"");
    const auto [wall_m2, no_data_m2] = wall_and_no_data_m2(never);
    CHECK(no_data_m2 > 0.3);
    // The shadow is far above a dozen spacings.
    CHECK(wall_and_no_data_m2(small) == wall_and_no_data_m2(never));
    // Filled, it is wall, and no area is both; that it was not measured is told where the user asked for it.
    for (const Model* model : {&larger, &outline}) {
      const auto [more_m2, rest_m2] = wall_and_no_data_m2(*model);
      CHECK(rest_m2 == 0);
      CHECK(more_m2 == doctest::Approx(wall_m2 + no_data_m2).epsilon(1e-6));
      CHECK(parts_of(*model, "window").size() == parts_of(never, "window").size());
    }
    CHECK(parts_of(larger, "no_data").empty());
    CHECK(parts_of(outline, "no_data").size() == parts_of(never, "no_data").size());
  }
}

TEST_CASE("facade: without stations a box hides the hole that lies straight behind it") {
  const Model model = facade_of(Hidden{.away_m = 800}.segmentation(false));
  const auto windows = parts_of(model, "window"), shadows = parts_of(model, "no_data");
  REQUIRE(windows.size() == 1);
  CHECK(std::fabs(model.parts[windows[0]].depth_m - 0.2) < 0.002);
  CHECK(parts_of(model, "opening").empty());
  REQUIRE(shadows.size() == 1);
  const Box3 box = box_of_part(model, shadows[0]);
  CHECK(std::fabs(box.min.x - 6.2) < 0.05);
  CHECK(std::fabs(box.max.x - 7) < 0.05);
}

TEST_CASE("facade: without stations a hole that the box before it does not cover counts by shape") {
  // Projected straight onto the wall the box covers little of its own shadow: no evidence, and a rectangle counts.
  const Model model = facade_of(Hidden().segmentation(false));
  CHECK(parts_of(model, "no_data").empty());
  std::vector<const Part*> seen, by_shape;
  for (const char* name : {"window", "opening"})
    for (const size_t p : parts_of(model, name))
      (model.parts[p].evidence == Evidence::kShape ? by_shape : seen).push_back(&model.parts[p]);
  REQUIRE(seen.size() == 1);
  CHECK(std::fabs(seen[0]->depth_m - 0.2) < 0.002);
  REQUIRE(by_shape.size() == 1);
  CHECK(std::isnan(by_shape[0]->depth_m));  // nothing behind it tells one
  CHECK(std::fabs(by_shape[0]->width_m - 0.8 * 8 / 6) < 0.05);
}

TEST_CASE("facade: several facades stand under one building") {
  const Scan scan("{\"name\":\"lycee\"}");
  const Model model = facade_of(scan.segmentation);
  REQUIRE(model.parts.size() > 7);
  CHECK(model.parts[0].part_class == "building");
  CHECK(parts_of(model, "facade").size() == 6);
  CHECK(parts_of(model, "wall").size() == 6);
  CHECK(parts_of(model, "window").size() == 8);
  // The walls stand in a chain: at each of its five corners they share an upright edge.
  size_t shared = 0;
  for (const Edge& edge : find_edges(model)) {
    if (edge.uses != 2) continue;
    const Face &a = model.faces[edge.first_face], &b = model.faces[edge.second_face];
    if (model.parts[a.part].part_class != "wall" || model.parts[b.part].part_class != "wall")
      continue;
    ++shared;
    const Vec3 corners[] = {{14, 0, 0}, {14 + 8 * std::sqrt(0.5), 8 * std::sqrt(0.5), 0}};
    for (const Vec3& c : corners) {
      const Vec3 d = model.vertices[edge.from] - c;
      if (std::hypot(d.x, d.y) < 0.5) CHECK(std::hypot(d.x, d.y) < 0.005);
    }
  }
  MESSAGE("FIGURE facade joints: " << shared << " of 5 corners of walls are shared edges");
  CHECK(shared >= 4);
}

TEST_CASE("facade: the same bits for any number of threads") {
  const Model one = facade_of(town_house().segmentation, "{}", 1);
  CHECK(same_bits(one, facade_of(town_house().segmentation, "{}", 2)));
  CHECK(same_bits(one, facade_of(town_house().segmentation, "{}", 5)));
}

TEST_CASE("facade__by_cell_decomposition__every_window_of_two_walls_is_found") {
  const auto model_with = [](unsigned count) {
    Task::Hooks hooks;
    hooks.threads = count;
    Task task(hooks);
    return model_cell_decomposition(arches().segmentation, FacadeSettings{}, task);
  };
  const Model model = model_with(2);
  CHECK(parts_of(model, "wall").size() == 2);
  CHECK(parts_of(model, "window").size() + parts_of(model, "opening").size() == 8);
  CHECK(same_bits(model, model_with(1)));
  CHECK(same_bits(model, model_with(7)));
}

TEST_CASE("facade: cancel stops it, no segments give no faces") {
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK_THROWS_AS(model_facade(arches().segmentation, FacadeSettings{}, task), Error);
  Segmentation empty = arches().segmentation;
  empty.segments.clear();
  CHECK(facade_of(empty).faces.empty());
}
