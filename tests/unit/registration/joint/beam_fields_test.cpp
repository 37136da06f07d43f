// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/beam_fields.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("with_whole_beams__joins_what_a_file_has_split_and_leaves_the_rest") {
  Buffer<double> xyz(6);
  for (double& v : std::span<double>(xyz.data(), 6)) v = 0;
  Cloud cloud = make_cloud(std::move(xyz));
  const auto add = [&](const char* name, double a, double b) {
    const double values[] = {a, b};
    cloud.fields.set(make_column<double>({name, ElementType::kFloat64, 1, "", ""}, values));
  };
  add("beam_origin_0", 1, 4), add("beam_origin_1", 2, 5), add("beam_origin_2", 3, 6);
  add("covariance_0", 1, 1);  // the other five are not there
  const Cloud made = with_whole_beams(cloud);
  const auto origin = made.fields.require("beam_origin").values<double>();
  for (size_t i = 0; i < 6; ++i) CHECK(origin[i] == static_cast<double>(i + 1));
  CHECK(made.fields.find("beam_origin_0") == nullptr);
  CHECK(made.fields.find("covariance") == nullptr);
  CHECK(made.fields.find("covariance_0") != nullptr);
}
