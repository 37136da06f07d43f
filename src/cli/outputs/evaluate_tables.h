// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/console.h"
#include "cli/lengths.h"
#include "cli/table.h"

namespace jalon::cli {

/// An evaluation for people and scripts.
struct EvaluationTables {
  explicit EvaluationTables(const jalon_evaluation* evaluation);
  void print(const Console& console, const Lengths& lengths) const;
  nlohmann::ordered_json json() const;

  Table pairs, automatic, reference, totals;

 private:
  void print_errors(const Console& console) const;
};

/// A confusion matrix for people and scripts.
struct ConfusionTables {
  void print(const Console& console) const;
  nlohmann::ordered_json json() const;

  Table classes, totals;
};

}  // namespace jalon::cli
