// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The page on a drive and a street adjusted together: what it says is what the adjustment holds.
#include "report/pages/adjustment_report.h"

#include <doctest/doctest.h>

#include <string>

#include "base/text_number.h"
#include "scan/mobile/drive_scenario.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::has;

namespace {

struct Street {
  DriveScenario drive;
  JointAdjustment adjustment;

  Street() {
    DriveScenarioSettings from;
    from.leg_m = 60, from.revolutions_per_s = 10, from.pulses = 200;
    Task task;
    drive = drive_scenario(from, task);
    adjustment = adjust_jointly(drive.model, drive.cloud, drive.trajectory, {}, task);
  }
  std::string page(const Trajectory* truth = nullptr,
                   AdjustmentReportSettings settings = {}) const {
    Task task;
    return adjustment_html(adjustment, {drive.model, drive.trajectory, truth}, "", settings, task);
  }
};

const Street& street() {
  static const Street made;
  return made;
}

size_t rows_of(const std::string& page, const std::string& heading) {
  const size_t from = page.find("<h2>" + heading), body = page.find("<tbody>", from),
               end = page.find("</tbody>", body);
  size_t n = 0;
  for (size_t at = body; (at = page.find("<tr>", at)) < end; ++at) ++n;
  return n;
}

}  // namespace

TEST_CASE("adjustment_report__says_what_came_out_and_its_test") {
  const Street& s = street();
  const std::string page = s.page();
  CHECK(has(page, s.adjustment.converged ? "Converged" : "Not converged"));
  CHECK(has(page, text_of(s.adjustment.chi_square, 1) + " on "));
  for (const char* chapter :
       {"Plan", "Along the drive", "Distances of the matched points", "A facade before and after",
        "What became of the points", "Convergence"})
    CHECK(has(page, std::string("<h2>") + chapter));
  CHECK(has(page, "Shapiro-Wilk on "));
}

TEST_CASE("adjustment_report__draws_the_truth_where_it_is_known") {
  const Street& s = street();
  CHECK_FALSE(has(s.page(), "east, true"));
  CHECK(has(s.page(&s.drive.true_trajectory), "east, true"));
}

TEST_CASE("adjustment_report__lists_as_many_strips_as_asked_for") {
  CHECK(rows_of(street().page(nullptr, {.strips = 5}), "The strips that moved most") == 5);
  CHECK_FALSE(has(street().page(nullptr, {.strips = 0}), "The strips that moved most"));
}

TEST_CASE("adjustment_report__warns_where_the_sigmas_cannot_be_right") {
  JointAdjustment bad = street().adjustment;
  bad.p_value = 1e-9;
  bad.weak_share = 0;
  Task task;
  const std::string page =
      adjustment_html(bad, {street().drive.model, street().drive.trajectory}, "", {}, task);
  CHECK(has(page, "below one in a thousand"));
  CHECK(has(page, "Nothing is known along the direction"));
  CHECK_FALSE(has(street().page(), "below one in a thousand"));
}
