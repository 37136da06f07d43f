// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/file.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "compare/m3c2/m3c2.h"

using namespace jalon;

namespace {

ParamSet params() { return {"comparer m3c2", m3c2_rows()}; }

/// Status of reading the text; the parameters must be as before then.
Status refused(const std::string& text) {
  ParamSet p = params();
  const std::string before = p.to_json();
  try {
    read_cloudcompare_m3c2(text, p);
  } catch (const Error& error) {
    CHECK(p.to_json() == before);
    return error.status();
  }
  return Status::kOk;
}

}  // namespace

TEST_CASE("m3c2_file__diameters_become_radii_and_the_rest_keeps_its_meaning") {
  ParamSet p = params();
  const auto warnings = read_cloudcompare_m3c2(
      "[General]\r\nM3C2VER=1\r\nNormalScale=0.5\r\nNormalMode=0\r\nNormalUseCorePoints="
      "true\r\nNormalPreferedOri=1\r\n"
      "SearchScale=0.3\r\nSearchDepth=1.5\r\nSubsampleRadius=0.07\r\nSubsampleEnabled=true\r\n"
      "RegistrationError=0.004\r\nRegistrationErrorEnabled=true\r\nUseMedian="
      "false\r\nUseMinPoints4Stat=true\r\n"
      "MinPoints4Stat=12\r\nUseSinglePass4Depth=false\r\nPositiveSearchOnly="
      "false\r\nUsePrecisionMaps=false\r\n"
      "MaxThreadCount=8\r\nProjDestIndex=1\r\nNormalMinScale=0.2\r\nNormalStep=0."
      "1\r\nNormalMaxScale=0.4\r\n",
      p);
  CHECK(warnings.empty());
  CHECK(p.number("normal_radius_m") == 0.25);
  CHECK(p.numbers("normal_radii_m").empty());
  CHECK(p.text("normals") == "scale");
  CHECK(p.text("normals_from") == "core");
  CHECK(p.text("orientation") == "direction");
  CHECK(p.numbers("orientation_direction") == std::vector<double>{-1, 0, 0});
  CHECK(p.number("cylinder_radius_m") == 0.15);
  CHECK(p.number("max_depth_m") == 1.5);
  CHECK(p.number("core_spacing_m") == 0.07);
  CHECK(p.number("registration_error_m") == 0.004);
  CHECK(p.text("position") == "mean");
  CHECK(p.text("surfaces") == "all");
  CHECK(p.integer("min_points") == 12);
}

TEST_CASE("m3c2_file__what_is_switched_off_is_not_taken") {
  ParamSet p = params();
  p.set_number("core_spacing_m", 3);
  read_cloudcompare_m3c2(
      "M3C2VER=1\nSubsampleRadius=0.07\nSubsampleEnabled=false\nRegistrationError=0.004\n"
      "RegistrationErrorEnabled=false\nUseMinPoints4Stat=false\nMinPoints4Stat=12\nUseMedian=true",
      p);
  CHECK(p.number("core_spacing_m") == 0);
  CHECK(p.number("registration_error_m") == 0);
  CHECK(p.integer("min_points") == 5);
  CHECK(p.text("position") == "median");
  CHECK(p.number("normal_radius_m") == 0.25);  // absent: as before
}

TEST_CASE("m3c2_file__modes_of_normals") {
  const auto with = [](const char* lines) {
    ParamSet p = params();
    read_cloudcompare_m3c2(std::string("M3C2VER=1\n") + lines, p);
    return p;
  };
  CHECK(with("NormalMode=1").text("normals") == "given");
  CHECK(with("NormalMode=3").text("normals") == "vertical");
  CHECK(with("NormalMode=4").text("normals") == "horizontal");
  CHECK(with("NormalMode=5").text("normals") == "given");
  CHECK(with("NormalPreferedOri=4").numbers("orientation_direction") ==
        std::vector<double>{0, 0, 1});
  CHECK(with("NormalPreferedOri=11").text("orientation") == "station");
  const ParamSet several =
      with("NormalMode=2\nNormalMinScale=0.2\nNormalStep=0.1\nNormalMaxScale=0.5");
  const auto& radii = several.numbers("normal_radii_m");
  REQUIRE(radii.size() == 4);
  for (size_t i = 0; i < 4; ++i)
    CHECK(radii[i] == doctest::Approx(0.1 + 0.05 * static_cast<double>(i)).scale(0));
}

TEST_CASE("m3c2_file__unknown_keys_are_told_and_what_cannot_be_done_is_refused") {
  ParamSet p = params();
  const auto warnings =
      read_cloudcompare_m3c2("M3C2VER=1\nSearchScale=0.4\nNewIdea=7\n; a comment\n", p);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("NewIdea=7") != std::string::npos);
  CHECK(p.number("cylinder_radius_m") == 0.2);
  CHECK(refused("M3C2VER=1\nPositiveSearchOnly=true") == Status::kUnsupported);
  CHECK(refused("M3C2VER=1\nUsePrecisionMaps=true") == Status::kUnsupported);
  CHECK(refused("M3C2VER=1\nNormalPreferedOri=6") == Status::kUnsupported);
  CHECK(refused("M3C2VER=1\nNormalMode=9") == Status::kUnsupported);
  CHECK(refused("NormalScale=0.5") == Status::kFormat);
  CHECK(refused("") == Status::kFormat);
  CHECK(refused("M3C2VER=1\nNormalScale=wide") == Status::kFormat);
  CHECK(refused("M3C2VER=1\nNormalScale=0,5") == Status::kFormat);
  CHECK(refused("M3C2VER=1\nUseMedian=maybe") == Status::kFormat);
  CHECK(refused("M3C2VER=1\nthis is prose") == Status::kFormat);
  CHECK(refused("M3C2VER=1\nNormalMode=2\nNormalMinScale=0.2") == Status::kFormat);
  CHECK(refused("M3C2VER=1\nNormalMode=2\nNormalMinScale=0.2\nNormalStep=1e-9\nNormalMaxScale=1") ==
        Status::kFormat);
  CHECK(refused("M3C2VER=1\nSearchScale=0.4\nSearchDepth=-1") == Status::kInvalidArgument);
}
