// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Tables of a registration: poses, directions and residuals that are known, read back from the page.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "geometry/rigid_motion.h"
#include "report/pages/registration_tables_html.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::has;
using page_scenes::tables_of;

namespace {

template <class Add>
std::string chapter(const Registration& r, const Add& add) {
  Page page;
  add(page, r);
  return page.html().take();
}

// "(1.00, 2.00, 3.00)" behind a text of a cell.
std::vector<double> vector_in(const std::string& cell) {
  const size_t from = cell.find('('), to = cell.find(')');
  REQUIRE(to != std::string::npos);
  return page_scenes::numbers_of(cell.substr(from + 1, to - from - 1));
}

}  // namespace

TEST_CASE("registration_tables__each_outcome_has_a_sentence_of_its_own") {
  Registration r;
  r.iterations = 1234;
  r.pairs = 5678;
  r.rms_m = 0.0012341;
  std::set<std::string> sentences;
  for (const StopReason reason :
       {StopReason::kConverged, StopReason::kIterationLimit, StopReason::kTooFewPairs,
        StopReason::kAmbiguous, StopReason::kNothingFound}) {
    r.stopped = reason;
    const std::string text = outcome_text(r);
    CHECK(text.back() == '.');
    CHECK(sentences.insert(text).second);
    CHECK(has(text, "Converged") == (reason == StopReason::kConverged));
  }
  r.stopped = StopReason::kConverged;
  for (const char* told : {"1 234 iterations", "5 678 pairs", "1.234 mm"})
    CHECK_MESSAGE(has(outcome_text(r), told), told);
  CHECK(!has(outcome_text(r), "directions"));
  r.unobservable = 2;
  CHECK(has(outcome_text(r), "2 of six directions are not fixed"));
}

TEST_CASE("registration_tables__the_pose_is_told_as_matrix_and_as_turn_and_shift") {
  Registration r;
  r.centre = {652000, 6861000, 30};
  const Vec3 axis = normalized(Vec3{1, 2, -2}), shift{0.5, -0.25, 0.125};
  r.pose = motion_about(r.centre - shift, axis * (std::numbers::pi / 6), shift);
  for (size_t k = 0; k < 6; ++k) r.covariance[7 * k] = k < 3 ? 1e-6 : 4e-6;
  const auto tables = tables_of(chapter(r, add_pose), "Pose");
  REQUIRE(tables.size() == 2);
  REQUIRE(tables[0].size() == 4);
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 4; ++j)  // half of the last digit: 12 decimals, of lengths 6
      CHECK(std::abs(markup::number(tables[0][i][j]) - r.pose.m[4 * i + j]) <
            (j == 3 ? 0.6e-6 : 0.6e-12));
  CHECK(tables[0][3] == page_scenes::Row{"0", "0", "0", "1"});
  const auto& told = tables[1];
  REQUIRE(told.size() == 5);
  CHECK(has(told[0][1], "30.000000\xC2\xB0"));
  const auto about = vector_in(told[0][1]), moved = vector_in(told[1][1]);
  for (size_t k = 0; k < 3; ++k) {
    CHECK(std::abs(about[k] - axis[static_cast<int>(k)]) < 0.6e-4);
    CHECK(std::abs(moved[k] - shift[static_cast<int>(k)]) < 0.6e-5);  // where the centre came from
  }
  for (const double degrees : vector_in(told[3][1]))
    CHECK(std::abs(degrees - 0.001 * 180 / std::numbers::pi) < 0.6e-6);
  CHECK(vector_in(told[4][1]) == std::vector<double>{2, 2, 2});
  r.scale = 1.00012;
  const auto scaled = tables_of(chapter(r, add_pose), "Pose")[1];
  REQUIRE(scaled.size() == 6);
  CHECK(markup::number(scaled[5][1]) == 1.00012);
}

TEST_CASE("registration_tables__directions_are_turns_and_shifts_in_words") {
  Registration r;
  CHECK(chapter(r, add_directions).empty());
  r.extent_m = 4;  // a step of 1 m at the extent is a turn of 0.25 rad
  const std::vector<std::vector<double>> steps{
      {0, 0, 0.25, 0, 0, 0}, {0, 0, 0, 0, -1, 0}, {0.15, 0, 0, 0, 0, 0.8}};
  add_columns<double, 6>(r.directions, steps, "direction", "", "",
                         [](const auto& step, double* o) { std::copy_n(step.data(), 6, o); });
  add_column<double>(r.directions, steps, "sigma", "m", "",
                     [](const auto& step) { return step[2] > 0 ? NAN : 0.0015; });
  add_column<uint8_t>(r.directions, steps, "observable", "", "",
                      [](const auto& step) { return step[2] > 0 ? 0 : 1; });
  const auto table = tables_of(chapter(r, add_directions), "What fixes the pose").at(0);
  REQUIRE(table.size() == 4);
  CHECK(table[1] == page_scenes::Row{"turn about (0.00, 0.00, 1.00)", "-", "no: as at the start"});
  CHECK(table[2] == page_scenes::Row{"shift along (0.00, -1.00, 0.00)", "1.500", "yes"});
  CHECK(table[3][0] == "shift along (0.00, 0.00, 1.00) with turn about (1.00, 0.00, 0.00)");
}

TEST_CASE("registration_tables__pairs_are_listed_in_millimetres_up_to_a_thousand") {
  const auto with_pairs = [](size_t n) {
    Registration r;
    const std::vector<double> rows(n, 1);
    add_columns<double, 3>(r.residuals, rows, "residual", "m", "", [](double, double* o) {
      o[0] = 0.00125;
      o[1] = -0.002;
      o[2] = NAN;
    });
    add_column<double>(r.residuals, rows, "p_value", "1", "", [](double) { return 0.0625; });
    add_column<uint64_t>(r.residuals, rows, "reference", "", "", [](double) { return 12; });
    r.pair_names = {"A & B", ""};
    return chapter(r, add_pairs_table);
  };
  const auto table = tables_of(with_pairs(3), "Residuals").at(0);
  REQUIRE(table.size() == 4);
  CHECK(table[0] == page_scenes::Row{"target", "residual (mm)", "p_value (1)", "reference"});
  REQUIRE(table[1].size() == 4);
  CHECK(table[1][0] == "A &amp; B");
  CHECK(table[1][1].substr(table[1][1].find(',')) == ", -2.00, -");
  CHECK(std::abs(page_scenes::numbers_of(table[1][1])[0] - 1.25) < 1e-12);
  CHECK(std::abs(markup::number(table[1][2]) - 0.0625) < 0.51e-3);
  CHECK(table[1][3] == "12");
  CHECK(table[2][0] == "2");  // without a name, and beyond the names
  CHECK(table[3][0] == "3");
  CHECK(tables_of(with_pairs(1000), "Residuals").at(0).size() == 1001);
  CHECK(with_pairs(1001).empty());
  CHECK(with_pairs(0).empty());
}
