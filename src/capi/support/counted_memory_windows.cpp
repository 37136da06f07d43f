// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/counted_memory.h"

namespace jalon::capi {

bool is_memory_counted() noexcept { return false; }

}  // namespace jalon::capi
