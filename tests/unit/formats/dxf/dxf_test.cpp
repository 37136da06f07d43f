// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Group {
  int code;
  std::string value;
  double number() const {
    double out = NAN;
    std::from_chars(value.data(), value.data() + value.size(), out);
    return out;
  }
};
using Groups = std::vector<Group>;

/// The groups of a DXF file: a line for the code, a line for the value.
Groups groups_of(const std::string& text) {
  Groups out;
  for (size_t at = 0; at < text.size();) {
    const size_t code_end = text.find('\n', at), value_end = text.find('\n', code_end + 1);
    REQUIRE(value_end != std::string::npos);
    out.push_back(
        {std::atoi(text.c_str() + at), text.substr(code_end + 1, value_end - code_end - 1)});
    at = value_end + 1;
  }
  return out;
}

/// Items of a section: from each group 0 to the next.
std::vector<Groups> items_of(const Groups& all, const std::string& section) {
  std::vector<Groups> out;
  bool inside = false;
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i].code == 0 && all[i].value == "SECTION") {
      inside = all[i + 1].value == section;
      ++i;
    } else if (all[i].code == 0 && all[i].value == "ENDSEC") {
      inside = false;
    } else if (inside) {
      if (all[i].code == 0) out.emplace_back();
      if (!out.empty()) out.back().push_back(all[i]);
    }
  }
  return out;
}

const Group* find(const Groups& item, int code) {
  for (const Group& group : item)
    if (group.code == code) return &group;
  return nullptr;
}
double number(const Groups& item, int code) {
  const Group* group = find(item, code);
  return group != nullptr ? group->number() : NAN;
}

Groups written(const Model& model, DxfVersion version, DxfView view = DxfView::kWorld) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.dxf_version = version;
  settings.dxf_view = view;
  write_model(model, folder.file("a.dxf"), settings, task);
  return groups_of(slurp(folder.file("a.dxf")));
}

/// A vertex of an entity in space: the arbitrary axis algorithm as the DXF Reference tells it.
Vec3 in_space(const Vec3& p, const Vec3& normal) {
  const bool near_z = std::fabs(normal.x) < 1.0 / 64 && std::fabs(normal.y) < 1.0 / 64;
  const Vec3 x = normalized(cross(near_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, normal));
  return p.x * x + p.y * normalized(cross(normal, x)) + p.z * normal;
}

struct Corner {
  Vec3 p;
  double bulge = 0;
};
struct Line {
  std::string layer;
  std::vector<Corner> corners;
  std::vector<std::string> data;
};

/// All closed polylines, whichever entity they are.
std::vector<Line> lines_of(const Groups& all) {
  std::vector<Line> out;
  Vec3 normal;
  bool planar = false;
  for (const Groups& item : items_of(all, "ENTITIES")) {
    const std::string& kind = item[0].value;
    if (kind == "LWPOLYLINE" || kind == "POLYLINE") {
      CHECK((static_cast<int>(number(item, 70)) & 1) == 1);
      planar = find(item, 210) != nullptr;
      if (planar) normal = {number(item, 210), number(item, 220), number(item, 230)};
      out.push_back({find(item, 8)->value, {}, {}});
      for (const Group& group : item)
        if (group.code == 1000) out.back().data.push_back(group.value);
    }
    if (kind == "LWPOLYLINE") {
      for (const Group& group : item) {
        if (group.code == 10) out.back().corners.push_back({{group.number(), 0, number(item, 38)}});
        if (group.code == 20) out.back().corners.back().p.y = group.number();
        if (group.code == 42) out.back().corners.back().bulge = group.number();
      }
      CHECK(static_cast<double>(out.back().corners.size()) == number(item, 90));
      for (Corner& corner : out.back().corners) corner.p = in_space(corner.p, normal);
    }
    if (kind == "VERTEX") {
      const Vec3 p{number(item, 10), number(item, 20), number(item, 30)};
      const double bulge = find(item, 42) != nullptr ? number(item, 42) : 0;
      out.back().corners.push_back({planar ? in_space(p, normal) : p, bulge});
    }
  }
  return out;
}

