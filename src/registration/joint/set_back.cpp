// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/set_back.h"

namespace jalon {

bool hold_facades(const JointSolution& solution, std::vector<bool>& is_held) {
  constexpr double kRounding_m = 1e-9;
  bool is_same = true;
  for (size_t f = 0; f < is_held.size(); ++f) {
    const bool comes_forward = !is_held[f] && solution.facades[f] > kRounding_m,
               is_pulled_back = is_held[f] && solution.facade_pulls[f] < 0;
    if (comes_forward || is_pulled_back) is_held[f] = comes_forward, is_same = false;
  }
  return is_same;
}

}  // namespace jalon
