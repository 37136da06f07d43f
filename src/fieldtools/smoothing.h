// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "fieldtools/field_values.h"

namespace jalon {

std::span<const ParamRow> field_filter_rows();

/// Normalised Gaussian mean (3.10) over the balls of cut_sigmas * sigma_m, by sorted position.
std::vector<double> gaussian_means(const ValuedPoints& valued, double sigma_m, double cut_sigmas, Task& task);

/// The cloud with what its neighbourhoods make of a field; see jalon/field_tools.h.
Cloud with_filtered_field(const Cloud& cloud, std::string_view field, const ParamSet& options, Task& task);

}  // namespace jalon
