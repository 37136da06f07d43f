// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Whole drawings: our own come back, those of others as their entities say; what is wrong is named.
#include <doctest/doctest.h>

#include <cmath>

#include "formats/dxf/dxf.h"
#include "formats/formats.h"
#include "unit/formats/dxf/dxf_pairs.h"
#include "unit/formats/opened_file.h"
#include "unit/formats/house.h"
#include "unit/formats/kept_log.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model model_of(const std::string& bytes, const ReadSettings& settings = {}) {
  const Folder folder;
  spill(folder.file("a.dxf"), bytes);
  Task task;
  return read_model(folder.file("a.dxf"), settings, task);
}

Model written_and_read(const Model& model, DxfVersion version) {
  const Folder folder;
  Task task;
  WriteSettings settings;
  settings.dxf_version = version;
  write_model(model, folder.file("a.dxf"), settings, task);
  return read_model(folder.file("a.dxf"), {}, task);
}

}  // namespace

TEST_CASE("dxf_reader__our_own_drawings_come_back_with_faces_holes_arcs_and_parts") {
  const Model house = House().model();
  for (const DxfVersion version : {DxfVersion::kR2000, DxfVersion::kR12}) {
    const Model back = written_and_read(house, version);
    REQUIRE(back.faces.size() == house.faces.size());
    for (size_t f = 0; f < house.faces.size(); ++f) {
      CHECK(back.faces[f].id == house.faces[f].id);
      CHECK(back.faces[f].ring_count == house.faces[f].ring_count);
      CHECK(back.faces[f].area_m2 == doctest::Approx(house.faces[f].area_m2).epsilon(1e-7));
      CHECK(norm(back.faces[f].plane.normal - house.faces[f].plane.normal) < 1e-6);
      CHECK(back.parts[back.faces[f].part].part_class ==
            house.parts[house.faces[f].part].part_class);
    }
    const auto has = [&](const Part& wanted) {
      return std::any_of(back.parts.begin(), back.parts.end(), [&](const Part& p) {
        return p.name == wanted.name && p.part_class == wanted.part_class &&
               p.evidence == wanted.evidence;
      });
    };
    CHECK(has(house.parts[3]));
    if (version == DxfVersion::kR2000) CHECK(has(house.parts[2]));  // release 12 has no accents
  }
}

TEST_CASE("dxf_reader__units_of_the_header_become_metres_unless_the_user_says_otherwise") {
  const std::string entities = section("ENTITIES", square(0, 0, 2000)), end = pairs("0 EOF");
  const auto area = [&](const std::string& insunits, FileUnit unit) {
    ReadSettings settings;
    settings.unit = unit;
    const std::string header =
        insunits.empty() ? "" : section("HEADER", pairs("9 $INSUNITS 70 " + insunits));
    return model_of(header + entities + end, settings).faces[0].area_m2;
  };
  CHECK(area("4", FileUnit::kAuto) == doctest::Approx(4));
  CHECK(area("6", FileUnit::kAuto) == doctest::Approx(4e6));
  CHECK(area("", FileUnit::kAuto) == doctest::Approx(4e6));
  CHECK(area("6", FileUnit::kMillimetres) == doctest::Approx(4));
  CHECK(area("2", FileUnit::kAuto) == doctest::Approx(4e6 * 0.3048 * 0.3048));
}

TEST_CASE("dxf_reader__blocks_stand_where_they_are_inserted_and_layouts_are_none") {
  const std::string blocks = pairs("0 BLOCK 8 0 2 *Model_Space 10 0 20 0 30 0 0 ENDBLK 8 0") +
                             pairs("0 BLOCK 8 0 2 Pane 10 0 20 0 30 0") + square(0, 0, 1, "0") +
                             pairs("0 ENDBLK 8 0");
  const Model model =
      model_of(section("BLOCKS", blocks) +
               section("ENTITIES",
                       pairs("0 INSERT 8 WINDOW 2 pane 10 5 20 0 30 0 0 INSERT 8 DOOR 2 PANE 10 9 "
                             "20 0 30 0 41 2 42 2")) +
               pairs("0 EOF"));
  REQUIRE(model.faces.size() == 2);
  CHECK(model.parts[model.faces[0].part].part_class == "window");
  CHECK(model.faces[1].area_m2 == doctest::Approx(4));
}

TEST_CASE("dxf_reader__names_what_it_left_out_and_what_is_wrong") {
  const std::string end = pairs("0 EOF");
  const auto refusal = [](const std::string& bytes, Status status) {
    const Failure failure = failure_of([&] { model_of(bytes); });
    CHECK(failure.status == status);
    return failure.text;
  };
  CHECK(has_text(
      refusal(section("ENTITIES", pairs("0 LINE 8 0 10 0 20 0 11 1 21 1 0 HATCH 8 0")) + end,
              Status::kFormat),
      "no closed polyline, 3DFACE or mesh; there are: 1 HATCH, 1 LINE"));
  CHECK(has_text(refusal(section("HEADER", "") + end, Status::kFormat),
                 "there is no section ENTITIES"));
  CHECK(has_text(refusal(pairs("0 SECTION 2 ENTITIES"), Status::kFormat),
                 "the file ends before ENDSEC"));
  CHECK(has_text(refusal("AutoCAD Binary DXF\r\n\x1a", Status::kUnsupported), "save it as text"));
  CHECK(has_text(refusal("AC1032 and more", Status::kUnsupported), "a DWG drawing"));
  const Folder folder;
  spill(folder.file("a.dxf"), section("ENTITIES", square(0, 0, 1) + pairs("0 SPLINE 8 0")) + end);
  KeptLog log;
  CHECK(read_model(folder.file("a.dxf"), {}, log.task()).faces.size() == 1);
  REQUIRE(log.warnings().size() == 1);
  CHECK(has_text(log.warnings()[0], "left out, no surfaces: 1 SPLINE"));
}
