// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/task.h"
#include "spatial/triangles/nearest.h"
#include "unit/spatial/triangles/mesh.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Real = long double;

std::shared_ptr<const NearestTriangles> tree_of(const Mesh& mesh, unsigned threads = 0) {
  return built<NearestTriangles>(mesh, threads);
}

std::vector<TriangleAnswer> answers(const NearestTriangles& tree, const std::vector<Vec3>& points,
                                    unsigned threads = 0,
                                    double max_distance = std::numeric_limits<double>::infinity(),
                                    bool with_feet = true) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  std::vector<double> xyz;
  for (const Vec3& p : points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  std::vector<uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<TriangleAnswer> out(points.size());
  tree.for_each(xyz, order, max_distance, {true, with_feet}, task,
                [&](uint32_t i, const TriangleAnswer& a) { out[i] = a; });
  return out;
}

Vec3 random_point(RandomStream& random, double from, double to) {
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {from + (to - from) * x, from + (to - from) * y, from + (to - from) * z};
}

/// Coordinates on the 2^-20 m grid, which any whole-metre shift keeps.
Vec3 on_grid(const Vec3& p) {
  const auto snap = [](double x) { return std::nearbyint(x * 0x1.0p20) * 0x1.0p-20; };
  return {snap(p.x), snap(p.y), snap(p.z)};
}

std::vector<Vec3> random_points(size_t n, uint64_t seed, double from, double to) {
  RandomStream random(seed, 3);
  std::vector<Vec3> out(n);
  for (Vec3& p : out) p = on_grid(random_point(random, from, to));
  return out;
}

/// Small and large triangles, needles of all thicknesses, segments, points, duplicates.
Mesh random_mesh(size_t n, uint64_t seed) {
  Mesh mesh;
  RandomStream random(seed, 1);
  for (size_t i = 0; i < n; ++i) {
    const double reach = 10 * std::pow(10, -3 * random.uniform());
    const Vec3 a = on_grid(random_point(random, 0, 10)),
               b = on_grid(a + random_point(random, -reach, reach)),
               c = on_grid(a + random_point(random, -reach, reach));
    switch (i % 10) {
      case 6:
        mesh.add(a, b, a + (b - a) * 0.3 + (c - a) * std::pow(10, -16 * random.uniform()));
        break;
      case 7:
        mesh.add(a, b, a + (b - a) * 0.5);
        break;
      case 8:
        mesh.add(a, a, a);
        break;
      case 9:
        mesh.triangles.push_back(mesh.triangles.back());
        break;
      default:
        mesh.add(a, b, c);
    }
  }
  return mesh;
}

