// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "fieldtools/noise_law.h"

namespace jalon {

/// Classes for n values, "theoretical maximum number" sqrt(n), from 2 to most.
uint32_t classes_for(size_t n, uint32_t most);

/// (3.1) over equally probable classes from the law: sum of (N_i - n P_i)^2 / (n P_i).
struct ChiSquareDistance {
  double distance = 0;
  uint32_t classes = 0;
  double p_value = 0;  ///< P(chi-square with classes - 1 degrees of freedom >= distance)
};
/// classes 0 = sqrt(n), at most 1 000. Values must be finite and not none.
ChiSquareDistance chi_square_distance(std::span<const double> values, const NoiseLaw& law,
                                      uint32_t classes, Task& task);

/// (3.2) as it is meant: s with upper tail Q(s) = error_margin at classes - 1 degrees of freedom.
double chi_square_threshold(uint32_t classes, double error_margin);

/// Of n values against m of a sample (m = 0: a law): reject above c(p) sqrt((n + m) / (n m)), c = sqrt(-ln(p / 2) / 2),
/// 1.36 at 5 %, 1.63 at 1 % (Smirnov 1939).
double kolmogorov_threshold(size_t n, uint64_t m, double error_margin);
/// sup |F_n - F| from the law's F at the n values, in place sorted.
double kolmogorov_distance(std::span<double> cumulative);

/// A neighbourhood of fewer values is not tested: three classes of three.
constexpr uint32_t kFewestTested = 9;

/// Of the local filter.
struct ChiSquareSettings {
  enum class Method { kChiSquare, kKolmogorov } method = Method::kChiSquare;
  uint32_t neighbours = 16;
  double radius_m = 0;  ///< above 0: in place of neighbours
  double error_margin = 0.001;
  enum class Classes { kEquiprobable, kRelaxed } classes = Classes::kEquiprobable;
  enum class Threshold { kTabulated, kEmpirical, kGiven } threshold = Threshold::kTabulated;
  double cut = 0;  ///< where it is given
  int passes = 2;
  uint32_t second_neighbours = 36;
  double band_low = 0.5, band_high = 3;  ///< of the second pass, in tabulated cuts
  bool one_sided = true;
  std::string name{};  ///< of the field of distances; empty: that of the method
  std::string changed = "changed";

  bool kolmogorov() const { return method == Method::kKolmogorov; }
  bool relaxed() const { return classes == Classes::kRelaxed; }
  std::string distance_field() const;
};
std::span<const ParamRow> chi_square_rows();

/// What the local filter found.
struct ChangeFilter {
  std::vector<double> distance;  ///< one a point of the cloud; NaN = not tested
  std::vector<uint8_t> changed;
  double threshold = 0;  ///< changed above it
  double ceiling = 0;    ///< what neighbourhoods far above the noise saturate at; infinite without
  uint64_t tested = 0, second_pass = 0, changed_count = 0;
};
/// Local filter (3.2.3); see jalon/field_tools.h. values: one a point.
ChangeFilter filter_changes(const Cloud& cloud, std::span<const double> values, const NoiseLaw& law,
                            const ChiSquareSettings& settings, Task& task);

}  // namespace jalon
