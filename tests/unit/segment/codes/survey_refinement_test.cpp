// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/survey_refinement.h"

#include <doctest/doctest.h>

#include <cmath>

#include "segment/codes_methods.h"
#include "unit/segment/codes/coded.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A front wall on y = 0 with the frame of a window 0.2 m behind it and its four reveals; what each point is.
struct RevealedWindow {
  std::vector<Vec3> points;
  std::vector<uint8_t> truth;

  RevealedWindow() {
    for (int i = 0; i < 500; ++i)
      for (int k = 0; k < 150; ++k) {
        const double x = 0.01 + 0.02 * i, z = 0.01 + 0.02 * k;
        const bool is_hole = x > 5 && x < 7 && z > 1 && z < 2;
        const bool is_pane = x > 5.08 && x < 6.92 && z > 1.08 && z < 1.92;
        if (!is_hole) add({x, 0, z}, 1);
        else if (!is_pane) add({x, 0.2, z}, 3);
      }
    for (double y = 0.01; y < 0.2; y += 0.02) {
      for (double z = 1.01; z < 2; z += 0.02) add({5, y, z}, 1), add({7, y, z}, 1);
      for (double x = 5.01; x < 7; x += 0.02) add({x, y, 1}, 1), add({x, y, 2}, 1);
    }
  }
  void add(const Vec3& p, uint8_t what) {
    points.push_back(p);
    truth.push_back(what);
  }
  /// Points of a class that were given another.
  size_t confused(CodeForm form, uint8_t truly, uint8_t given, const std::string& codes) const {
    SurveyCodeSettings settings;
    settings.input.codes = codes;
    settings.input.form = form;
    Task task;
    const Segmentation s = segment_by_survey_codes(cloud_of(points), settings, task);
    const auto classes = s.cloud->fields.require("classification").values<uint8_t>();
    size_t count = 0;
    for (size_t i = 0; i < truth.size(); ++i) count += truth[i] == truly && classes[i] == given;
    return count;
  }
};

const std::string kBuilding =
    "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;0;0;300.4\n";

}  // namespace

TEST_CASE("survey_refinement__reveals_are_their_walls_and_frames_stay_whole") {
  const RevealedWindow window;
  for (const char* corners : {"8;5;0.2;1;360\n9;7;0.2;2;360\n",       // as it stands
                              "8;7;0.22;2;360\n9;5;0.19;1;360\n"}) {  // skewed, the other order
    const std::string codes = kBuilding + corners;
    const size_t before = window.confused(CodeForm::kSource, 1, 3, codes),
                 after = window.confused(CodeForm::kImproved, 1, 3, codes);
    CHECK(before > 250);  // the last rows of the reveals, all round
    CHECK(after == 0);
    CHECK(window.confused(CodeForm::kImproved, 3, 1, codes) == 0);
  }
}

TEST_CASE("survey_refinement__a_window_that_was_measured_3_cm_too_deep_is_found") {
  const RevealedWindow window;
  const std::string codes = kBuilding + "8;5;0.235;1;360\n9;7;0.235;2;360\n";
  CHECK(window.confused(CodeForm::kSource, 3, 1, codes) > 500);
  CHECK(window.confused(CodeForm::kImproved, 3, 1, codes) == 0);
}

TEST_CASE("survey_refinement__a_frame_farther_behind_the_eaves_than_the_shell_is_deep_is_found") {
  // The outline is the edge of the roof 6 cm before the wall, the frame 26 cm behind it: the shell is hollow there.
  const RevealedWindow window;
  const std::string codes =
      "1;0;-0.06;3;300.2\n2;10;-0.06;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;-0.06;0;300.4\n"
      "8;5;0.2;1;360\n9;7;0.2;2;360\n";
  CHECK(window.confused(CodeForm::kSource, 3, 0, codes) > 500);
  CHECK(window.confused(CodeForm::kImproved, 3, 0, codes) == 0);
}

TEST_CASE("survey_refinement__a_leaf_that_stands_open_is_its_windows") {
  // The same hole, its frame turned inward by 15 degrees about its left end: its free end lies 0.7 m behind the wall.
  RevealedWindow window;
  size_t frame = 0;
  for (size_t i = 0; i < window.points.size(); ++i)
    if (window.truth[i] == 3) {
      const double angle = std::acos(-1.0) / 12, u = window.points[i].x - 5;
      window.points[i].x = 5 + std::cos(angle) * u;
      window.points[i].y = 0.2 + std::sin(angle) * u;
      ++frame;
    }
  const std::string codes = kBuilding + "8;5;0.2;1;360\n9;7;0.2;2;360\n";
  CHECK(window.confused(CodeForm::kSource, 3, 3, codes) < frame / 2);
  CHECK(window.confused(CodeForm::kImproved, 3, 3, codes) > frame * 98 / 100);
}

TEST_CASE("survey_refinement__a_shifted_gutter_is_warned_of_by_name_and_moved") {
  std::vector<Vec3> points;
  for (int k = 0; k < 140; ++k)
    for (int i = 0; i <= 12; ++i) {
      const double angle = std::acos(-1.0) * i / 12;
      points.push_back(
          {4 + 0.04 * std::cos(angle), -0.1 - 0.04 * std::sin(angle), 0.01 + 0.02 * k});
    }
  for (const double shift : {0.0, 0.03}) {
    const std::string y = text_of(-0.1 - shift, 3);
    SurveyCodeSettings settings;
    settings.input.codes =
        kBuilding + "10;4;" + y + ";0;408\n11;4.04;" + y + ";0;409\n12;4;" + y + ";2.8;410\n";
    settings.input.form = CodeForm::kImproved;
    Task task;
    const Segmentation s = segment_by_survey_codes(cloud_of(points), settings, task);
    const bool is_told = s.notes_json.find("from the surveyed one") != std::string::npos;
    CHECK(is_told == (shift > 0));
    CHECK((s.notes_json.find("\"line\":6,\"object\":\"gutter 10\"") != std::string::npos) ==
          is_told);
    size_t of_gutter = 0;
    for (const uint8_t c : s.cloud->fields.require("classification").values<uint8_t>())
      of_gutter += c == 4;
    CHECK(of_gutter == points.size());
  }
}