using Real3 = std::array<Real, 3>;
Real3 minus(const Real3& a, const Real3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real inner(const Real3& a, const Real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Real side_distance(const Real3& p, const Real3& a, const Real3& b) {
  const Real3 side = minus(b, a), to = minus(p, a);
  const Real length2 = inner(side, side);
  const Real t = length2 > 0 ? std::clamp(inner(to, side) / length2, Real(0), Real(1)) : Real(0);
  const Real3 rest = minus(to, {t * side[0], t * side[1], t * side[2]});
  return std::sqrt(inner(rest, rest));
}

Real3 along(const Real3& v, const Real3& unit) {
  const Real t = inner(v, unit);
  return {t * unit[0], t * unit[1], t * unit[2]};
}

/// Distance in extended precision from the sides and, above the face, from what is left of the way from the longest
/// side once its part towards the apex is gone: no normal, which slivers have not.
Real brute_distance(const Mesh& mesh, size_t t, const Vec3& point) {
  const Real3 p = {point.x, point.y, point.z};
  std::array<Real3, 3> k;
  for (size_t i = 0; i < 3; ++i) {
    const Vec3& v = mesh.vertices[mesh.triangles[t][i]];
    k[i] = {v.x, v.y, v.z};
  }
  const auto length = [](const Real3& v) { return std::sqrt(inner(v, v)); };
  while (length(minus(k[1], k[0])) < std::max(length(minus(k[2], k[1])), length(minus(k[0], k[2]))))
    std::rotate(k.begin(), k.begin() + 1, k.end());
  Real best = side_distance(p, k[0], k[1]);
  for (const size_t i : {1, 2}) best = std::min(best, side_distance(p, k[i], k[(i + 1) % 3]));
  const auto unit = [&](const Real3& v) {
    return Real3{v[0] / length(v), v[1] / length(v), v[2] / length(v)};
  };
  const Real base = length(minus(k[1], k[0]));
  if (!(base > 0)) return best;
  const Real3 axis = unit(minus(k[1], k[0])), apex = minus(k[2], k[0]), to = minus(p, k[0]);
  const Real3 up = minus(apex, along(apex, axis)), rest = minus(to, along(to, axis));
  const Real height = length(up);
  if (!(height > base * 1e-18L)) return best;
  const Real x = inner(to, axis), y = inner(rest, unit(up)), foot = inner(apex, axis);
  const bool above =
      y > 0 && y < height && x * height > y * foot && (base - x) * height > y * (base - foot);
  return above ? std::min(best, length(minus(rest, along(rest, unit(up))))) : best;
}

Mesh cube(double edge) {
  Mesh mesh;
  mesh.add_prism({{0, 0}, {edge, 0}, {edge, edge}, {0, edge}}, {{0, 1, 2}, {0, 2, 3}}, 0, edge);
  return mesh;
}

/// The top is cut at places where the walls have no corner; every other strip misses them by the gap.
Mesh cube_with_cut_top(double gap_m) {
  Mesh mesh;
  constexpr double e = 4;
  const std::vector<Vec3> floor = {{0, 0, 0}, {e, 0, 0}, {e, e, 0}, {0, e, 0}};
  for (size_t i = 0; i < 4; ++i) {
    const Vec3 up{0, 0, e};
    mesh.add_quad(floor[i], floor[(i + 1) % 4], floor[(i + 1) % 4] + up, floor[i] + up);
  }
  mesh.add_quad(floor[0], floor[3], floor[2], floor[1]);
  constexpr double cuts[] = {0, 0.7, 1.9, 3.3, e};
  for (size_t i = 0; i + 1 < std::size(cuts); ++i) {
    const double x0 = cuts[i], x1 = cuts[i + 1], gap = i % 2 == 0 ? 0 : gap_m;
    mesh.add_quad({x0, 0, e}, {x1, -gap, e}, {x1, e, e}, {x0, e + gap, e});
  }
  return mesh;
}

/// Points all around a solid and close to its surface.
std::vector<Vec3> points_around(const Mesh& mesh, uint64_t seed) {
  std::vector<Vec3> points = random_points(20000, seed, -2, 6);
  RandomStream random(seed, 4);
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 400; ++i) {
      // on the face, a side or a corner, then a little off it
      double u = random.uniform(), v = (1 - u) * random.uniform();
      if (i % 4 == 1) v = 0;
      if (i % 4 == 2) u = v = 0;
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      const double off = std::pow(10, -6 * random.uniform());
      points.push_back(a + (b - a) * u + (c - a) * v + random_point(random, -off, off));
    }
  return points;
}

template <class Inside>
void check_signs(const std::string& name, const Mesh& mesh, Inside inside, double from_m = 0) {
  const std::vector<Vec3> points = points_around(mesh, 31);
  const auto found = answers(*tree_of(mesh), points);
  size_t wrong = 0, within = 0, doubtful = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (found[i].distance < from_m) continue;
    const bool is_inside = inside(points[i]);
    wrong += found[i].is_behind != is_inside ? 1 : 0;
    within += is_inside ? 1 : 0;
    doubtful += found[i].side != TriangleSide::kCertain ? 1 : 0;
  }
  if (from_m == 0) CHECK(doubtful == 0);
  MESSAGE("FIGURE signs about a ", name, ": ", wrong, " wrong of ", points.size(), " (", within,
          " inside)");
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("triangle_nearest__equals_a_search_of_all_triangles") {
  const Mesh mesh = random_mesh(2000, 5);
  const auto tree = tree_of(mesh);
  CHECK(tree->size() == mesh.triangles.size());
  std::vector<Vec3> points = random_points(1000, 5, -5, 15);
  for (size_t t = 0; t < 500; ++t) {  // on triangles and within a hair of them
    const auto& k = mesh.triangles[4 * t];
    const Vec3 on = (mesh.vertices[k[0]] * 2 + mesh.vertices[k[1]] + mesh.vertices[k[2]]) * 0.25;
    points.push_back(on + Vec3{1e-3, -2e-3, 5e-4} * static_cast<double>(t % 3));
  }
  const auto found = answers(*tree, points);
  constexpr Real kStep_m = 4e-15L;  // two steps of a coordinate of ten metres
  Real worst = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    Real best = 1e30L;
    size_t first = 0;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Real d = brute_distance(mesh, t, points[i]);
      if (d < best - 1e-15L * (1 + best)) first = t;
      best = std::min(best, d);
    }
    const Real error = std::abs(found[i].distance - best);
    REQUIRE(error <= 1e-9L * best + kStep_m);
    if (best > 1e-4L) worst = std::max(worst, error / best);
    REQUIRE(std::abs(norm(found[i].foot - points[i]) - found[i].distance) < 1e-13);
    if (first < found[i].triangle)  // not the least number: then only by the last digits
      REQUIRE(brute_distance(mesh, first, points[i]) >= found[i].distance - 1e-14);
    if (found[i].triangle % 10 == 9 && found[i].triangle > 0)  // a duplicate never wins
      CHECK(mesh.triangles[found[i].triangle] != mesh.triangles[found[i].triangle - 1]);
  }
  MESSAGE("FIGURE distance to triangles, largest relative error above 0.1 mm: ",
          static_cast<double>(worst));
}

