// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The forms of openings: their rings, borders and sizes say the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/evidence/opening_shape.h"

using namespace jalon;

namespace {

constexpr ShapeKind kAllKinds[] = {ShapeKind::kRectangle, ShapeKind::kTrapezium,
                                   ShapeKind::kTriangle,  ShapeKind::kGable,
                                   ShapeKind::kArch,      ShapeKind::kCircle};

OpeningShape random_shape(ShapeKind kind, RandomStream& random) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * random.uniform();
  };
  const double left = between(-5, 5), foot = between(-5, 5), width = between(0.5, 3),
               height = between(0.5, 3);
  OpeningShape out{kind, {left, left + width, foot, foot + height, 0, 0}};
  if (kind == ShapeKind::kTrapezium) {
    out.sizes[4] = left + between(-0.3, 0.4) * width;
    out.sizes[5] = left + between(0.6, 1.3) * width;
  }
  if (kind == ShapeKind::kTriangle) out.sizes[4] = left + between(0, 1) * width;
  if (kind == ShapeKind::kGable || kind == ShapeKind::kArch)
    out.sizes[4] = between(0.05, 1) * std::min(height, 1.5 * width);
  if (kind == ShapeKind::kCircle) out.sizes = {left, foot, width / 2, 0, 0, 0};
  return out;
}

template <class F>
void for_random_shapes(F&& f) {
  RandomStream random(11, 4);
  for (const ShapeKind kind : kAllKinds)
    for (int k = 0; k < 100; ++k) {
      const OpeningShape shape = random_shape(kind, random);
      CAPTURE(static_cast<int>(kind));
      CAPTURE(k);
      REQUIRE(shape.is_valid());
      f(shape);
    }
}

double span_area(const OpeningShape& shape) {
  constexpr int kSlices = 4000;
  const RingBox box = shape.box();
  const double slice = box.height() / kSlices;
  double sum = 0;
  for (int k = 0; k < kSlices; ++k) {
    const Vec2 span = shape.span_at(box.low.v + (k + 0.5) * slice);
    sum += (span.v - span.u) * slice;
  }
  return sum;
}

bool is_same_box(const RingBox& a, const RingBox& b, double within) {
  return norm(a.low - b.low) < within && norm(a.high - b.high) < within;
}

}  // namespace

TEST_CASE("opening_shape__the_ring_encloses_what_lies_between_the_borders") {
  for_random_shapes([](const OpeningShape& shape) {
    const double area = signed_area(shape.ring());
    CHECK(area > 0);
    CHECK(area == doctest::Approx(span_area(shape)).epsilon(1e-3));
    RingBox of_ring;
    of_ring.add(flattened(shape.ring(), 1e-5));
    CHECK(is_same_box(of_ring, shape.box(), 2e-5));
    CHECK(is_simple(shape.ring(), 0.01));
  });
}

TEST_CASE("opening_shape__points_between_the_borders_are_those_in_the_ring") {
  RandomStream random(12, 4);
  for_random_shapes([&](const OpeningShape& shape) {
    const std::vector<Vec2> polygon = flattened(shape.ring(), 1e-5);
    const RingBox box = shape.box();
    size_t differ = 0;
    for (int k = 0; k < 200; ++k) {
      const Vec2 p{box.low.u + box.width() * random.uniform(),
                   box.low.v + box.height() * random.uniform()};
      const Vec2 span = shape.span_at(p.v);
      const bool is_between = p.u >= span.u && p.u <= span.v;
      differ += is_between != contains(polygon, p) && border_distance(polygon, p) > 1e-4;
    }
    CHECK(differ == 0);
  });
}

TEST_CASE("opening_shape__placed_multiplies_and_moves_every_point") {
  const Vec2 by{3.5, -7};
  const double scale = 2.5;
  for_random_shapes([&](const OpeningShape& shape) {
    const OpeningShape moved = shape.placed(scale, by);
    REQUIRE(moved.is_valid());
    CHECK(signed_area(moved.ring()) == doctest::Approx(scale * scale * signed_area(shape.ring())));
    const RingBox box = shape.box();
    for (const double t : {0.1, 0.5, 0.9}) {
      const double v = box.low.v + t * box.height();
      const Vec2 before = shape.span_at(v), after = moved.span_at(v * scale + by.v);
      CHECK(after.u == doctest::Approx(before.u * scale + by.u));
      CHECK(after.v == doctest::Approx(before.v * scale + by.u));
    }
  });
}

TEST_CASE("opening_shape__grown_moves_every_side_outward_so_far_and_can_be_undone") {
  for_random_shapes([](const OpeningShape& shape) {
    const OpeningShape grown = shape.grown(0.1), back = grown.grown(-0.1);
    REQUIRE(grown.is_valid());
    for (size_t i = 0; i < shape.size_count(); ++i)
      CHECK(back.sizes[i] == doctest::Approx(shape.sizes[i]));
    const std::vector<Vec2> polygon = flattened(grown.ring(), 1e-4);
    double least = INFINITY;
    size_t outside = 0;
    for (const Vec2& p : flattened(shape.ring(), 1e-3)) {
      outside += !contains(polygon, p);
      least = std::min(least, border_distance(polygon, p));
    }
    CHECK(outside == 0);
    CHECK(std::fabs(least - 0.1) < 2e-4);
  });
}

