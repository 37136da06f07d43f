// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Edges of few points follow the lines of others.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "modelling/edges/adjust/edge_alignment.h"
#include "modelling/edges/find/chain_parts.h"
#include "modelling/edges/find/guide_lines.h"
#include "modelling/edges/find/guided_steps.h"

using namespace jalon;

namespace {

constexpr double kSpacing = 0.1;

MeasuredEdge upright(double u, double from_v, double to_v, double sigma_m) {
  MeasuredEdge edge;
  edge.shape = straight_shape({u, from_v}, {u, to_v});
  edge.shape.sigma_m = sigma_m;
  return edge;
}

std::vector<double> places(const GuideLines& guides, const Vec2& p, double reach_m) {
  std::vector<double> out;
  guides.visit(p, reach_m, [&](const EdgeLine& line) { out.push_back(line.distance({0, 0})); });
  return out;
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

TEST_CASE("guide_lines__short_edges_in_one_line_guide_and_one_alone_does_not") {
  std::vector<EdgeShape> shapes;
  for (int i = 0; i < 4; ++i)
    shapes.push_back(straight_shape({3.0 * i, 0.01 * (i % 2)}, {3.0 * i + 0.4, 0.01 * (i % 2)}));
  shapes.push_back(straight_shape({0, 5}, {0.4, 5}));
  const GuideLines guides(shapes, {}, {}, kSpacing);
  CHECK(places(guides, {20, 0.1}, 0.2).size() == 1);
  CHECK(places(guides, {0, 5}, 0.2).empty());
}

TEST_CASE("guide_lines__another_planes_line_guides_where_the_contour_has_points_on_it") {
  const std::vector<EdgeLine> joints{{{0, 2}, {1, 0}}, {{0, 9}, {1, 0}}};
  const std::vector<std::vector<Vec2>> chains{
      {{0, 0}, {4, 0}, {4, 2}, {3.9, 2.01}, {3.8, 1.98}, {0, 1}}};
  const GuideLines guides({}, joints, chains, kSpacing);
  CHECK(places(guides, {1, 2}, 0.2).size() == 2);  // either way along
  CHECK(places(guides, {1, 9}, 0.2).empty());
}

TEST_CASE("split_chain__a_stub_of_few_points_is_drawn_by_its_guides") {
  // A band 4 m long with a post's stub on it, 0.4 x 0.5 m, its corners cut by the triangulation.
  std::vector<EdgeShape> lines{
      straight_shape({8, 0}, {2.2, 0}), straight_shape({2.2, -9}, {2.2, 0}),
      straight_shape({1.8, 0}, {1.8, -9}), straight_shape({8, 0.5}, {0, 0.5})};
  const GuideLines guides(lines, {}, {}, kSpacing);
  std::vector<Vec2> chain;
  for (int k = 0; k <= 40; ++k) chain.push_back({0.1 * k, -1 + 0.02 * (k % 3)});
  for (int k = 0; k < 10; ++k) chain.push_back({4 - 0.03 * (k % 2), -0.95 + 0.1 * k});
  for (int k = 0; k < 15; ++k) chain.push_back({4 - 0.1 * k, -0.04 - 0.03 * (k % 2)});
  for (const Vec2& p : {Vec2{2.17, 0.25}, Vec2{2.15, 0.36}, Vec2{2.02, 0.46}, Vec2{1.9, 0.43},
                        Vec2{1.83, 0.3}, Vec2{1.86, 0.2}})
    chain.push_back(p);
  for (int k = 0; k < 15; ++k) chain.push_back({1.55 - 0.1 * k, -0.04 - 0.03 * (k % 2)});
  for (int k = 0; k < 8; ++k) chain.push_back({0.03 * (k % 2), -0.1 - 0.1 * k});
  const auto free = split_chain(chain, {kSpacing, true});
  const auto guided = split_chain(chain, {kSpacing, true, &guides, 0.035, 0.6});
  std::vector<EdgeShape> ring;
  for (const ChainPart& part : guided) ring.push_back(shape_of(chain, part, kSpacing, 0.035, 0.05));
  guide_steps(guides, kSpacing, ring);
  int left = 0, top = 0, right = 0;
  for (const EdgeShape& s : ring) {
    const Vec2 at = s.at(s.length_m / 2, 0);
    if (!s.is_guided) continue;
    right += std::fabs(at.u - 2.2) < 1e-9;
    top += std::fabs(at.v - 0.5) < 1e-9;
    left += std::fabs(at.u - 1.8) < 1e-9;
  }
  CHECK(right == 1);
  CHECK(top == 1);
  CHECK(left == 1);
  for (const ChainPart& part : free) CHECK(!part.is_guided);
}
