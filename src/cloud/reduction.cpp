// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/operations.h"

namespace jalon {

Reduction reduction_of(uint64_t count_in, uint64_t count_out) {
  Reduction r;
  r.count_in = count_in;
  r.count_out = count_out;
  r.removed = count_in - count_out;
  if (count_in != 0)
    r.removed_percent = 100.0 * static_cast<double>(r.removed) / static_cast<double>(count_in);
  return r;
}

}  // namespace jalon
