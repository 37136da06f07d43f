// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/network_plan.h"

#include <doctest/doctest.h>

#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

namespace {

size_t count_of(const std::string& svg, const std::string& text) {
  size_t count = 0;
  for (size_t at = svg.find(text); at != std::string::npos; at = svg.find(text, at + 1)) ++count;
  return count;
}

NetworkAdjustment adjusted() {
  Task task;
  const NetworkSettings settings;
  return adjust_network(observed(settings, {}), settings, task);
}

}  // namespace

TEST_CASE("network_plan__has_stations_ellipses_of_what_is_not_fixed_and_their_scale") {
  Task task;
  const NetworkAdjustment network = adjusted();
  const std::string svg = network_plan_svg(network, "Yard <1>", task);
  CHECK(svg.find("Yard &lt;1&gt;: 12 points, 12 setups") != std::string::npos);
  CHECK(count_of(svg, "<ellipse") == 10 + 1);  // two points are fixed; one stands in the key
  CHECK(svg.find("times larger") != std::string::npos);
  CHECK(svg.find(" mm<") != std::string::npos);
  CHECK(svg.find("#c81e1e") == svg.rfind("#c81e1e"));  // no outlier but the key's
  for (const Nail& nail : nails())
    CHECK(svg.find(">" + std::string(nail.id) + "<") != std::string::npos);
}

TEST_CASE("network_plan__a_sight_with_an_outlier_is_red") {
  Task task;
  NetworkAdjustment network = adjusted();
  for (size_t i = 0; i < network.kinds.size(); ++i)
    if (network.kinds[i].kind == ObservationKind::kDistance) {
      network.observations[i].is_outlier = true;
      break;
    }
  CHECK(count_of(network_plan_svg(network, "", task), "#c81e1e") == 2);
}
