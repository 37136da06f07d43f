// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The entities of a file by name; ifcopenshell reads the same house in tests/formats.
#include <doctest/doctest.h>

#include <regex>
#include <set>
#include <sstream>

#include "formats/ifc/ifc.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string written(const Model& model, double thickness_m = 0) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.ifc_wall_thickness_m = thickness_m;
  write_ifc(model, folder.file("a.ifc"), settings, task);
  return slurp(folder.file("a.ifc"));
}

size_t count_of(const std::string& text, const std::string& what) {
  size_t count = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("ifc_writer__walls_are_voided_by_openings_that_windows_and_doors_fill") {
  const std::string text = written(House().model());
  CHECK(count_of(text, "=IFCWALL(") == 1);
  CHECK(count_of(text, "=IFCWINDOW(") == 2);
  CHECK(count_of(text, "=IFCDOOR(") == 1);
  CHECK(count_of(text, "=IFCOPENINGELEMENT(") == 4);  // and the round one, which nothing fills
  CHECK(count_of(text, "=IFCRELVOIDSELEMENT(") == 4);
  CHECK(count_of(text, "=IFCRELFILLSELEMENT(") == 3);
  CHECK(count_of(text, "=IFCROOF(") == 1);
  CHECK(count_of(text, "=IFCGEOGRAPHICELEMENT(") == 1);
  CHECK(count_of(text, "IFCPROPERTYSINGLEVALUE('Evidence',$,IFCLABEL('revealed'),$)") == 1);
  CHECK(count_of(text, "'wall \\X2\\00E9\\X0\\t\\X2\\00E9\\X0\\'") >= 1);
}

TEST_CASE("ifc_writer__the_map_conversion_has_the_whole_metres_and_the_code") {
  const std::string text = written(House().model());
  CHECK(count_of(text, "=IFCPROJECTEDCRS('EPSG:2154'") == 1);
  CHECK(std::regex_search(text, std::regex("=IFCMAPCONVERSION\\(#\\d+,#\\d+,652\\d\\d\\d\\.,"
                                           "68610\\d\\d\\.,142\\.,1\\.,0\\.,1\\.\\)")));
  Model local = House().model();
  local.crs = "";
  const std::string other = written(local);
  CHECK(count_of(other, "IFCMAPCONVERSION") == 0);
  CHECK(std::regex_search(
      other, std::regex("=IFCCARTESIANPOINT\\(\\(652\\d\\d\\d\\.,68610\\d\\d\\.,142\\.\\)\\)")));
}

TEST_CASE("ifc_writer__entities_name_entities_before_them_and_no_identifier_comes_twice") {
  for (const double thickness_m : {0.0, 0.3}) {
    const std::string text = written(House().model(), thickness_m);
    std::set<std::string> seen;
    size_t number = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line[0] != '#') continue;
      CHECK(line.starts_with("#" + std::to_string(++number) + "=IFC"));
      const std::regex reference("#(\\d+)");
      for (std::sregex_iterator at(line.begin() + 1, line.end(), reference), end; at != end; ++at)
        CHECK(std::stoul((*at)[1]) < number);
      std::smatch guid;
      if (std::regex_search(line, guid, std::regex("\\('([0-9A-Za-z_$]{22})',\\$")))
        CHECK(seen.insert(guid[1]).second);
    }
    CHECK(seen.size() > 20);
  }
}

TEST_CASE("ifc_writer__equal_models_give_equal_files_and_an_empty_one_is_a_project") {
  CHECK(written(House().model()) == written(House().model()));
  const std::string text = written({});
  CHECK(count_of(text, "=IFCSITE(") == 1);
  CHECK(count_of(text, "=IFCBUILDING(") == 0);
}

TEST_CASE("ifc_writer__with_a_thickness_walls_are_closed_and_openings_cut_them") {
  const std::string flat = written(House().model()), solid = written(House().model(), 0.3);
  CHECK(count_of(flat, "'Reference','Tessellation'") == 4);
  CHECK(count_of(solid, "'Reference','Tessellation'") == 0);
  CHECK(count_of(flat, ",.T.,(") == 1);  // the sill
  CHECK(count_of(solid, ",.T.,(") == 6);
}

TEST_CASE("ifc_writer__triangles_of_no_part_are_one_mesh") {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  model.triangles = {{0, 1, 2}, {1, 3, 2}};
  model.triangle_faces = {5, 5};
  const std::string text = written(model);
  CHECK(count_of(text, "=IFCTRIANGULATEDFACESET(") == 1);
  CHECK(count_of(text, "=IFCBUILDINGELEMENTPROXY(") == 1);
}
