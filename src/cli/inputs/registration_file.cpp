// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/registration_file.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "cli/text_file.h"

namespace jalon::cli {

namespace {

std::vector<double> numbers(const nlohmann::json& summary, const char* name, size_t count,
                            const std::string& path) {
  const auto found = summary.find(name);
  std::vector<double> out;
  if (found != summary.end() && found->is_array())
    for (const auto& value : *found)
      if (value.is_number()) out.push_back(value.get<double>());
  if (out.size() != count)
    throw Failure{
        JALON_ERROR_FORMAT,
        path + ": no " + name + " of " + std::to_string(count) +
            " numbers; a registration that leaves directions open has no covariance there"};
  return out;
}

}  // namespace

void use_registration_file(const std::string& path, jalon_params* params) {
  const auto json = nlohmann::json::parse(read_text_file(path), nullptr, false);
  if (!json.is_object() || !json.contains("summary") || !json["summary"].is_object())
    throw Failure{JALON_ERROR_FORMAT, path + ": not a registration.json of \"jalon register\""};
  const std::vector<double> covariance = numbers(json["summary"], "covariance", 36, path);
  const std::vector<double> centre = numbers(json["summary"], "centre", 3, path);
  must(jalon_params_set_doubles(params, "registration_covariance", covariance.data(),
                                covariance.size()));
  must(jalon_params_set_doubles(params, "registration_centre", centre.data(), centre.size()));
}

}  // namespace jalon::cli
