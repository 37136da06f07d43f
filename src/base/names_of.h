// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <iterator>

namespace jalon {

/// The names of a constant table's rows, in its order: an array that the compiler makes, so that C
/// can be handed it for as long as the library is loaded. table: an array of structs with a member
/// "const char* name".
template <const auto& table>
inline constexpr auto kNamesOf = [] {
  std::array<const char*, std::size(table)> names{};
  for (size_t i = 0; i < names.size(); ++i) names[i] = table[i].name;
  return names;
}();

}  // namespace jalon
