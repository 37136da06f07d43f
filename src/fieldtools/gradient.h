// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "fieldtools/field_values.h"

namespace jalon {

enum class GradientMethod { kCorrected, kThesis, kLeastSquares };

struct GradientSettings {
  GradientMethod method = GradientMethod::kCorrected;
  double radius_m = 0;         ///< 0: from the spacing
  bool distance_field = true;  ///< slopes above 1 are left out
  std::string name = "gradient";
  std::string vector_name{};  ///< empty: none
};
std::span<const ParamRow> gradient_rows();

/// Gradients along the surface of values known at points (Girardeau-Montaut 2006, 3.3.2), by sorted position; NaN
/// where it is not known.
///
/// kThesis: (3.9), the mean of PP_i / |PP_i|^2 (f_i - f) over the ball of radius_m, which is half the gradient of a
/// plane's field; kCorrected: twice that; kLeastSquares: slopes of f over the tangent plane of the ball's points, right
/// at borders too. lipschitz: pairs that differ by more than their distance are left out (distance fields cannot).
std::vector<Vec3> field_gradients(const ValuedPoints& valued, double radius_m,
                                  GradientMethod method, bool lipschitz, Task& task);

/// The cloud with the field of the gradient's norm and, when asked, of the gradient itself; see jalon/field_tools.h.
Cloud with_gradient(const Cloud& cloud, std::string_view field, const GradientSettings& settings,
                    Task& task);

}  // namespace jalon
