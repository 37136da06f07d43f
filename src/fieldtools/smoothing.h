// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "fieldtools/field_values.h"

namespace jalon {

struct FieldFilterSettings {
  enum class Method { kGaussian, kMean, kMedian, kMinimum, kMaximum } method = Method::kGaussian;
  double sigma_m = 0;  ///< 0: from the spacing
  double cut_sigmas = 3;
  double radius_m = 0;  ///< 0: from the spacing, or k points
  uint32_t k = 0;       ///< above 0: in place of a ball
  std::string name = "filtered";
};
std::span<const ParamRow> field_filter_rows();

/// Normalised Gaussian mean (3.10) over the balls of cut_sigmas * sigma_m, by sorted position.
std::vector<double> gaussian_means(const ValuedPoints& valued, double sigma_m, double cut_sigmas,
                                   Task& task);

/// The cloud with what its neighbourhoods make of a field; see jalon/field_tools.h.
Cloud with_filtered_field(const Cloud& cloud, std::string_view field,
                          const FieldFilterSettings& settings, Task& task);

}  // namespace jalon
