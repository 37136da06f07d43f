// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "segment/segmentation.h"

namespace jalon {

/// Parameters of method "coded_objects".
struct CodedModelSettings {
  double chord_m = 0.001;
  double gap_m = 0.25;
};
std::span<const ParamRow> coded_model_rows();

/// The objects of a segmentation by codes as a model (see coded_model.cpp for the steps).
Model model_coded_objects(const Segmentation& segmentation, const CodedModelSettings& settings,
                          Task& task);

}  // namespace jalon
