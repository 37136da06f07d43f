// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/params.h"
#include "base/task.h"
#include "compare/comparison.h"
#include "report/pictures/deviation_colours.h"
#include "report/pictures/picture_marks.h"

namespace jalon {

enum class DeviationView { kAuto, kPlan, kFront, kSide };

/// Operation "deviation_picture".
struct DeviationPictureSettings {
  std::string title;  ///< "" = "Distances"
  DeviationView view = DeviationView::kAuto;
  double limit_m = 0;  ///< of the colour scale, which the caller makes; 0 = 98 % lie within
  /// Only points whose distance the comparison calls significant have its colour.
  bool only_significant = false;
  std::vector<PictureMark> marks{};  ///< drawn over the points of the figure
};
std::span<const ParamRow> deviation_picture_rows();

/// The compared points in the colours of their distances as an SVG figure: axes in metres, scale bar, colour scale with
/// its unit; hidden points pink, others without a value grey where nothing else lies.
std::string deviation_svg(const Comparison& comparison, const DeviationScale& scale,
                          const DeviationPictureSettings& settings, Task& task);
/// The points alone as a PNG file.
std::string deviation_png(const Comparison& comparison, const DeviationScale& scale,
                          const DeviationPictureSettings& settings, Task& task);

}  // namespace jalon
