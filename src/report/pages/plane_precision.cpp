// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/plane_precision.h"

#include <algorithm>
#include <cmath>

#include "cloud/precision.h"

namespace jalon {

PlanePrecision plane_precision(const PlaneFit& fit) {
  const Symmetric3& c = fit.local_covariance;  // of (alpha, beta, gamma): xx xy xz yy yz zz
  const double mean = (c[0] + c[3]) / 2, spread = std::hypot((c[0] - c[3]) / 2, c[1]);
  return {std::sqrt(std::max(mean + spread, 0.0)), std::sqrt(std::max(c[5], 0.0))};
}

std::vector<PropagatedPlane> scanner_planes(const Segmentation& segmentation, const Notes& notes,
                                            Task& task) {
  if (notes.scanner_json.empty()) return {};
  ParamSet params("precision", precision_rows());
  params.from_json(notes.scanner_json);
  return propagate_planes(segmentation, settings_from<ScannerPrecision>(params), task);
}

}  // namespace jalon
