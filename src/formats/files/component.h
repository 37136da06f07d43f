// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace jalon {

/// Where component k of the first point lies; nowhere in a table without points, which has no address to count from.
template <class T>
T* component(T* first, size_t k) {
  return first == nullptr ? nullptr : first + k;
}

}  // namespace jalon
