// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "modelling/edges/join/vectorise_setting.h"
#include "segment/segmentation.h"

namespace jalon {

/// Parameter table of method "outlines": VectoriseSetting.
std::span<const ParamRow> outlines_rows();
/// The 2D vector model of each planar segment (vectorise), put into space: one face with openings a connected piece.
Model model_outlines(const Segmentation& segmentation, const VectoriseSetting& setting, Task& task);

}  // namespace jalon
