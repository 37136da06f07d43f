// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "report/pages/landslide_sections.h"
#include "unit/compare/landslide/slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string section_of(const Comparison& comparison) {
  Page page;
  page.html().open("body");
  add_landslide(page, comparison);
  return page.html().take();
}

}  // namespace

TEST_CASE("landslide_sections__tell_volumes_with_sigma_and_what_was_not_measured") {
  const auto gap = [](double x, double y) { return x > 18 && x < 22 && y > 15 && y < 27; };
  const std::string open =
      section_of(compared_slopes(slope_survey(false, 1), slope_survey(true, 2, 60000, gap)));
  CHECK(open.find("What was not measured") != std::string::npos);
  CHECK(open.find("it is not known how far") != std::string::npos);
  const std::string whole =
      section_of(compared_slopes(slope_survey(false, 1), slope_survey(true, 2)));
  CHECK(whole.find("all of it measured on both sides") != std::string::npos);
  CHECK(whole.find("went down") != std::string::npos);
  CHECK(is_told_of_landslide("depletion_sigma"));
  CHECK_FALSE(is_told_of_landslide("systematic"));
}

TEST_CASE("landslide_sections__of_another_method_say_nothing") {
  Comparison other;
  other.cloud = std::make_shared<const Cloud>();
  CHECK(section_of(other).find("moved") == std::string::npos);
}