TEST_CASE("opening_shape__grown_keeps_the_form_of_heads") {
  const OpeningShape round{ShapeKind::kArch, {0, 2, 0, 3, 1, 0}};  // a semicircle about (1, 2)
  const OpeningShape wider = round.grown(0.5);
  CHECK(wider.sizes[4] == doctest::Approx(1.5));
  CHECK(wider.sizes[3] - wider.sizes[4] == doctest::Approx(2));
  const OpeningShape gable{ShapeKind::kGable, {0, 2, 0, 3, 0.5, 0}};
  CHECK(gable.grown(0.5).sizes[4] / 3 == doctest::Approx(0.5 / 2));  // rise in widths
  const OpeningShape circle{ShapeKind::kCircle, {1, 1, 2, 0, 0, 0}};
  CHECK(circle.grown(-0.5).sizes[2] == doctest::Approx(1.5));
  CHECK_FALSE(circle.grown(-2).is_valid());
  CHECK_FALSE(round.grown(-1.01).is_valid());
}

TEST_CASE("opening_shape__known_areas_and_arcs") {
  const auto area_of = [](ShapeKind kind, std::array<double, 6> sizes) {
    return signed_area(OpeningShape{kind, sizes}.ring());
  };
  CHECK(area_of(ShapeKind::kRectangle, {1, 3, 1, 4}) == doctest::Approx(6));
  CHECK(area_of(ShapeKind::kTrapezium, {0, 4, 0, 2, 1, 3}) == doctest::Approx(6));
  CHECK(area_of(ShapeKind::kTriangle, {0, 4, 0, 2, 4}) == doctest::Approx(4));
  CHECK(area_of(ShapeKind::kGable, {0, 2, 0, 3, 1}) == doctest::Approx(5));
  CHECK(area_of(ShapeKind::kArch, {0, 2, 0, 3, 1}) == doctest::Approx(4 + M_PI / 2));
  CHECK(area_of(ShapeKind::kArch, {0, 2, 0, 1, 1}) == doctest::Approx(M_PI / 2));
  CHECK(area_of(ShapeKind::kCircle, {5, 5, 2}) == doctest::Approx(4 * M_PI));
  const auto arcs = [](ShapeKind kind, std::array<double, 6> sizes) {
    const OpeningShape shape{kind, sizes};
    const auto edges = shape.ring().edges;
    return std::count_if(edges.begin(), edges.end(), [](const VectorEdge& e) {
      return e.direction == EdgeDirection::kArc && e.sagitta_m > 0;
    });
  };
  CHECK(arcs(ShapeKind::kArch, {0, 2, 0, 3, 0.4}) == 1);
  CHECK(arcs(ShapeKind::kArch, {0, 2, 0, 3, 1.8}) == 2);  // pointed
  CHECK(arcs(ShapeKind::kCircle, {0, 0, 1}) == 4);
  CHECK(arcs(ShapeKind::kGable, {0, 2, 0, 3, 1}) == 0);
}

TEST_CASE("opening_shape__tells_sizes_that_are_no_shape") {
  const auto is_valid = [](ShapeKind kind, std::array<double, 6> sizes) {
    return OpeningShape{kind, sizes}.is_valid();
  };
  for (const ShapeKind kind : kAllKinds) {
    if (kind == ShapeKind::kCircle) continue;
    CHECK_FALSE(is_valid(kind, {2, 2, 0, 3, 0.5, 1}));  // no width
    CHECK_FALSE(is_valid(kind, {3, 2, 0, 3, 0.5, 1}));
    CHECK_FALSE(is_valid(kind, {0, 2, 3, 3, 0.5, 1}));  // no height
    CHECK_FALSE(is_valid(kind, {0, 2, 4, 3, 0.5, 1}));
    CHECK_FALSE(is_valid(kind, {0, NAN, 0, 3, 0.5, 1}));
  }
  for (const ShapeKind kind : {ShapeKind::kGable, ShapeKind::kArch}) {
    CHECK(is_valid(kind, {0, 2, 0, 3, 3}));  // no jambs
    CHECK_FALSE(is_valid(kind, {0, 2, 0, 3, 3.01}));
    CHECK_FALSE(is_valid(kind, {0, 2, 0, 3, 0}));
    CHECK_FALSE(is_valid(kind, {0, 2, 0, 3, -1}));
    CHECK_FALSE(is_valid(kind, {0, 1, 0, 9, 2.5}));  // a lance
  }
  CHECK_FALSE(is_valid(ShapeKind::kTrapezium, {0, 2, 0, 3, 1, 1}));
  CHECK_FALSE(is_valid(ShapeKind::kTrapezium, {0, 2, 0, 3, 1.5, 0.5}));
  CHECK_FALSE(is_valid(ShapeKind::kTriangle, {0, 2, 0, 3, 2.1}));
  CHECK_FALSE(is_valid(ShapeKind::kTriangle, {0, 2, 0, 3, -0.1}));
  CHECK_FALSE(is_valid(ShapeKind::kCircle, {0, 0, 0}));
  CHECK_FALSE(is_valid(ShapeKind::kCircle, {0, 0, -1}));
}

TEST_CASE("shape_in__gives_a_shape_of_each_kind_in_the_box") {
  for (const RingBox& box :
       {RingBox{{1, 2}, {3, 7}}, RingBox{{1, 2}, {9, 3}}, RingBox{{0, 0}, {4, 4}}})
    for (const ShapeKind kind : kAllKinds) {
      const OpeningShape shape = shape_in(kind, box);
      CHECK(shape.kind == kind);
      CHECK(shape.is_valid());
      CHECK(norm(shape.box().middle() - box.middle()) < 1e-12);
      if (kind != ShapeKind::kCircle) CHECK(is_same_box(shape.box(), box, 1e-12));
      if (kind == ShapeKind::kGable || kind == ShapeKind::kArch)
        CHECK(shape.sizes[4] <= box.height() / 2);
    }
}