// Rings of the model in their order, beside the lines of the file; the largest distance of a corner.
double worst_corner(const Model& model, const std::vector<Line>& lines) {
  REQUIRE(lines.size() == model.rings.size());
  double worst = 0;
  for (size_t r = 0; r < lines.size(); ++r) {
    const Ring& ring = model.rings[r];
    REQUIRE(lines[r].corners.size() == ring.count);
    for (uint64_t c = 0; c < ring.count; ++c) {
      const Vec3 &a = model.vertices[model.corners[ring.first + c]],
                 &b = model.vertices[model.corners[ring.first + (c + 1) % ring.count]];
      worst = std::max(worst, norm(lines[r].corners[c].p - a));
      const double bulge = 2 * model.sagitta(ring.first + c) / norm(b - a);
      CHECK(lines[r].corners[c].bulge == doctest::Approx(bulge).epsilon(1e-9));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("dxf__faces_stand_where_they_are_with_their_arcs_in_both_versions") {
  const Model model = House().model();
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::kR2000}) {
    const double worst = worst_corner(model, lines_of(written(model, version)));
    MESSAGE("FIGURE dxf ", version == DxfVersion::kR12 ? "r12" : "r2000",
            ": corners on the national grid come back within ", worst, " m");
    CHECK(worst < 5e-9);
  }
}

TEST_CASE("dxf__a_layer_a_class_copies_and_missing_data_apart") {
  const Model model = House().model();
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::kR2000}) {
    const Groups all = written(model, version);
    std::map<std::string, int> count, colour;
    for (const Line& line : lines_of(all)) ++count[line.layer];
    CHECK(count["WALL"] == 1);
    CHECK(count["WINDOW"] == 1);
    CHECK(count["WINDOW-COPIED"] == 1);
    CHECK(count["DOOR"] == 1);
    CHECK(count["OPENING"] == 1);
    CHECK(count["NO_DATA"] == 1);
    CHECK(count["SILL"] == 6);
    for (const Groups& item : items_of(all, "TABLES"))
      if (item[0].value == "LAYER")
        colour[find(item, 2)->value] = static_cast<int>(number(item, 62));
    for (const auto& [layer, n] : count) CHECK(colour.contains(layer));
    CHECK(colour["WINDOW"] != colour["DOOR"]);
  }
}

TEST_CASE("dxf__handles_are_unique_and_every_owner_and_pointer_exists") {
  Model model = House().model();
  model.vertices[20].z += 0.5;  // a ring out of its plane becomes a polyline in space
  model.triangles.push_back({0, 1, 2});
  model.triangle_faces.push_back(999);
  const Groups all = written(model, DxfVersion::kR2000);
  std::set<std::string> handles;
  uint64_t largest = 0, seed = 0;
  for (const char* section : {"TABLES", "BLOCKS", "ENTITIES", "OBJECTS"})
    for (const Groups& item : items_of(all, section)) {
      if (item[0].value == "ENDTAB") continue;
      const Group* handle = find(item, item[0].value == "DIMSTYLE" ? 105 : 5);
      REQUIRE_MESSAGE(handle != nullptr, item[0].value);
      CHECK_MESSAGE(handles.insert(handle->value).second, item[0].value, " ", handle->value);
      largest = std::max<uint64_t>(largest, std::stoull(handle->value, nullptr, 16));
    }
  for (size_t i = 0; i < all.size(); ++i) {
    const Group& group = all[i];
    if (group.code == 330 || group.code == 340 || group.code == 350 || group.code == 390)
      CHECK_MESSAGE((group.value == "0" || handles.contains(group.value)), group.code, " ",
                    group.value);
    if (group.value == "$HANDSEED") seed = std::stoull(all[i + 1].value, nullptr, 16);
  }
  CHECK(seed > largest);
  const Groups old = written(model, DxfVersion::kR12);
  for (const Group& group : old) CHECK((group.code != 5 && group.code != 330 && group.code != 100));
}

TEST_CASE("dxf__header_tells_unit_and_extent") {
  const Model model = House().model();
  Box3 box;
  for (const Vec3& p : model.vertices) box.add(p);
  const Groups all = written(model, DxfVersion::kR2000);
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i].value == "$ACADVER") CHECK(all[i + 1].value == "AC1015");
    if (all[i].value == "$INSUNITS") CHECK(all[i + 1].number() == 6);
    if (all[i].value == "$EXTMIN") CHECK(all[i + 1].number() == box.min.x);
    if (all[i].value == "$EXTMAX") CHECK(all[i + 3].number() == box.max.z);
  }
  CHECK(written(model, DxfVersion::kR12)[3].value == "AC1009");
  CHECK(all.back().value == "EOF");
}

