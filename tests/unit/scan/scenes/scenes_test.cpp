// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "base/error.h"
#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kScenes[] = {"facade", "street",   "room",          "box",      "surrounds",
                                   "strips", "insa",     "insa_surveyed", "unwanted", "std",
                                   "normal", "patches",  "sills",         "robbery",  "lycee",
                                   "arches", "residence"};

size_t scenes_parts_of_class(const Model& model, const std::string& part_class) {
  return static_cast<size_t>(
      std::count_if(model.parts.begin(), model.parts.end(),
                    [&](const Part& p) { return p.part_class == part_class; }));
}

const Face& only_face(const Model& model, const std::string& part_name) {
  for (const Face& face : model.faces)
    if (model.parts[face.part].name == part_name) return face;
  FAIL("no face of part " << part_name);
  return model.faces.front();
}

}  // namespace

TEST_CASE("scene__faces_are_sound_at_the_ends_of_their_parameters") {
  using Numbers = std::vector<std::pair<const char*, double>>;
  const std::pair<const char*, Numbers> ends[] = {
      {"facade", {{"reveal_m", 0}, {"frame_m", 0.5}, {"cornice_m", 0}, {"ground_m", 0.05}}},
      {"facade", {{"reveal_m", 2}, {"frame_m", 0.5}, {"cornice_m", 3}, {"ground_m", 200}}},
      {"facade",
       {{"width_m", 2}, {"height_m", 3}, {"storeys", 1}, {"bays", 1}, {"ground_m", 0.01}}},
      {"surrounds", {{"glass_m", 0}}},
      {"surrounds", {{"glass_m", 1}}},
      {"sills", {{"gap_m", 0}}},
      {"sills", {{"gap_m", 1}}},
      {"robbery", {{"depth_m", 0.01}}},
      {"robbery", {{"depth_m", 5}}}};
  for (const auto& end : ends) {
    CAPTURE(std::string(end.first));
    const Model model = scene(end.first, end.second);
    for (const Face& face : model.faces) {
      CAPTURE(face.id);
      CHECK(is_sound(model, face));
    }
  }
}

TEST_CASE("scene__faces_rings_and_triangles_tell_the_same_truth") {
  for (const char* name : kScenes) {
    CAPTURE(name);
    const Model model = scene(name, {{"rotation_rad", 0.3}});
    CHECK_NOTHROW(validate(model));
    const auto faces = faces_by_id(model);
    std::map<uint32_t, double> triangle_area;
    for (size_t i = 0; i < model.triangles.size(); ++i) {
      const auto& [a, b, c] = model.triangles[i];
      const Vec3 twice =
          cross(model.vertices[b] - model.vertices[a], model.vertices[c] - model.vertices[a]);
      const auto found = faces.find(model.triangle_faces[i]);
      if (found == faces.end()) continue;  // columns, pipes, spheres have no plane
      triangle_area[found->first] += norm(twice) / 2;
      const Plane& plane = found->second.front()->plane;
      REQUIRE(dot(normalized(twice), plane.normal) > 1 - 1e-12);
      for (const uint32_t v : {a, b, c})
        REQUIRE(std::abs(plane.distance(model.vertices[v])) < 1e-12);
    }
    for (const auto& [id, list] : faces) {
      double area = 0;
      for (const Face* face : list) {
        double rings = 0;
        for (size_t r = 0; r < face->ring_count; ++r) {
          const double ring = signed_area(flat_ring(model, *face, r));
          REQUIRE((r == 0 ? ring > 0 : ring < 0));
          rings += ring;
        }
        REQUIRE(std::abs(rings - face->area_m2) < 1e-9);
        REQUIRE(face->part < model.parts.size());
        area += face->area_m2;
      }
      REQUIRE(std::abs(triangle_area[id] - area) < 1e-9);
    }
    for (size_t p = 0; p < model.parts.size(); ++p)
      CHECK((model.parts[p].parent == kNoParent || model.parts[p].parent < p));
  }
}

