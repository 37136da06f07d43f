// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "base/params.h"
#include "capi/support/handles.h"
#include "segment/methods.h"
#include "segment/segmentation.h"

struct jalon_segmenter : jalon::capi::Counted {
  const jalon::SegmentMethod* method = nullptr;
  std::shared_ptr<jalon::ParamSet>
      values;  ///< shared with the jalon_params handles of this segmenter
};

struct jalon_segmentation : jalon::capi::Counted {
  jalon::SegmentationPtr segmentation;
};