TEST_CASE("triangle_nearest__gives_ties_to_the_least_number") {
  const Mesh mesh = cube(4);
  const auto tree = tree_of(mesh);
  // Beyond each corner and each edge of the cube several triangles are equally far.
  for (const Vec3& beyond :
       {Vec3{5, 5.3, 6}, Vec3{-1, -0.7, -3}, Vec3{5, 4.1, -0.1}, Vec3{-0.3, 2.2, 4.7}}) {
    uint32_t least = 0;
    Real best = 1e30L;
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (const Real d = brute_distance(mesh, t, beyond); d < best) {
        best = d;
        least = t;
      }
    CHECK(tree->nearest(beyond).triangle == least);
  }
}

TEST_CASE("triangle_nearest__tells_inside_from_outside_everywhere") {
  check_signs("cube", cube(4), [](const Vec3& p) {
    return p.x > 0 && p.x < 4 && p.y > 0 && p.y < 4 && p.z > 0 && p.z < 4;
  });
  Mesh wedge;  // an edge of 6 degrees
  wedge.add_prism({{0, 0}, {4, 0}, {4, 0.42}}, {{0, 1, 2}}, 0, 4);
  check_signs("wedge", wedge, [](const Vec3& p) {
    return p.y > 0 && p.x < 4 && p.y * 4 < p.x * 0.42 && p.z > 0 && p.z < 4;
  });
  Mesh corner;  // an L-shaped solid: edges and corners that point inward
  corner.add_prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0, 4);
  check_signs("L-shaped solid", corner, [](const Vec3& p) {
    return p.x > 0 && p.y > 0 && p.x < 4 && p.y < 4 && (p.x < 1 || p.y < 1) && p.z > 0 && p.z < 4;
  });
}

TEST_CASE("triangle_nearest__tells_sides_where_corners_meet_sides") {
  const auto is_inside = [](const Vec3& p) {
    return p.x > 0 && p.x < 4 && p.y > 0 && p.y < 4 && p.z > 0 && p.z < 4;
  };
  check_signs("cube with a top cut otherwise", cube_with_cut_top(0), is_inside);
  // A gap is a hole to what lies deep in it.
  check_signs("cube whose top misses its walls by 0.2 um", cube_with_cut_top(2e-7), is_inside,
              0.06);
}

TEST_CASE("triangle_nearest__measures_to_the_border_of_a_hole") {
  Mesh frame;  // a square metre with a hole of half a metre: four strips, normals upward
  const std::vector<Vec3> out = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Vec3> in = {{0.25, 0.25, 0}, {0.75, 0.25, 0}, {0.75, 0.75, 0}, {0.25, 0.75, 0}};
  for (size_t i = 0; i < 4; ++i) frame.add_quad(out[i], out[(i + 1) % 4], in[(i + 1) % 4], in[i]);
  const auto tree = tree_of(frame);
  const TriangleAnswer middle = tree->nearest({0.5, 0.6, 0});
  CHECK(middle.distance == doctest::Approx(0.15).epsilon(1e-14).scale(0));
  CHECK(middle.feature == TriangleFeature::kSide);
  CHECK(middle.foot.y == 0.75);
  CHECK(middle.side == TriangleSide::kBorder);
  CHECK(tree->nearest({0.1, 0.1, 1}).side ==
        TriangleSide::kCertain);  // above the joint of two strips
  CHECK_FALSE(tree->nearest({0.5, 0.6, 0.1}).is_behind);
  CHECK(tree->nearest({0.5, 0.6, -0.1}).is_behind);
  CHECK(tree->nearest({-0.5, 1.6, -0.1}).is_behind);
}

