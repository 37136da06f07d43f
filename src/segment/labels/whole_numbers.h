// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/field.h"

namespace jalon {

constexpr double kWholeDoubles = 0x1p53;  ///< beyond it not every whole number is a double

/// A scalar field of whole numbers, of any element type, as sortable keys. Left out (kNoKey) are the values given and
/// NaN; a fraction, or a number beyond int64 or 2^53 in a floating field, is Error(kInvalidArgument) that names the
/// point.
class WholeNumbers {
 public:
  WholeNumbers(const Column& column, std::span<const double> left_out);
  /// Keys of items [begin, end), ascending as the numbers are.
  void keys(size_t begin, size_t end, uint64_t* out) const;
  static uint64_t key_of(int64_t value) { return static_cast<uint64_t>(value) ^ kSign; }
  static int64_t value_of(uint64_t key) { return static_cast<int64_t>(key ^ kSign); }

 private:
  static constexpr uint64_t kSign = uint64_t{1} << 63;
  template <class T>
  uint64_t key(T value, size_t i) const;
  [[noreturn]] void refuse(size_t i, const char* why) const;
  const Column& column_;
  std::vector<uint64_t> left_out_;
};

}  // namespace jalon
