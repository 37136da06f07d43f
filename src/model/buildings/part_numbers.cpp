// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/part_numbers.h"

#include <limits>
#include <string>
#include <unordered_map>

#include "model/part_classes.h"

namespace jalon {

std::vector<PartNumbers> part_numbers(const Model& model) {
  constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
  std::unordered_map<std::string, uint32_t> next;
  std::vector<uint32_t> number;
  for (const Part& part : model.parts) number.push_back(next[part.part_class]++);
  std::vector<PartNumbers> made;
  for (uint64_t first = 0; first < model.parts.size(); ++first) {
    PartNumbers above{kNone, kNone, kNone};
    for (uint64_t p = first; p < model.parts.size(); p = model.parts[p].parent) {
      const std::string& part_class = model.parts[p].part_class;
      if (part_class == part_class::kBlock) above.block = number[p];
      if (part_class == part_class::kFacade) above.facade = number[p];
      if (part_class == part_class::kStrip) above.strip = number[p];
    }
    made.push_back(above);
  }
  return made;
}

}  // namespace jalon
