// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/segmentation.h"

namespace jalon {

inline const char* orientation_name(Orientation orientation) {
  switch (orientation) {
    case Orientation::kParallel:
      return "parallel";
    case Orientation::kVertical:
      return "vertical";
    case Orientation::kHorizontal:
      return "horizontal";
    case Orientation::kInclined:
      return "inclined";
    case Orientation::kNone:
      break;
  }
  return "none";
}

}  // namespace jalon
