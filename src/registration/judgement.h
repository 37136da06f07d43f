// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace jalon {

/// Whether a pose may be used; the numbers of jalon/registrar.h.
enum class Verdict : uint8_t { kNone = 0, kAccepted = 1, kDoubtful = 2, kRefused = 3 };

struct PoseJudgement {
  Verdict verdict = Verdict::kNone;
  /// Probability that the pose is right; NaN where it was not measured.
  double confidence = std::numeric_limits<double>::quiet_NaN();
  std::string reasons;  ///< why it is not accepted: sentences, a line each

  void add_reason(const std::string& sentence) {
    if (!reasons.empty()) reasons += '\n';
    reasons += sentence;
  }
};

}  // namespace jalon
