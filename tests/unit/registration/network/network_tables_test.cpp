// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_tables.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("network_tables__the_ellipse_is_that_of_the_covariance") {
  NetworkAdjustment network;
  // 3 cm along N 30 E, 1 cm across.
  const double a = std::numbers::pi / 6, c = std::cos(a), s = std::sin(a);
  const double l = 9e-4, w = 1e-4;
  network.points.push_back({{},
                            {l * s * s + w * c * c, (l - w) * s * c, 0, (l - w) * s * c,
                             l * c * c + w * s * s, 0, 0, 0, 4e-4}});
  const FieldTable table = network_points(network);
  CHECK(table.require("ellipse_major").values<double>()[0] == doctest::Approx(0.03));
  CHECK(table.require("ellipse_minor").values<double>()[0] == doctest::Approx(0.01));
  CHECK(table.require("ellipse_azimuth").values<double>()[0] == doctest::Approx(a));
  CHECK(table.require("sigma").values<double>()[2] == doctest::Approx(0.02));
}

TEST_CASE("network_tables__observations_have_their_lines_and_ends_and_codes_their_points") {
  NetworkSettings settings;
  Survey survey = observed(settings, {});
  survey.points[8].code = "921";
  Task task;
  const NetworkAdjustment network = adjust_network(survey, settings, task);
  const FieldTable table = network_observations(network);
  CHECK(table.require("line").values<uint64_t>()[0] == 2);
  CHECK(table.require("from").values<uint64_t>()[0] == 0);
  CHECK(table.require("to").values<uint64_t>()[0] == survey.sightings[0].target);
  const size_t last = network.kinds.size() - 1;
  CHECK(table.require("kind").values<uint8_t>()[last] == 8);
  CHECK(table.require("line").values<uint64_t>()[last] == 0);
  CHECK(network_codes(network) == "12;40.8030;142.6550;246.7620;921\n");
  CHECK(network_summary(network).require("outliers").values<uint64_t>()[0] == 0);
}
