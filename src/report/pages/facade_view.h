// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "report/elevation/opening_list.h"
#include "report/pictures/label_raster.h"
#include "report/viewer/scene.h"
#include "segment/segmentation.h"

namespace jalon {

/// What the report of a facade or of segments shows in three dimensions: the points by segment in the colours of the
/// picture, by residual on the range of the residual chart, by intensity and colour; outlines of faces, and openings
/// with their sizes. half_range_m: of the residuals' chart.
ViewScene facade_scene(const Segmentation& segmentation, const Model& model,
                       const OpeningList& openings, double half_range_m, Task& task);
/// The same with the front view that rasterise_labels() gives.
ViewScene facade_scene(const Segmentation& segmentation, const Model& model,
                       const OpeningList& openings, double half_range_m, const LabelRaster& front,
                       Task& task);

}  // namespace jalon
