// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/model.h"

namespace jalon {

inline const char* evidence_name(Evidence evidence) {
  switch (evidence) {
    case Evidence::kMeasured:
      return "measured";
    case Evidence::kSeenBehind:
      return "seen behind";
    case Evidence::kRevealed:
      return "reveals measured";
    case Evidence::kShape:
      return "by its shape";
    case Evidence::kCopied:
      return "copied";
    case Evidence::kDerived:
      return "derived";
    case Evidence::kNone:
      break;
  }
  return "";
}

}  // namespace jalon
