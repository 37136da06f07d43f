// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/set_back.h"

namespace jalon {

bool HeldFacades::change(const JointSolution& solution) {
  constexpr double kRounding_m = 1e-9;
  constexpr int kPatience = 10;  // as Judice & Pires have it
  std::vector<size_t> wrong;
  for (size_t f = 0; f < is_held_.size(); ++f) {
    const bool comes_forward = !is_held_[f] && solution.facades[f] > kRounding_m,
               is_pulled_back = is_held_[f] && solution.facade_pulls[f] < 0;
    if (comes_forward || is_pulled_back) wrong.push_back(f);
  }
  if (wrong.size() < fewest_) fewest_ = wrong.size(), rounds_left_ = kPatience;
  else if (rounds_left_ > 0) --rounds_left_;
  else wrong.erase(wrong.begin(), wrong.end() - 1);
  for (const size_t f : wrong) is_held_[f] = !is_held_[f];
  return !wrong.empty();
}

}  // namespace jalon
