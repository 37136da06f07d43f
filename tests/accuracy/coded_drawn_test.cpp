// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What is drawn of targets on the synthetic yard, beside the surveyed corners and axes of the same doors, windows and
// gutters, which a surveyor measured to 3 mm. JALON_YARD_SEEDS=82-91 takes these yards.
#include <doctest/doctest.h>

#include "coded_outcome.h"
#include "seed_range.h"

namespace jalon::coded_drawn_test {

using namespace jalon::test;

namespace {

constexpr double kFullSpacing_m = 0.02, kShortSpacing_m = 0.04;
constexpr double kNear_m = 0.025;  // of each side of an object's box
// In form "improved", on all seeds tried: the share of windows and of doors, and the farthest side of a gutter. One of
// the four doors stands in the troughs of its corrugated wall, which are drawn as its own, 6 cm at either side.
constexpr double kLeastWindows = 0.8, kLeastDoors = 0.5, kFarthestGutter_m = 0.05;

std::string text_of_drawn(const char* word, const DrawnChange& change) {
  std::vector<double> moved = change.moved;
  std::sort(moved.begin(), moved.end());
  const double median_m = moved.empty() ? kNaN : moved[moved.size() / 2];
  return std::string(word) + " " + std::to_string(change.within(kNear_m)) + " of " +
         std::to_string(moved.size()) + " drawn within 25 mm, median " +
         jalon::text_of(1000 * median_m, 1) + " mm, most " +
         jalon::text_of(1000 * change.most_m(), 1) + " mm";
}

}  // namespace

TEST_CASE("coded_drawn__targets_draw_objects_where_the_survey_has_them") {
  YardSettings settings;
  settings.zone = YardZone::kFacades;
  SeedRange seeds{1, is_full() ? 10u : 1u};
  if (const auto asked = seeds_asked_for("JALON_YARD_SEEDS")) seeds = *asked;
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const CodedYard yard(settings, seed, is_full() ? kFullSpacing_m : kShortSpacing_m);
    const Coded survey = coded_of(yard, {}, true, CodeForm::kSource);
    for (const CodeForm form : {CodeForm::kSource, CodeForm::kImproved}) {
      const Coded targets = coded_of(yard, {}, false, form);
      const auto of = [&](const char* word) {
        return change_of(survey.drawn, targets.drawn, word);
      };
      const DrawnChange doors = of(part_class::kDoor), windows = of(part_class::kWindow),
                        gutters = of(part_class::kGutter);
      CAPTURE(seed);
      MESSAGE("FIGURE codes, drawn, seed "
              << seed << ", targets, "
              << std::string(form == CodeForm::kSource ? "source" : "improved") << ": "
              << text_of_drawn("doors", doors) << "; " << text_of_drawn("windows", windows) << "; "
              << text_of_drawn("gutters", gutters));
      if (form == CodeForm::kSource) continue;
      const auto least = [](double share, size_t of_all) {
        return static_cast<size_t>(share * static_cast<double>(of_all));
      };
      CHECK(windows.within(kNear_m) >= least(kLeastWindows, windows.before));
      CHECK(doors.within(kNear_m) >= least(kLeastDoors, doors.before));
      CHECK(gutters.most_m() < kFarthestGutter_m);
    }
  }
}

}  // namespace jalon::coded_drawn_test
