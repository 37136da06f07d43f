// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/densities.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "scan/builder/builder.h"
#include "unit/scan/fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Model two_sheets() {
  SceneBuilder out{Transform{}};
  const Frame level{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  out.face(out.part("ground", "ground"), level, {0, 10, 0, 10});
  out.face(out.part("roof", "roof"), level.raised(3), {0, 10, 0, 10});
  return out.take();
}

}  // namespace

TEST_CASE("densities__parts_of_a_class_get_that_many_times_the_points") {
  SampleSettings settings;
  settings.spacing_m = 0.1;
  settings.densities = "roof=4,ground=0.5";
  const Cloud cloud = sampled(two_sheets(), settings);
  size_t above = 0;
  for (size_t i = 0; i < cloud.size(); ++i) above += cloud.point(i).z > 1;
  CHECK(cloud.size() == 45000);
  CHECK(above == doctest::Approx(40000).epsilon(1e-3));
}

TEST_CASE("densities__a_text_that_is_none_is_refused") {
  const Model model = two_sheets();
  CHECK(triangle_densities(model, "") == std::vector<double>(model.triangles.size(), 1.0));
  for (const char* text :
       {"roof", "roof=", "=2", "roof=-1", "roof=4,", "roof=4,,ground=1", "tree=2"}) {
    CAPTURE(text);
    if (std::string(text) == "roof=4,") CHECK_NOTHROW(triangle_densities(model, text));
    else CHECK_THROWS_AS(triangle_densities(model, text), Error);
  }
}
