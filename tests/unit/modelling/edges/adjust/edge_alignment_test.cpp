// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Weak edges take the line of better ones.
#include <doctest/doctest.h>

#include <vector>

#include "modelling/edges/adjust/edge_alignment.h"

using namespace jalon;

namespace {

constexpr double kSpacing = 0.1;

MeasuredEdge upright(double u, double from_v, double to_v, double sigma_m) {
  MeasuredEdge edge;
  edge.shape = straight_shape({u, from_v}, {u, to_v});
  edge.shape.sigma_m = sigma_m;
  return edge;
}

}  // namespace

TEST_CASE("align_edges__a_weak_edge_takes_the_line_of_those_measured_well") {
  MeasuredEdge a = upright(2.000, 0, 3, 0.002), b = upright(2.003, 4, 7, 0.002),
               weak = upright(2.06, 8, 8.4, 0.05);
  MeasuredEdge down = upright(2.05, 9, 8, 0.05), far = upright(2.4, 0, 3, 0.05);
  std::vector<MeasuredEdge*> edges{&weak, &a, &down, &far, &b};
  align_edges(edges, kSpacing);
  CHECK(a.shape.line.point.u == doctest::Approx(2.0015).epsilon(1e-4));
  CHECK(b.shape.line.point.u == a.shape.line.point.u);
  CHECK(weak.shape.line.point.u == a.shape.line.point.u);
  CHECK(weak.shape.sigma_m < 0.0015);
  CHECK(down.shape.line.point.u == 2.05);  // the solid on the other side
  CHECK(far.shape.line.point.u == 2.4);
}

TEST_CASE("align_edges__what_is_measured_well_keeps_its_place") {
  MeasuredEdge a = upright(2.00, 0, 3, 0.002), b = upright(2.03, 4, 7, 0.002);
  std::vector<MeasuredEdge*> edges{&a, &b};
  align_edges(edges, kSpacing);
  CHECK(a.shape.line.point.u == 2.00);
  CHECK(b.shape.line.point.u == 2.03);
}
