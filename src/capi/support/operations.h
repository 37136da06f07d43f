// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"

namespace jalon::capi {

/// Operations with a parameter set that are no workers.
struct Operation {
  const char* name;
  std::span<const ParamRow> (*rows)();
};
std::span<const Operation> operations();

const char* last_error_text() noexcept;

}  // namespace jalon::capi
