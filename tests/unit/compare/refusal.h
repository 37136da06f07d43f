// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "base/error.h"

namespace jalon::test {

/// Whether f ends in an Error of this status whose text has these words.
template <class F>
bool refuses(F&& f, Status status, std::string_view words) {
  try {
    f();
  } catch (const Error& error) {
    const std::string_view text = error.what();
    return error.status() == status && text.find(words) != std::string_view::npos;
  }
  return false;
}

}  // namespace jalon::test
