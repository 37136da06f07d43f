// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>

#include "base/printf_format.h"

namespace jalon {

/// The numbers of jalon/status.h; capi/guard.cpp asserts that they agree.
enum class Status : int32_t {
  kOk = 0,
  kInvalidArgument = -1,
  kOutOfMemory = -2,
  kCancelled = -3,
  kNotFound = -4,
  kInsufficientData = -5,
  kDegenerate = -6,
  kIo = -7,
  kFormat = -8,
  kUnsupported = -9,
  kCallback = -10,
  kBusy = -11,
  kLimit = -12,
  kInternal = -99,
};

/// A caller's fault or impossible data: one line of text, no redundancy. Only capi catches it.
class Error : public std::exception {
 public:
  Error(Status status, std::string text) : status_(status), text_(std::move(text)) {}
  Status status() const { return status_; }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  Status status_;
  std::string text_;
};

/// Throws an Error whose text is made as by printf, without locale-dependent conversions of numbers
/// (use %s, %d, %llu; doubles through text_of in base/text_number.h).
[[noreturn]] void fail(Status status, const char* format, ...) JALON_PRINTF(2, 3);

}  // namespace jalon
