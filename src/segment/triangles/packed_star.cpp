// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/packed_star.h"

namespace jalon {

void StarWriter::add(uint32_t a, uint32_t b) {
  // Of a chain of one triangle either end may go on.
  if (chain_ == 2 && out_.back() != a && out_.back() != b) {
    uint32_t& before = out_[out_.size() - 2];
    if (before == a || before == b) std::swap(before, out_.back());
  }
  if (chain_ > 0 && (out_.back() == a || out_.back() == b)) {
    out_.push_back(out_.back() == a ? b : a);
    ++chain_;
    return;
  }
  if (chain_ > 0) out_.push_back(kNoPoint);
  out_.push_back(a);
  out_.push_back(b);
  chain_ = 2;
}

}  // namespace jalon
