// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/params.h"
#include "base/task.h"
#include "report/pictures/label_raster.h"
#include "segment/segmentation.h"

namespace jalon {

/// Operation "picture".
struct PictureSettings {
  std::string title;
  PictureView view = PictureView::kFront;
  bool numbers = true;  ///< of the segments
};
std::span<const ParamRow> picture_rows();

/// The labelled points as an SVG figure: axes in metres, scale bar, numbers and legend of the segments; the points are
/// a PNG inside it.
std::string picture_svg(const Segmentation& segmentation, const PictureSettings& settings,
                        Task& task);
/// The same with the raster that rasterise_labels() gives for this view.
std::string picture_svg(const Segmentation& segmentation, const PictureSettings& settings,
                        LabelRaster raster, Task& task);
/// The points alone as a PNG file.
std::string picture_png(const Segmentation& segmentation, const PictureSettings& settings,
                        Task& task);

}  // namespace jalon
