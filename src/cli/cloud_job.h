// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/options.h"

namespace jalon::cli {

/// From one cloud file to another: the options, the reading and the writing that convert, clean and normals share.
struct CloudJob {
  Common common;
  Input input;
  Settings settings;
  std::string output;

  /// The options; output_option is "output" (a position) or "-o,--output". --help lists the parameters of the operation
  /// behind the heading, then the examples.
  void add_to(Command& command, const char* output_option, const char* heading,
              const char* operation, const char* examples);
  Cloud read(Console& console) const;
  /// options: of operation "write", or NULL.
  void write(Console& console, const Cloud& cloud, const jalon_params* options) const;
  /// What --json tells of every such job.
  nlohmann::ordered_json result(const Cloud& cloud) const;
};

}  // namespace jalon::cli
