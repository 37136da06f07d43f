// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "geometry/cholesky.h"
#include "registration/targets/pattern_models.h"

namespace jalon {

/// Covariance of a pattern's unknowns, by White (1982): the slope of the scores about the sum of
/// their products. Edges of the model are as wide as the points are apart, true ones mostly
/// sharper; the products of the derivatives, which stand for the slope where a model is right, are
/// then too small by a third and the covariance more than twice too large.
///
/// Before: the model is the least squares fit to the points, more of them than unknowns. After: in
/// the model's units and order of unknowns, symmetric.
template <class Model>
class PatternCovariance {
 public:
  static constexpr size_t kK = Model::kUnknowns;

  /// Nothing when an unknown is not fixed. reach_m: of the points around the centre.
  static std::optional<Square<kK>> estimate(std::span<const BrightPoint> points, const Model& model,
                                            double reach_m) {
    Cholesky<kK> factor;
    if (!factor.factor(slope_of_scores(points, model, model.units(reach_m)))) return std::nullopt;
    return sandwich<kK>(factor.inverse(), products_of_scores(points, model));
  }

 private:
  static constexpr double kDifference = 0.01;  // of what an edge notices: slopes by differences

  static Coefficients<kK> scores_of(std::span<const BrightPoint> points, Model model,
                                    const Coefficients<kK>& step) {
    model.move(step);
    Coefficients<kK> out{}, j;
    for (const BrightPoint& p : points) {
      const double r = model.residual(p, j);
      for (size_t k = 0; k < kK; ++k) out[k] += r * j[k];
    }
    return out;
  }

  static Square<kK> slope_of_scores(std::span<const BrightPoint> points, const Model& model,
                                    const Coefficients<kK>& units) {
    Square<kK> out{};
    for (size_t c = 0; c < kK; ++c) {
      Coefficients<kK> forth{}, back{};
      forth[c] = kDifference * units[c], back[c] = -forth[c];
      const Coefficients<kK> after = scores_of(points, model, forth),
                             before = scores_of(points, model, back);
      for (size_t r = 0; r < kK; ++r) {
        const double half =
            (after[r] - before[r]) / (4 * forth[c]);  // the other half from its mirror image
        out[kK * r + c] += half, out[kK * c + r] += half;
      }
    }
    return out;
  }

  static Square<kK> products_of_scores(std::span<const BrightPoint> points, const Model& model) {
    Square<kK> out{};
    Coefficients<kK> j;
    for (const BrightPoint& p : points) {
      const double r = model.residual(p, j);
      for (size_t row = 0; row < kK; ++row)
        for (size_t c = 0; c < kK; ++c) out[kK * row + c] += r * r * j[row] * j[c];
    }
    const auto n = static_cast<double>(points.size());
    for (double& v : out) v *= n / (n - static_cast<double>(kK));
    return out;
  }
};

}  // namespace jalon
