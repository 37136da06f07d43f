// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/options.h"

namespace jalon::cli {

/// "--then": what is done with the distances once they are known, one operation after the other on the fields of the
/// compared points, each as "OPERATION name=value ...".
class FieldSteps {
 public:
  void add_to(Command& command);
  bool is_given() const { return !texts_.empty(); }
  /// Refuses what no operation takes, before anything long is run.
  void check() const;
  /// Runs them; fields are added to the cloud. reference: for the operation "distance_map". Gives back a list: of each
  /// its operation, its parameters and its tables, all as "--params" reads them.
  nlohmann::ordered_json run(const Console& console, const Cloud& cloud,
                             const Cloud& reference) const;
  /// The operations and their parameters, for --help.
  static std::string tables();

 private:
  std::vector<std::string> texts_;
};

}  // namespace jalon::cli
