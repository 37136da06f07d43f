// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/network_report.h"

#include <doctest/doctest.h>

#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("network_report__has_test_plan_points_and_the_worst_observation_first") {
  Task task;
  const NetworkSettings settings;
  RandomStream random(1, 0);
  Survey survey = observed(settings, {&random});
  survey.sightings[5].distance_m += 0.2;  // a slip
  const NetworkAdjustment network = adjust_network(std::move(survey), settings, task);
  const std::string page =
      network_html(network, "{\"datum\": \"fixed\"}", "{\"title\": \"<Yard>\"}", task);
  const auto says = [&](const std::string& text) { return page.find(text) != std::string::npos; };
  CHECK(says("&lt;Yard&gt;"));
  CHECK(says("12 points, 12 setups"));
  CHECK(says("global test"));
  CHECK(says("<svg"));
  CHECK(says("Reliability (Baarda)"));
  CHECK(says("datum"));
  CHECK(says("fixed</td>"));
  const size_t heading = page.find("Observations, the largest"), first = page.find("<td>", heading);
  REQUIRE(first != std::string::npos);
  CHECK(page.compare(first, 12, "<td>distance") == 0);
  CHECK(page.find("outlier", first) < page.find("</tr>", first));
}
