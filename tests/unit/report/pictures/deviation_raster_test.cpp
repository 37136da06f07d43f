// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "report/pictures/deviation_raster.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;

namespace {

constexpr DeviationScale kRasterScale{0.1, false};

LabelRaster raster_of(const Comparison& comparison, bool only_significant) {
  Task task;
  const DeviationAxes axes = axes_of(comparison, DeviationView::kPlan, task);
  return deviation_raster(comparison, kRasterScale, axes.projection({}), only_significant, task);
}

size_t count(const LabelRaster& raster, uint32_t label) {
  return static_cast<size_t>(std::count(raster.labels.begin(), raster.labels.end(), label));
}

}  // namespace

TEST_CASE("deviation_raster__what_is_not_significant_is_grey_when_only_that_is_asked_for") {
  std::vector<double> distances(2500, 0.0);
  std::vector<uint8_t> significant(2500, 0);
  for (size_t i = 1250; i < 2500; ++i) {
    distances[i] = 0.1;
    significant[i] = i >= 1900 ? 1 : 0;
  }
  Comparison comparison = page_scenes::comparison_of(distances);
  comparison.points.set(make_column<uint8_t>({"significant"}, significant));
  const uint32_t far = DeviationScale::kSteps;
  const LabelRaster all = raster_of(comparison, false), few = raster_of(comparison, true);
  const uint32_t quiet = DeviationScale::kSteps + 2;
  CHECK(count(all, quiet) == 0);
  CHECK(count(few, quiet) > 0);
  CHECK(few.columns == all.columns);  // the map shows as much
  CHECK(count(few, far) > 0);
  CHECK(count(few, far) < count(all, far));
  CHECK(count(few, 1) == 0);
}

TEST_CASE("deviation_raster__axes_are_named_after_what_they_are") {
  const DeviationAxes front{0, 2, 1};
  CHECK(front.right_name() == std::string("X (m)"));
  CHECK(front.up_name() == std::string("Z (m)"));
  const Projection projection = front.projection({1, 2, 3});
  CHECK(projection.flat({4, 9, 7}).u == doctest::Approx(4));
  CHECK(projection.flat({4, 9, 7}).v == doctest::Approx(7));
  CHECK(projection.depth({0, 5, 0}) > projection.depth({0, 1, 0}));
}
