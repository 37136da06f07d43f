// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Elevations against facades that were set up at any angle from a drawing of known measures.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formats/dxf/drawing.h"
#include "unit/formats/fixtures.h"

using namespace jalon;

namespace {

constexpr double kMapRounding_m = 1e-8;  // a few roundings of coordinates below 2^23
constexpr double kChordError_m = 0.001;

/// A facade that is turned about the vertical: s along it, z up, d in front of it.
class Street {
 public:
  explicit Street(double angle) : cos_(std::cos(angle)), sin_(std::sin(angle)) {}
  Model model = {};

  Vec3 at(double s, double z, double d = 0) const {
    return Vec3{652000, 6861000, 80} + Vec3{s * cos_ + d * sin_, s * sin_ - d * cos_, z};
  }
  uint32_t add_part(const char* part_class, uint64_t parent) {
    Part part;
    part.name = part.part_class = part_class;
    part.parent = parent;
    model.parts.push_back(part);
    return static_cast<uint32_t>(model.parts.size() - 1);
  }
  /// Rectangles (s, z, width, height) in front of the facade by d: an outline and its holes.
  void add_upright(uint32_t part, double d, const std::vector<std::array<double, 4>>& boxes) {
    std::vector<std::vector<Vec3>> rings;
    for (const auto& [s, z, w, h] : boxes) {
      rings.push_back({at(s, z, d), at(s + w, z, d), at(s + w, z + h, d), at(s, z + h, d)});
      if (rings.size() > 1) std::swap(rings.back()[1], rings.back()[3]);
    }
    add(part, rings, boxes[0][2] * boxes[0][3]);
  }
  void add(uint32_t part, const std::vector<std::vector<Vec3>>& rings, double area_m2) {
    Face face;
    face.part = part;
    face.id = static_cast<uint32_t>(model.faces.size());
    face.area_m2 = area_m2;
    face.plane.normal = normalized(cross(rings[0][1] - rings[0][0], rings[0][2] - rings[0][0]));
    model.add_face(face, rings);
  }
  dxf::Drawing drawn() const {
    Task task;
    return dxf::draw_elevation(model, kChordError_m, task);
  }

 private:
  double cos_, sin_;
};

void check_box(const dxf::Polyline& line, double s, double z, double w, double h) {
  Box3 box;
  for (const Vec3& p : line.corners) box.add(p);
  CHECK(norm(box.min - Vec3{s, z, 0}) <= kMapRounding_m);
  CHECK(norm(box.max - Vec3{s + w, z + h, 0}) <= kMapRounding_m);
}

std::vector<uint32_t> order_of(const dxf::Drawing& drawing) {
  std::vector<uint32_t> out;
  for (const dxf::Polyline& line : drawing.polylines) out.push_back(line.face_id);
  return out;
}

}  // namespace

TEST_CASE("dxf_elevation__is_the_same_whichever_way_the_facade_looks") {
  for (double angle = 0; angle < 6.3; angle += 0.45) {
    Street street(angle);
    const uint32_t wall = street.add_part("wall", kNoParent);
    street.add_upright(wall, 0, {{0, 0, 9, 5}, {2, 1, 1.5, 2}});
    const dxf::Drawing drawing = street.drawn();
    REQUIRE(drawing.polylines.size() == 2);
    const size_t outline = drawing.polylines[0].part == wall ? 0 : 1;
    check_box(drawing.polylines[outline], 0, 80, 9, 5);
    check_box(drawing.polylines[1 - outline], 2, 81, 1.5, 2);  // not mirrored
    const std::vector<Vec3>& corners = drawing.polylines[outline].corners;
    CHECK(norm(corners[0] - Vec3{0, 80, 0}) <= kMapRounding_m);
    CHECK(norm(corners[1] - Vec3{9, 80, 0}) <= kMapRounding_m);
    for (const dxf::Polyline& line : drawing.polylines) CHECK(line.normal == Vec3{0, 0, 1});
    CHECK(norm(drawing.box.max - Vec3{9, 85, 0}) <= kMapRounding_m);
  }
}

