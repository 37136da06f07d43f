// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/sections/section_pieces.h"

#include <doctest/doctest.h>

#include <numeric>

#include "base/random.h"

namespace jalon {
namespace {

constexpr double kCell_m = 0.02, kTolerance_m = 0.02;

// A chain of nodes of one point each.
struct MadeChain {
  std::vector<Vec2> points;
  std::vector<ProfileNode> nodes;
  std::vector<uint32_t> order, chain;

  explicit MadeChain(std::vector<Vec2> given) : points(std::move(given)) {
    for (uint32_t i = 0; i < points.size(); ++i) nodes.push_back({points[i], i, 1});
    order.resize(points.size());
    std::iota(order.begin(), order.end(), 0u);
    chain = order;
  }
  SectionPieces pieces() const { return {points, nodes, order, kCell_m, kTolerance_m}; }
  std::vector<uint32_t> simplified() const {
    return simplify(points, SectionPieces::kFirstShare * kTolerance_m);
  }
};

// An L of two sides of 1 m by steps of 2 cm, with noise across; its corner cut off.
MadeChain cut_corner(double sigma_m) {
  RandomStream random(1, 4);
  std::vector<Vec2> points;
  for (int i = 0; i < 50; ++i) points.push_back({0.02 * i, sigma_m * random.normal()});
  points.push_back({0.993, 0.007});
  for (int i = 1; i <= 50; ++i) points.push_back({1 + sigma_m * random.normal(), 0.02 * i});
  return MadeChain(points);
}

TEST_CASE("section_pieces__a_corner_cut_off_by_cells_is_where_the_lines_meet") {
  for (const double sigma_m : {0.0, 0.003}) {
    const MadeChain made = cut_corner(sigma_m);
    const SectionPieces pieces = made.pieces();
    const std::vector<uint32_t> kept = pieces.tidied(made.chain, made.simplified());
    REQUIRE(kept.size() == 3);
    const SectionPiece a = pieces.fit(made.chain, kept[0], kept[1]),
                       b = pieces.fit(made.chain, kept[1], kept[2]);
    const Vec2 corner = pieces.corner(a, b, made.points[kept[1]]);
    CHECK(norm(corner - Vec2{1, 0}) < 1e-12 + sigma_m);
  }
}

TEST_CASE("section_pieces__lines_too_flat_to_meet_end_beside_their_node") {
  const MadeChain made({{0, 0}, {1, 0}, {2, 0.01}});
  const SectionPieces pieces = made.pieces();
  const SectionPiece a{{0, 0}, {1, 0}, 0, 1}, b{{1, 0.004}, {1, 0}, 1, 2};
  CHECK(norm(pieces.corner(a, b, {1, 0.01}) - Vec2{1, 0.002}) < 1e-12);
}

TEST_CASE("section_pieces__a_loop_begins_at_a_corner_and_has_no_other_end") {
  std::vector<Vec2> points;  // a square of 1 m from the middle of a side
  for (int i = 0; i < 25; ++i) points.push_back({0.5 + 0.02 * i, 0});
  for (int i = 0; i < 50; ++i) points.push_back({1, 0.02 * i});
  for (int i = 0; i < 50; ++i) points.push_back({1 - 0.02 * i, 1});
  for (int i = 0; i < 50; ++i) points.push_back({0, 1 - 0.02 * i});
  for (int i = 0; i < 26; ++i) points.push_back({0.02 * i, 0});
  MadeChain made(points);
  made.chain.back() = 0;
  const SectionPieces pieces = made.pieces();
  std::vector<uint32_t> chain = made.chain;
  const std::vector<uint32_t> kept = pieces.tidied_loop(chain, made.simplified());
  REQUIRE(kept.size() == 5);
  CHECK(kept.front() == 0);
  CHECK(kept.back() == chain.size() - 1);
  CHECK(chain.front() == chain.back());
  for (const uint32_t place : kept) {
    const Vec2 p = pieces.at(chain[place]);
    CHECK(std::min(p.u, 1 - p.u) < 1e-12);
    CHECK(std::min(p.v, 1 - p.v) < 1e-12);
  }
}

}  // namespace
}  // namespace jalon
