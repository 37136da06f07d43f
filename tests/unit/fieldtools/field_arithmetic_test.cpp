// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Computed fields: identities between operations, vectors with numbers, types, and what is left without a value.
#include <doctest/doctest.h>

#include <cmath>

#include "base/numbers.h"
#include "fieldtools/field_arithmetic.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Op = FieldArithmeticSettings::Operation;

// A cloud with "a" and "b" (doubles), "v" and "w" (vectors of floats) and "n" (small integers).
Cloud arithmetic_cloud(size_t size) {
  RandomStream random(1, 2);
  std::vector<double> a(size), b(size);
  std::vector<float> v(3 * size), w(3 * size);
  std::vector<int16_t> n(size);
  for (double& x : a) x = 4 * random.uniform() - 2;
  for (double& x : b) x = 4 * random.uniform() - 2;
  for (float& x : v) x = static_cast<float>(random.normal());
  for (float& x : w) x = static_cast<float>(random.normal());
  for (int16_t& x : n) x = static_cast<int16_t>(random.below(200)) - 100;
  Cloud out = cloud_of(random_points(size, 1, 3));
  out.fields.set(make_column<double>({"a"}, a));
  out.fields.set(make_column<double>({"b"}, b));
  out.fields.set(make_column<float>({"v", ElementType::kFloat32, 3}, v));
  out.fields.set(make_column<float>({"w", ElementType::kFloat32, 3}, w));
  out.fields.set(make_column<int16_t>({"n"}, n));
  return out;
}

Cloud with_op(const Cloud& cloud, Op operation, const char* a, const char* b, const char* name,
              double constant = 0) {
  FieldArithmeticSettings set;
  set.operation = operation;
  set.constant = constant;
  set.name = name;
  Task task;
  return with_computed_field(cloud, a, b, set, task);
}

double item(const Cloud& cloud, const char* name, size_t i, uint32_t component = 0) {
  return cloud.fields.require(name).number(i, component);
}

}  // namespace

TEST_CASE("with_computed_field__operations_that_undo_each_other_give_the_field_back") {
  Cloud c = arithmetic_cloud(500);
  c = with_op(with_op(c, Op::kAdd, "a", "b", "t"), Op::kSubtract, "t", "b", "sum_back");
  c = with_op(with_op(c, Op::kMultiply, "a", "b", "t"), Op::kDivide, "t", "b", "product_back");
  c = with_op(with_op(c, Op::kExp, "a", "", "t"), Op::kLog, "t", "", "log_back");
  c = with_op(with_op(c, Op::kSquare, "a", "", "t"), Op::kSqrt, "t", "", "root");
  c = with_op(c, Op::kAbsolute, "a", "", "size");
  c = with_op(with_op(c, Op::kMinimum, "a", "b", "low"), Op::kMaximum, "a", "b", "high");
  c = with_op(with_op(c, Op::kAdd, "low", "high", "t"), Op::kNegate, "t", "", "minus_both");
  for (size_t i = 0; i < 500; ++i) {
    // A few roundings of numbers below 4.
    CHECK(item(c, "sum_back", i) == doctest::Approx(item(c, "a", i)).scale(1).epsilon(1e-14));
    CHECK(item(c, "product_back", i) == doctest::Approx(item(c, "a", i)).epsilon(1e-14));
    CHECK(item(c, "log_back", i) == doctest::Approx(item(c, "a", i)).scale(1).epsilon(1e-14));
    CHECK(item(c, "root", i) == doctest::Approx(item(c, "size", i)).epsilon(1e-14));
    CHECK(item(c, "low", i) <= item(c, "high", i));
    CHECK(item(c, "minus_both", i) == -(item(c, "a", i) + item(c, "b", i)));
  }
}

TEST_CASE("with_computed_field__vectors_meet_vectors_numbers_and_constants_by_component") {
  Cloud c = arithmetic_cloud(200);
  c = with_op(c, Op::kMultiply, "v", "a", "scaled");
  c = with_op(c, Op::kSubtract, "v", "w", "difference");
  c = with_op(c, Op::kAdd, "v", "", "moved", 2.5);
  c = with_op(with_op(c, Op::kDot, "v", "w", "dot"), Op::kNorm, "v", "", "norm");
  c = with_op(c, Op::kAdd, "n", "a", "mixed");
  CHECK(c.fields.require("scaled").info().components == 3);
  CHECK(c.fields.require("dot").info().components == 1);
  for (size_t i = 0; i < 200; ++i) {
    double scalar = 0, squares = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      const double v = item(c, "v", i, k), w = item(c, "w", i, k);
      CHECK(item(c, "scaled", i, k) == v * item(c, "a", i));
      CHECK(item(c, "difference", i, k) == v - w);
      CHECK(item(c, "moved", i, k) == v + 2.5);
      scalar += v * w;
      squares += v * v;
    }
    CHECK(item(c, "dot", i) == doctest::Approx(scalar).scale(1).epsilon(1e-14));
    CHECK(item(c, "norm", i) == doctest::Approx(std::sqrt(squares)).epsilon(1e-14));
    CHECK(item(c, "mixed", i) == item(c, "n", i) + item(c, "a", i));
  }
}

TEST_CASE("with_computed_field__no_value_where_an_operand_has_none_or_there_is_no_answer") {
  Cloud c = cloud_of(random_points(5, 1, 3));
  c.fields.set(make_column<double>({"a"}, std::vector<double>{kNaN, 1, -1, 0, 3}));
  c.fields.set(make_column<double>({"b"}, std::vector<double>{1, kNaN, 2, 0, 0}));
  for (const Op op : {Op::kAdd, Op::kSubtract, Op::kMultiply, Op::kDivide, Op::kMinimum,
                      Op::kMaximum, Op::kDot}) {
    const Cloud out = with_op(c, op, "a", "b", "t");
    CHECK(std::isnan(item(out, "t", 0)));
    CHECK(std::isnan(item(out, "t", 1)));
    CHECK_FALSE(std::isnan(item(out, "t", 2)));
    for (const size_t by_zero : {size_t{3}, size_t{4}})
      CHECK(std::isnan(item(out, "t", by_zero)) == (op == Op::kDivide));
  }
  for (const Op op : {Op::kSqrt, Op::kLog, Op::kLog10})
    CHECK(std::isnan(item(with_op(c, op, "a", "", "t"), "t", 2)));
}

TEST_CASE("with_computed_field__replaces_a_field_of_its_name_and_tells_what_is_wrong") {
  const Cloud c = arithmetic_cloud(10);
  const Cloud out = with_op(c, Op::kAdd, "a", "", "a", 1);
  CHECK(out.fields.size() == c.fields.size());
  CHECK(item(out, "a", 3) == item(c, "a", 3) + 1);
  CHECK(out.fields.require("a").info().meaning.find("add of a") == 0);
  CHECK(refuses([&] { with_op(c, Op::kAdd, "a", "v", "t"); }, Status::kInvalidArgument,
                "1 and 3 components"));
  CHECK(refuses([&] { with_op(c, Op::kAdd, "a", "height", "t"); }, Status::kNotFound, "height"));
  CHECK(refuses([&] { with_op(c, Op::kAdd, "a", "b", ""); }, Status::kInvalidArgument, "name"));
}
