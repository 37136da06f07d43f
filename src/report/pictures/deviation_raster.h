// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "formats/drawings/pixels.h"
#include "report/pictures/deviation_picture.h"
#include "report/pictures/label_raster.h"

namespace jalon {

/// Axes of a picture of distances: to the right, up, and the one that it looks along; heights stay upright.
struct DeviationAxes {
  int right = 0, up = 1, into = 2;
  /// Plan: seen from above. Front and side: the eye at the low end of the axis looked along.
  Projection projection(const Vec3& origin) const;
  const char* right_name() const;
  const char* up_name() const;
};

DeviationAxes axes_of(const Comparison& comparison, DeviationView view, Task& task);

/// Labels of the points: the step of their colour and one, then that of hidden ones and, if so asked, that of those
/// without a significant distance; 0 of those without any.
LabelRaster deviation_raster(const Comparison& comparison, const DeviationScale& scale,
                             const Projection& projection, bool only_significant, Task& task);
/// In the colours of the scale, as those of hidden and other points.
IndexedImage deviation_image(const LabelRaster& raster, const DeviationScale& scale);

}  // namespace jalon
