// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "modelling/evaluation/area_indices.h"

using namespace jalon;

namespace {

// Boulaassal 2010, table 5.7: A, R, A n R in m2 as printed; then the columns recomputed from them, canonical.
struct Row {
  ComparedAreas areas;
  double completeness, correctness, quality, branching, miss, failure, omission;
};
constexpr Row kTable57[] = {
    {{27.07, 26.80, 26.60}, 0.993, 0.983, 0.975, 0.018, 0.008, 0.018, 0.007},
    {{27.03, 26.8, 26.52}, 0.990, 0.981, 0.971, 0.019, 0.011, 0.019, 0.010},
    {{27.15, 27.10, 26.69}, 0.985, 0.983, 0.968, 0.017, 0.015, 0.017, 0.015},
    {{27.03, 27.17, 26.91}, 0.990, 0.996, 0.986, 0.004, 0.010, 0.004, 0.010},
    {{0.65, 0.73, 0.60}, 0.822, 0.923, 0.769, 0.083, 0.217, 0.068, 0.178},
    {{2.97, 2.98, 2.83}, 0.950, 0.953, 0.907, 0.049, 0.053, 0.047, 0.050},
    {{4.80, 4.49, 4.34}, 0.967, 0.904, 0.877, 0.106, 0.035, 0.102, 0.033},
    {{4.54, 4.20, 3.91}, 0.931, 0.861, 0.810, 0.161, 0.074, 0.150, 0.069},
    {{62.72, 63.28, 62.47}, 0.987, 0.996, 0.983, 0.004, 0.013, 0.004, 0.013},
    {{4.07, 4.02, 3.92}, 0.975, 0.963, 0.940, 0.038, 0.026, 0.037, 0.025},
};
constexpr Row kMean57{{}, 0.959, 0.954, 0.919, 0.050, 0.046, 0.047, 0.041};
constexpr Row kStd57{{}, 0.052, 0.045, 0.077, 0.052, 0.064, 0.048, 0.052};
constexpr double kPrinted = 0.00051;  // three decimals

// Table 5.6: A, R, A n R; I/R, I/A, IoU.
constexpr double kTable56[10][6] = {
    {2.54, 2.56, 2.53, 0.988, 0.996, 0.984},    {2.52, 2.53, 2.51, 0.992, 0.996, 0.988},
    {2.54, 2.55, 2.53, 0.992, 0.996, 0.988},    {2.58, 2.56, 2.55, 0.996, 0.988, 0.985},
    {2.56, 2.53, 2.50, 0.988, 0.977, 0.965},    {2.47, 2.49, 2.47, 0.992, 1.000, 0.992},
    {2.47, 2.49, 2.47, 0.992, 1.000, 0.992},    {2.24, 2.25, 2.21, 0.982, 0.987, 0.969},
    {33.46, 33.38, 32.29, 0.967, 0.965, 0.935}, {96.37, 95.99, 95.80, 0.998, 0.994, 0.992}};

double number(const FieldTable& t, const char* name, size_t row = 0) {
  return t.require(name).number(row);
}

std::vector<ComparedAreas> areas57() {
  std::vector<ComparedAreas> out;
  for (const Row& row : kTable57) out.push_back(row.areas);
  return out;
}

}  // namespace

TEST_CASE("area_indices__give_the_recomputed_columns_of_table_5_7") {
  const FieldTable rows = index_table(areas57(), IndexFormulas::kCanonical),
                   totals = index_totals_table(areas57(), {}, IndexFormulas::kCanonical);
  double worst = 0;
  const auto near = [&](double found, double printed) {
    worst = std::max(worst, std::fabs(found - printed));
  };
  const char* names[] = {"completeness", "correctness", "quality", "branching",
                         "miss",         "failure",     "omission"};
  const auto columns = [](const Row& r) {
    return std::array<double, 7>{r.completeness, r.correctness, r.quality, r.branching,
                                 r.miss,         r.failure,     r.omission};
  };
  for (size_t k = 0; k < 7; ++k) {
    for (size_t i = 0; i < 10; ++i) near(number(rows, names[k], i), columns(kTable57[i])[k]);
    near(number(totals, ("mean_" + std::string(names[k])).c_str()), columns(kMean57)[k]);
    near(number(totals, ("std_" + std::string(names[k])).c_str()), columns(kStd57)[k]);
  }
  MESSAGE("FIGURE table 5.7: largest difference from the recomputed columns ", worst);
  CHECK(worst < kPrinted);
}

TEST_CASE("area_indices__give_the_recomputed_columns_of_table_5_6") {
  for (const auto& row : kTable56) {
    const AreaIndices found = area_indices({row[0], row[1], row[2]}, IndexFormulas::kCanonical);
    CHECK(std::fabs(found.completeness - row[3]) < kPrinted);
    CHECK(std::fabs(found.correctness - row[4]) < kPrinted);
    CHECK(std::fabs(found.quality - row[5]) < kPrinted);
  }
}

TEST_CASE("area_indices__follow_the_printed_formulas_when_asked") {
  // Row 1 as printed (truncated): rho_b 0.00 from R \ A = 0.126 of 26.60, rho_m 0.01, rho_f 0.02.
  const ComparedAreas areas{27.03, 26.726, 26.60};
  const AreaIndices printed = area_indices(areas, IndexFormulas::kThesis),
                    usual = area_indices(areas, IndexFormulas::kCanonical);
  CHECK(printed.branching == doctest::Approx(0.126 / 26.60));
  CHECK(printed.miss == doctest::Approx(0.43 / 26.60));
  CHECK(printed.branching == usual.miss);
  CHECK(printed.miss == usual.branching);
  CHECK(printed.failure == usual.failure);
  CHECK(printed.quality == usual.quality);
}

TEST_CASE("area_indices__keep_their_identities_and_tell_infinity") {
  const AreaIndices i = area_indices({5, 4, 3}, IndexFormulas::kCanonical);
  CHECK(i.quality == doctest::Approx(1 / (1 + i.branching + i.miss)).epsilon(1e-14));
  CHECK(i.completeness == doctest::Approx(1 / (1 + i.miss)).epsilon(1e-14));
  CHECK(i.correctness == doctest::Approx(1 / (1 + i.branching)).epsilon(1e-14));
  CHECK(i.omission == doctest::Approx(1 - i.completeness).epsilon(1e-14));
  const AreaIndices same = area_indices({7.3, 7.3, 7.3}, IndexFormulas::kCanonical);
  CHECK(same.completeness == 1);
  CHECK(same.quality == 1);
  CHECK(same.branching == 0);
  CHECK(same.miss == 0);
  CHECK(same.failure == 0);
  const AreaIndices apart = area_indices({2, 3, 0}, IndexFormulas::kCanonical);
  CHECK(apart.completeness == 0);
  CHECK(std::isinf(apart.branching));
  CHECK(std::isinf(apart.miss));
  const AreaIndices nothing = area_indices({0, 0, 0}, IndexFormulas::kCanonical);
  CHECK(std::isnan(nothing.completeness));
  CHECK(std::isnan(nothing.branching));
}

TEST_CASE("area_indices__refuse_impossible_areas") {
  CHECK_THROWS_AS(require_areas(std::vector<ComparedAreas>{{1, 1, 1.1}}), Error);
  CHECK_THROWS_AS(require_areas(std::vector<ComparedAreas>{{-1, 1, 0}}), Error);
  CHECK_THROWS_AS(require_areas(std::vector<ComparedAreas>{{1, std::nan(""), 0}}), Error);
  CHECK_NOTHROW(require_areas(areas57()));
}
