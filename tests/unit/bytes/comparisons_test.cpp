// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/comparisons.h"

#include <doctest/doctest.h>

#include "unit/bytes/bytes_back.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using test::has_text;

Comparison two_distances() {
  Comparison c;
  c.cloud = std::make_shared<const Cloud>(test::cloud_of({{0, 0, 0}, {1, 0, 0}}));
  c.points.set(make_column<double>({"distance"}, std::vector<double>{0.25, NAN}));
  c.points.set(make_column<uint8_t>({"status"}, std::vector<uint8_t>{0, 4}));
  c.summary.set(make_column<uint64_t>({"points"}, std::vector<uint64_t>{2}));
  c.parameters_json = "{}";
  return c;
}

template <class F>
std::string comparison_back(F&& change, Comparison* out = nullptr) {
  Comparison from = two_distances();
  change(from);
  return test::bytes_back([&](ByteWriter& w) { write_comparison(w, from); },
                          [&](ByteReader& r, Task& task) {
                            Comparison back = read_comparison(r, task);
                            if (out != nullptr) *out = std::move(back);
                          });
}

TEST_CASE("comparison_bytes__bring_back_tables_and_points") {
  Comparison back;
  CHECK(comparison_back(
            [](Comparison& c) {
              c.parts.set(make_column<uint32_t>({"part"}, std::vector<uint32_t>{0, 1, 2}));
            },
            &back) == "");
  CHECK(back.cloud->size() == 2);
  CHECK(back.points.require("distance").values<double>()[0] == 0.25);
  CHECK(back.summary.require("points").values<uint64_t>()[0] == 2);
  CHECK(back.parts.require("part").count() == 3);
  CHECK(back.parameters_json == "{}");
}

TEST_CASE("comparison_bytes__whose_columns_code_could_not_read_are_refused") {
  CHECK(has_text(comparison_back([](Comparison& c) { c.points.remove("status"); }),
                 "no column \"status\""));
  CHECK(has_text(comparison_back([](Comparison& c) {
                   c.points.set(make_column<uint8_t>({"status"}, std::vector<uint8_t>{0, 6}));
                 }),
                 "a status that is none"));
  CHECK(has_text(comparison_back([](Comparison& c) {
                   c.points.set(make_column<double>({"normal"}, std::vector<double>{0, 1}));
                 }),
                 "float64 x 1, not of float64 x 3"));
  CHECK(has_text(comparison_back([](Comparison& c) {
                   c.points.set(make_column<double>({"difference_z"}, std::vector<double>{0, 1}));
                 }),
                 "not told along all three axes"));
  CHECK(has_text(comparison_back([](Comparison& c) {
                   c.summary.set(make_column<uint64_t>({"points"}, std::vector<uint64_t>{}));
                 }),
                 "0 rows where there must be 1"));
}

}  // namespace
}  // namespace jalon
