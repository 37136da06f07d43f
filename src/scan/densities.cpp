// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/densities.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kMostTimes = 1e6;

std::map<std::string, double, std::less<>> factors_of(std::string_view text) {
  std::map<std::string, double, std::less<>> factors;
  while (!text.empty()) {
    const std::string_view entry = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), entry.size() + 1));
    const size_t equals = entry.find('=');
    double factor = -1;
    if (equals == std::string_view::npos || equals == 0 ||
        !parse_number(entry.substr(equals + 1), factor) || !(factor >= 0 && factor <= kMostTimes))
      fail(Status::kInvalidArgument, "densities: \"%.60s\" is not class=factor",
           std::string(entry).c_str());
    factors[std::string(entry.substr(0, equals))] = factor;
  }
  return factors;
}

}  // namespace

std::vector<double> triangle_densities(const Model& model, const std::string& text) {
  std::vector<double> densities(model.triangles.size(), 1);
  const auto factors = factors_of(text);
  if (factors.empty()) return densities;
  for (const auto& [part_class, factor] : factors)
    if (std::none_of(model.parts.begin(), model.parts.end(),
                     [&wanted = part_class](const Part& p) { return p.part_class == wanted; }))
      fail(Status::kInvalidArgument, "densities: the model has no part of class \"%.60s\"",
           part_class.c_str());
  std::unordered_map<uint32_t, double> factor_of_face;
  for (const Face& face : model.faces)
    if (face.part < model.parts.size())
      if (const auto found = factors.find(model.parts[face.part].part_class);
          found != factors.end())
        factor_of_face[face.id] = found->second;
  for (size_t t = 0; t < densities.size(); ++t)
    if (const auto found = factor_of_face.find(model.triangle_faces[t]);
        found != factor_of_face.end())
      densities[t] = found->second;
  return densities;
}

}  // namespace jalon