TEST_CASE("dxf_elevation__rounding_shuffles_nothing_that_lies_in_one_plane") {
  // Depths at, and halfway between, multiples of any round step.
  constexpr double kDepths_m[] = {0, -0.0025, 0.005, 0.0125, 0.1};
  for (int turn = 0; turn < 140; ++turn) {
    CAPTURE(turn);
    Street street(0.045 * turn);
    const uint32_t wall = street.add_part("wall", kNoParent);
    for (const double d : kDepths_m)
      street.add_upright(wall, d, {{0, 0, 9, 5}, {2, 1, 1.5, 2}, {5, 1, 1.5, 2}});
    const dxf::Drawing drawing = street.drawn();
    REQUIRE(drawing.polylines.size() == 3 * std::size(kDepths_m));
    for (size_t i = 0; i < drawing.polylines.size(); i += 3) {
      const uint32_t face = drawing.polylines[i].face_id;
      CHECK(drawing.polylines[i].part == wall);  // the outline before its holes
      check_box(drawing.polylines[i], 0, 80, 9, 5);
      check_box(drawing.polylines[i + 1], 2, 81, 1.5, 2);
      check_box(drawing.polylines[i + 2], 5, 81, 1.5, 2);
      CHECK(drawing.polylines[i + 1].face_id == face);
      CHECK(drawing.polylines[i + 2].face_id == face);
    }
  }
  // The front wall has no edge of a step near it: what is nearer than half a step keeps its order.
  for (const double d : {-0.002, 0.002}) {
    Street street(2.25);
    const uint32_t wall = street.add_part("wall", kNoParent);
    street.add_upright(wall, 0, {{0, 0, 9, 5}});
    street.add_upright(wall, d, {{0, 0, 1, 1}});
    CHECK(order_of(street.drawn()) == std::vector<uint32_t>{0, 1});
  }
}

TEST_CASE("dxf_elevation__facades_stand_side_by_side_with_what_belongs_to_them") {
  Street street(0.4);
  const uint32_t house = street.add_part("building", kNoParent);
  const uint32_t left = street.add_part("facade", house), right = street.add_part("facade", house);
  const uint32_t wall = street.add_part("wall", left), door = street.add_part("door", wall),
                 ground = street.add_part("ground", house);
  street.add_upright(right, 20, {{100, 0, 4, 6}});
  street.add_upright(wall, 0, {{10, 0, 9, 5}});
  street.add_upright(door, -0.2, {{12, 0, 1, 2}});
  street.add(ground, {{street.at(0, 0, 0), street.at(1, 0, 0), street.at(0, 0, -1)}}, 0.5);
  const dxf::Drawing both = street.drawn();
  CHECK(order_of(both) ==
        std::vector<uint32_t>{2, 1, 0});  // a door behind its wall, then the other facade
  REQUIRE(both.polylines.size() == 3);
  check_box(both.polylines[1], 0, 80, 9, 5);
  check_box(both.polylines[0], 2, 80, 1, 2);
  check_box(both.polylines[2], 9 + 2, 80, 4, 6);  // a gap of 2 m
  CHECK(norm(both.box.min - Vec3{0, 80, 0}) <= kMapRounding_m);
  CHECK(norm(both.box.max - Vec3{15, 86, 0}) <= kMapRounding_m);
  // Of the only facade is also what stands in none.
  street.model.parts[right].part_class = "roof";
  const dxf::Drawing one = street.drawn();
  REQUIRE(one.polylines.size() == 3);
  check_box(one.polylines[2], 90, 80, 4, 6);
}