TEST_CASE("triangle_nearest__says_where_triangles_run_opposite_ways_around") {
  Mesh mesh = cube(4);
  std::swap(mesh.triangles[2][1], mesh.triangles[2][2]);  // one half of the wall x = 4
  const auto tree = tree_of(mesh);
  const TriangleAnswer corner = tree->nearest({5, 5, 5}), face = tree->nearest({2, 2, 5});
  CHECK(corner.side == TriangleSide::kInconsistent);
  CHECK(face.side == TriangleSide::kCertain);
  CHECK_FALSE(face.is_behind);
  CHECK(tree->nearest({5, 3, 1}).is_behind);
}

TEST_CASE("triangle_nearest__the_limit_is_inclusive_and_nothing_near_is_no_failure") {
  const Mesh mesh = cube(4);
  const auto tree = tree_of(mesh);
  const std::vector<Vec3> points = {{2, 2, 4.3}, {2, 2, 7}, {2, 2, 7.000001}, {1e12, 0, 0}};
  const auto found = answers(*tree, points, 1, 3);
  CHECK(found[0].distance == doctest::Approx(0.3).epsilon(1e-14).scale(0));
  CHECK(found[1].distance == 3);
  CHECK(std::isnan(found[2].distance));
  CHECK(found[2].triangle == ~0u);
  CHECK(std::isnan(found[3].distance));
  CHECK(answers(*tree, points)[3].distance == doctest::Approx(1e12 - 4));
}

TEST_CASE("triangle_nearest__refuses_vertices_that_are_not_finite_and_takes_an_empty_mesh") {
  Mesh mesh = cube(1);
  mesh.vertices[7].y = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(tree_of(mesh), Error);
  const auto nothing = tree_of(Mesh{});
  CHECK(std::isnan(nothing->nearest({0, 0, 0}).distance));
  CHECK(std::isnan(answers(*nothing, {{1, 2, 3}})[0].distance));
}

TEST_CASE("triangle_nearest__same_bits_for_any_threads_instructions_and_whole_metre_shifts") {
  const Mesh mesh = random_mesh(40000, 9);  // more than one subtree
  const std::vector<Vec3> points = random_points(30000, 9, -5, 15);
  const auto tree = tree_of(mesh, 1);
  const auto reference = answers(*tree, points, 1);
  const auto same = [](const TriangleAnswer& a, const TriangleAnswer& b) {
    return std::memcmp(&a.distance, &b.distance, sizeof a.distance) == 0 &&
           a.triangle == b.triangle && a.is_behind == b.is_behind && a.feature == b.feature;
  };
  for (const unsigned threads : {2u, 4u}) {
    const auto again = answers(*tree_of(mesh, threads), points, threads);
    for (size_t i = 0; i < points.size(); ++i) REQUIRE(same(again[i], reference[i]));
  }
  const auto without_feet =
      answers(*tree, points, 2, std::numeric_limits<double>::infinity(), false);
  for (size_t i = 0; i < points.size(); ++i)
    REQUIRE((without_feet[i].distance == reference[i].distance &&
             without_feet[i].is_behind == reference[i].is_behind &&
             without_feet[i].side == reference[i].side));
  // One by one the baseline's instructions answer, and no answer bounds the next.
  for (size_t i = 0; i < points.size(); i += 7)
    REQUIRE(same(tree->nearest(points[i]), reference[i]));
  const Vec3 by{652000, 6861000, -40};
  std::vector<Vec3> far = points;
  for (Vec3& p : far) p += by;
  const auto shifted = answers(*tree_of(mesh.shifted(by)), far);
  for (size_t i = 0; i < points.size(); ++i) {
    REQUIRE(shifted[i].triangle == reference[i].triangle);
    REQUIRE(std::abs(shifted[i].distance - reference[i].distance) < 1e-8);
  }
}

// What a cancel has to wait for where very many triangles lie on one another: not for a chunk of points.
TEST_CASE("triangle_nearest__obeys_a_cancel_between_two_points") {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                  std::vector<std::array<uint32_t, 3>>(500, {0, 1, 2})};
  const auto tree = tree_of(mesh);
  const std::vector<double> xyz(3 * 1000, -1.0);
  std::vector<uint32_t> order(1000);
  std::iota(order.begin(), order.end(), 0u);
  std::atomic<bool> cancel{false};
  Task::Hooks hooks;
  hooks.threads = 1;
  hooks.cancel = &cancel;
  Task task(hooks);
  size_t answered = 0;
  CHECK_THROWS_AS(tree->for_each(xyz, order, 10.0, {true, true}, task,
                                 [&](uint32_t, const TriangleAnswer& answer) {
                                   CHECK(answer.triangle == 0);
                                   ++answered;
                                   cancel = true;
                                 }),
                  Error);
  CHECK(answered == 1);
}
