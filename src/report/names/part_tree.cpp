// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/names/part_tree.h"

namespace jalon {

PartTree::PartTree(const Model& model) : faces_(model.parts.size()) {
  const size_t n = model.parts.size();
  parents_.assign(n, kNoPart);
  std::vector<std::vector<uint32_t>> children(n);
  for (size_t i = 0; i < n; ++i)
    if (const uint64_t parent = model.parts[i].parent; parent < n && parent != i) {
      // Only a chain that does not come back to i may be hung above it.
      if (is_below(static_cast<uint32_t>(parent), static_cast<uint32_t>(i))) continue;
      parents_[i] = static_cast<uint32_t>(parent);
      children[parent].push_back(static_cast<uint32_t>(i));
    }
  std::vector<Step> stack;
  for (size_t i = n; i-- > 0;)
    if (parents_[i] == kNoPart) stack.push_back({static_cast<uint32_t>(i), 0});
  while (!stack.empty()) {
    const Step step = stack.back();
    stack.pop_back();
    walk_.push_back(step);
    const auto& below = children[step.part];
    for (size_t k = below.size(); k-- > 0;) stack.push_back({below[k], step.depth + 1});
  }
  for (size_t f = 0; f < model.faces.size(); ++f)
    if (model.faces[f].part < n) faces_[model.faces[f].part].push_back(f);
}

std::string part_label(const Model& model, uint64_t part) {
  if (part >= model.parts.size()) return "";
  const std::string& name = model.parts[part].name;
  return name.empty() ? "part " + std::to_string(part) : name;
}

}  // namespace jalon
