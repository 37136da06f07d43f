// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace jalon {

enum class KernelKind : uint8_t { kNone, kTukey, kCauchy, kHuber };

/// Weight of a residual (Huber & Ronchetti 2009; Holland & Welsch 1977): tuned to 95 % of the efficiency of least
/// squares where all noise is normal.
struct RobustKernel {
  KernelKind kind = KernelKind::kTukey;
  double sigma_m = 1;

  static constexpr double kTukeyCut = 4.685, kCauchyCut = 2.385, kHuberCut = 1.345;
  static constexpr double kEfficiency = 0.95;

  double weight(double residual_m) const {
    const double z = residual_m / sigma_m;
    switch (kind) {
      case KernelKind::kTukey: {
        const double v = 1 - z * z / (kTukeyCut * kTukeyCut);
        return v > 0 ? v * v : 0;
      }
      case KernelKind::kCauchy:
        return 1 / (1 + z * z / (kCauchyCut * kCauchyCut));
      case KernelKind::kHuber:
        return std::abs(z) <= kHuberCut ? 1 : kHuberCut / std::abs(z);
      case KernelKind::kNone:
        break;
    }
    return 1;
  }
  /// Of weight times residual.
  double slope(double residual_m) const {
    const double z = residual_m / sigma_m;
    switch (kind) {
      case KernelKind::kTukey: {
        const double u2 = z * z / (kTukeyCut * kTukeyCut), v = 1 - u2;
        return v > 0 ? v * (1 - 5 * u2) : 0;
      }
      case KernelKind::kCauchy: {
        const double u2 = z * z / (kCauchyCut * kCauchyCut), v = 1 + u2;
        return (1 - u2) / (v * v);
      }
      case KernelKind::kHuber:
        return std::abs(z) <= kHuberCut ? 1 : 0;
      case KernelKind::kNone:
        break;
    }
    return 1;
  }
};

}  // namespace jalon
