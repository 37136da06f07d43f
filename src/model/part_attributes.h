// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace jalon {

/// A number that is told of a part beside what Part has, as files name it: its unit is in the name.
struct PartAttribute {
  std::string name;
  double value = 0;
  bool is_whole = false;  ///< a number of things, or of one of them
};

/// Of each part of a model; goes beside the model to formats that have attributes.
struct PartAttributes {
  std::vector<std::vector<PartAttribute>> of_part;

  void add(uint32_t part, const char* name, double value) {
    of_part[part].push_back({name, value, false});
  }
  void add_whole(uint32_t part, const char* name, uint64_t value) {
    of_part[part].push_back({name, static_cast<double>(value), true});
  }
};

}  // namespace jalon