TEST_CASE("dxf_elevation__leaves_out_what_is_seen_edge_on_and_the_backs_of_solids") {
  Street street(2.1);
  const uint32_t wall = street.add_part("wall", kNoParent), sill = street.add_part("sill", wall);
  street.add_upright(wall, 0, {{0, 0, 9, 5}});
  for (const double d : {0.3, -0.3, 0.0525, 0.0525}) street.add_upright(sill, d, {{1, 1, 2, 1}});
  const auto from_behind = [&](double d) {
    street.add(sill,
               {{street.at(1, 1, d), street.at(1, 2, d), street.at(3, 2, d), street.at(3, 1, d)}},
               2);
  };
  from_behind(0.1);
  from_behind(0.2);
  const auto aslant = [&](double degrees) {  // a strip that turns away from the view
    const double t = degrees * std::numbers::pi / 180, c = std::cos(t), s = std::sin(t);
    street.add(sill,
               {{street.at(5, 1, 1), street.at(5 + c, 1, 1 + s), street.at(5 + c, 2, 1 + s),
                 street.at(5, 2, 1)}},
               1);
  };
  aslant(80);
  aslant(88);
  aslant(90);
  street.model.solids.push_back({sill, 5, 1});
  // By depth: -0.3, the wall, two in their order, 0.2 from behind but no solid, 0.3, 1.5.
  CHECK(order_of(street.drawn()) == std::vector<uint32_t>{2, 0, 3, 4, 6, 1, 7});
  Street flat(0);
  flat.add(flat.add_part("ground", kNoParent),
           {{flat.at(0, 0, 0), flat.at(1, 0, 0), flat.at(0, 0, -1)}}, 0.5);
  CHECK(flat.drawn().polylines.empty());
  CHECK(flat.drawn().box.empty());
}

TEST_CASE("dxf_elevation__an_arc_in_an_inclined_face_becomes_chords_of_its_ellipse") {
  constexpr double kRadius_m = 1.5;
  for (const double degrees : {20.0, 45.0, 70.0}) {
    const double tilt = degrees * std::numbers::pi / 180;
    Street street(1.2);
    const uint32_t wall = street.add_part("wall", kNoParent);
    street.add_upright(wall, 0, {{0, 0, 20, 10}});
    // Half a disc that leans back from its base on the front of the wall.
    const Vec3 a = street.at(8.5, 5), b = street.at(11.5, 5),
               up = street.at(10, 5 + std::cos(tilt), -std::sin(tilt));
    Face disc;
    disc.part = wall;
    disc.id = 1;
    disc.area_m2 = 3.5;
    disc.plane.normal = normalized(cross(b - a, up - a));
    street.model.add_face(disc, {{a, b}});
    street.model.sagittas = {0, 0, 0, 0, 0, kRadius_m};  // back from b by the arc
    const dxf::Drawing drawing = street.drawn();
    REQUIRE(drawing.polylines.size() == 2);
    const dxf::Polyline& arc = drawing.polylines[drawing.polylines[0].face_id == 1 ? 0 : 1];
    CHECK(arc.corners.size() > 10);
    double highest = 0, lowest = INFINITY;
    for (size_t i = 0; i < arc.corners.size(); ++i) {
      CHECK(arc.sagittas_m[i] == 0);
      // Back in the plane of the disc, from its centre.
      const auto on_disc = [&](const Vec3& p) {
        return Vec3{p.x - 10, (p.y - 85) / std::cos(tilt), 0};
      };
      const Vec3 p = on_disc(arc.corners[i]),
                 q = on_disc(arc.corners[(i + 1) % arc.corners.size()]);
      CHECK(norm(p) == doctest::Approx(kRadius_m).epsilon(1e-7));
      highest = std::max(highest, p.y);
      lowest = std::min(lowest, p.y);
      if (i > 0) CHECK(norm(0.5 * (p + q)) >= kRadius_m - kChordError_m - kMapRounding_m);
    }
    CHECK(lowest >= -1e-7);
    CHECK(highest >= kRadius_m - kChordError_m);
  }
}