TEST_CASE("dxf__elevation_is_the_facade_flattened_one_to_one") {
  const std::vector<Line> lines =
      lines_of(written(House().model(), DxfVersion::kR2000, DxfView::kElevation));
  double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
  size_t arcs = 0;
  for (const Line& line : lines) {
    CHECK(line.layer != "GROUND");
    for (const Corner& corner : line.corners) {
      CHECK(corner.p.z == 0);
      if (line.layer == "WALL") {
        left = std::min(left, corner.p.x);
        right = std::max(right, corner.p.x);
        low = std::min(low, corner.p.y);
        high = std::max(high, corner.p.y);
      }
      arcs += corner.bulge != 0 ? 1 : 0;
    }
    if (line.layer == "WINDOW") {
      CHECK(line.corners[0].p.x == doctest::Approx(1).epsilon(1e-8));
      CHECK(line.corners[1].p.y == doctest::Approx(142.5 + 2.5));
      CHECK(line.corners[1].bulge == doctest::Approx(-1));
    }
  }
  CHECK(left == doctest::Approx(0));
  CHECK(right - left == doctest::Approx(12).epsilon(1e-9));
  CHECK(low == doctest::Approx(142.5));
  CHECK(high == doctest::Approx(150.5));
  CHECK(arcs == 5);  // two heads, the pane behind one, and the round window's two halves
  const auto sills =
      std::ranges::count_if(lines, [](const Line& line) { return line.layer == "SILL"; });
  CHECK(sills == 1);  // of the solid the side that is seen
}

TEST_CASE("dxf__a_facade_seen_from_behind_and_an_inclined_arc_are_drawn_rightly") {
  Model model;
  model.parts.push_back({"wall", "wall", kNoParent});
  Face face;
  face.plane.normal = normalized({0, -1, 0});
  face.area_m2 = 100;
  model.add_face(face, {{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}}});
  model.sagittas.assign(4, 0);
  face.area_m2 = 1;
  face.plane.normal = {0, 1, 0};  // looks the other way: its arcs turn round
  model.add_face(face, {{{2, 1, 2}, {1, 1, 2}, {1, 1, 4}, {2, 1, 4}}});
  model.sagittas[6] = 0.5;
  face.plane.normal = normalized({0, -1, 1});
  model.add_face(face, {{{4, 0, 0}, {6, 0, 0}, {5, 1, 1}}});
  model.sagittas[8] = 1;
  const std::vector<Line> lines = lines_of(written(model, DxfVersion::kR2000, DxfView::kElevation));
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].corners[2].bulge == doctest::Approx(-1));
  CHECK(lines[1].corners.size() > 10);
  for (const Corner& corner : lines[1].corners) CHECK(corner.bulge == 0);
  CHECK(lines[2].corners.size() == 4);  // what lies in front comes last
}

TEST_CASE("dxf__hostile_names_never_leave_their_group") {
  Model model = House().model();
  model.parts[2].name = "a\n0\nEOF\r\x01\xff" + std::string(900, 'x');
  model.parts[2].part_class = "wall <>/\\\":;?*|=`\n 0\n\xF0\x9F\x98\x80" + std::string(90, 'y');
  model.parts[5].part_class = "";
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::kR2000}) {
    const Groups all = written(model, version);
    size_t ends = 0;
    for (const Group& group : all) {
      ends += group.code == 0 && group.value == "EOF" ? 1 : 0;
      CHECK(group.value.size() <= 255);
      for (const char c : group.value) CHECK((c >= 0x20 && c < 0x7f));
      if (group.code == 8)
        CHECK(group.value.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
              std::string::npos);
    }
    CHECK(ends == 1);
    CHECK(lines_of(all).size() == model.rings.size());
  }
}

TEST_CASE("dxf__an_empty_model_is_a_drawing_all_the_same") {
  for (const DxfVersion version : {DxfVersion::kR12, DxfVersion::kR2000})
    for (const DxfView view : {DxfView::kWorld, DxfView::kElevation}) {
      const Groups all = written(Model{}, version, view);
      CHECK(lines_of(all).empty());
      CHECK(all.back().value == "EOF");
    }
}
