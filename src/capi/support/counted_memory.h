// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon::capi {

/// Does the library's allocator tell the budgets what it takes, in this build and this process?
bool is_memory_counted() noexcept;

}  // namespace jalon::capi