TEST_CASE("scene_facade__is_a_wall_of_22_by_10_m_with_doors_windows_cornice_and_ground") {
  const Model model = scene("facade");
  Box3 box;
  for (const Vec3& v : model.vertices) box.add(v);
  CHECK(box.min == Vec3{-4, -6, 0});
  CHECK(box.max.x == 26);
  CHECK(box.max.z == 10);
  CHECK(scenes_parts_of_class(model, "window") == 19);
  CHECK(scenes_parts_of_class(model, "door") == 2);
  const Face& wall = only_face(model, "wall");
  CHECK(wall.ring_count == 1 + 19);  // doors cut the outline
  CHECK(wall.plane.normal.y == doctest::Approx(-1));
  CHECK(wall.plane.offset == doctest::Approx(0));
  CHECK(signed_area(flat_ring(model, wall, 0)) ==
        doctest::Approx(22 * 8.9 - 2 * 1.3 * (0.84 * 9.5 / 3 - 0.6)));
  // Reveals of three depths, and of the doors: 0.25, 0.20, 0.15 and 0.30 m.
  std::set<int> depths;
  for (const Face& face : model.faces)
    if (model.parts[face.part].name == "pane")
      depths.insert(static_cast<int>(std::lround(-1000 * face.plane.offset)));
  CHECK(depths == std::set<int>{150, 200, 250, 300});
  std::set<uint32_t> ids;
  for (const Face& face : model.faces) CHECK(ids.insert(face.id).second);
}

TEST_CASE("scene_facade__has_no_gap_that_a_front_view_sees_through") {
  const Model model = scene("facade", {{"frame_m", 0}});
  const Cloud cloud = scanned(model, quiet_settings(0.004));
  // Rays toward the front of the house all end on it or before it.
  size_t toward = 0;
  for (const Station& station : cloud.stations) {
    const Vec3 eye = station.pose.translation();
    for (uint64_t i = station.first; i < station.first + station.count; ++i) {
      const Vec3 d = cloud.point(i) - eye;
      if (!(d.y > 0)) continue;
      const Vec3 at_wall = eye + d * (-eye.y / d.y);
      if (at_wall.x > 0 && at_wall.x < 22 && at_wall.z > 0 && at_wall.z < 10) ++toward;
    }
  }
  size_t expected = 0;  // the same rays, counted without any model
  for (const Station& station : cloud.stations) {
    const Vec3 eye = station.pose.translation();
    for (int i = 0; i < 1571; ++i)
      for (int j = 0; j < 655; ++j) {
        const double h = -3.14159265358979323846 + 0.004 * i,
                     v = -3.14159265358979323846 / 3 + 0.004 * j;
        const Vec3 d{std::cos(v) * std::sin(h), std::cos(v) * std::cos(h), std::sin(v)};
        if (!(d.y > 0)) continue;
        const Vec3 at_wall = eye + d * (-eye.y / d.y);
        if (at_wall.x > 0 && at_wall.x < 22 && at_wall.z > 0 && at_wall.z < 10) ++expected;
      }
  }
  CHECK(toward == expected);
  CHECK(expected > 90000);
}

TEST_CASE("scene_facade__takes_other_sizes_and_refuses_impossible_ones") {
  const Model big = scene(
      "facade", {{"width_m", 60}, {"height_m", 20}, {"bays", 20}, {"storeys", 6}, {"doors", 3}});
  CHECK(scenes_parts_of_class(big, "window") == 117);
  CHECK(scenes_parts_of_class(big, "door") == 3);
  const Model bare =
      scene("facade", {{"doors", 0}, {"cornice_m", 0}, {"ground_m", 0}, {"reveal_m", 0}});
  CHECK(scenes_parts_of_class(bare, "door") == 0);
  CHECK(scenes_parts_of_class(bare, "reveal") == 0);
  const Model framed = scene("facade", {{"frame_m", 0.03}});
  CHECK(scenes_parts_of_class(framed, "joinery") == 19);
  CHECK_THROWS_AS(scene("facade", {{"bays", 20}}), Error);
  CHECK_THROWS_AS(scene("facade", {{"storeys", 5}}), Error);
  CHECK_THROWS_AS(scene("facade", {{"width_m", 1}}), Error);
  CHECK_THROWS_AS(scene("castle"), Error);
}

TEST_CASE("scene_street__has_the_sizes_of_the_measured_scene_and_its_second_epoch") {
  const Model street = scene("street", {{"rotation_rad", -17 * 3.14159265358979323846 / 180}});
  Box3 box;
  for (const Vec3& v : street.vertices) box.add(v);
  CHECK(box.min.x == doctest::Approx(-0.06).scale(0));
  CHECK(box.max.x == doctest::Approx(60.06));
  CHECK(box.max.z == doctest::Approx(18));
  CHECK(scenes_parts_of_class(street, "window") == 3 * 6 + 4 * 6 * 2 + 4 * 7 + 3 * 7 + 4 * 7 - 0);
  CHECK(scenes_parts_of_class(street, "facade") == 6);
  CHECK(scenes_parts_of_class(street, "change") == 0);
  const Model later = scene("street", {{"epoch", 2}});
  CHECK(scenes_parts_of_class(later, "change") == 5);
}
