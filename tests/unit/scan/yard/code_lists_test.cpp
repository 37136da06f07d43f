// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/yard/code_lists.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "base/text_number.h"
#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Line {
  Vec3 place;
  std::string code;
};

std::vector<Line> read(const std::vector<std::string>& lines) {
  std::vector<Line> out;
  for (const std::string& line : lines) {
    std::vector<std::string> columns(1);
    for (const char c : line)
      if (c == ';') columns.emplace_back();
      else columns.back() += c;
    REQUIRE(columns.size() == 5);
    out.push_back({{}, columns[4]});
    for (int axis = 0; axis < 3; ++axis)
      CHECK(parse_number(columns[static_cast<size_t>(axis) + 1], out.back().place[axis]));
  }
  return out;
}

}  // namespace

TEST_CASE("yard_survey__has_the_points_of_every_object") {
  const yard::Plan plan = yard_plan(YardZone::kFacades);
  std::map<std::string, int> codes;
  for (const Line& line : read(yard::survey_lines(plan, {}, 1, {}))) ++codes[line.code];
  CHECK(codes["300.2"] + codes["301.2"] + codes["302.2"] == 3);
  CHECK(codes["300.4"] == 4);  // three more corners and a low point
  CHECK(codes["301.4"] == 12);
  CHECK(codes["351.8"] * 2 == codes["351"]);
  CHECK(codes["361.8"] * 2 == codes["361"]);
  CHECK(codes["362.8"] == codes["362"]);
  const int doors = codes["350"] / 2 + codes["351.8"];
  const int windows = codes["361.8"] + codes["362"] / 2;
  CHECK(doors == static_cast<int>(openings_of(plan, true)));
  CHECK(windows == static_cast<int>(openings_of(plan, false)));
  CHECK(codes["408"] == 6);
  CHECK(codes["409"] == 6);
  CHECK(codes["410"] == 6);
}

TEST_CASE("yard_survey__noise_and_the_shift_to_the_cloud_are_as_asked") {
  const yard::Plan plan = yard_plan(YardZone::kComplete);
  YardSettings exact;
  exact.survey_noise_m = exact.georeference_m = 0;
  const auto truth = read(yard::survey_lines(plan, exact, 1, {}));
  const auto measured = read(yard::survey_lines(plan, {}, 1, {}));
  REQUIRE(truth.size() == measured.size());
  Vec3 mean;
  for (size_t i = 0; i < truth.size(); ++i)
    mean += (measured[i].place - truth[i].place) / static_cast<double>(truth.size());
  CHECK(norm(mean) == doctest::Approx(0.005).epsilon(0.2).scale(0));
  double squares = 0;
  for (size_t i = 0; i < truth.size(); ++i)
    squares += squared_norm(measured[i].place - truth[i].place - mean);
  CHECK(std::sqrt(squares / (3.0 * static_cast<double>(truth.size()))) ==
        doctest::Approx(0.002).epsilon(0.15).scale(0));
  CHECK(norm(truth[0].place - Vec3{74.599, 81.248, 249.743}) < 1e-4);
}

TEST_CASE("yard_survey__a_shifted_gutter_is_one_point") {
  const yard::Plan plan = yard_plan(YardZone::kFacades);
  YardSettings shifted;
  shifted.gutter_shift_m = 0.03;
  const auto is = read(yard::survey_lines(plan, shifted, 1, {})),
             was = read(yard::survey_lines(plan, {}, 1, {}));
  int moved = 0;
  for (size_t i = 0; i < is.size(); ++i) {
    const double by = norm(is[i].place - was[i].place);
    if (by == 0) continue;
    ++moved;
    CHECK(by == doctest::Approx(0.03).epsilon(0.01).scale(0));
    CHECK(is[i].code == "408");
  }
  CHECK(moved == 1);
}

TEST_CASE("yard_targets__are_listed_with_their_own_numbers") {
  const yard::Plan plan = yard_plan(YardZone::kComplete);
  const auto lines = yard::target_lines(plan, {});
  REQUIRE(lines.size() == plan.targets.size());
  CHECK(lines[0].rfind("107;", 0) == 0);
  CHECK(lines[0].substr(lines[0].size() - 2) == ";3");
}
